// Memory of a long drive: what the record holds, and whether anything else grows.
// Usage: memory_bench [--hours 24] [--json]
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "bench/figures.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kMega = 1e6;

double resident_mb() {
  std::ifstream status("/proc/self/statm");
  double pages = 0.0;
  double resident = 0.0;
  status >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMega;
}

// Laps of two rows, for so long that `hours` run out first.
Path laps(const Vehicle& vehicle, double hours) {
  constexpr double kRow_m = 80.0;
  const double radius_m = 1.2 * planning_turning_radius_m(vehicle);
  Path path;
  double length_m = 0.0;
  while (length_m < hours * 3600.0 * vehicle.driver.work_speed_mps) {
    test::extend(path, PathKind::kSwath, Gear::kForward, true, kRow_m, 0.0);
    test::extend(path, PathKind::kUTurn, Gear::kForward, false, std::numbers::pi * radius_m,
                 1.0 / radius_m);
    length_m += kRow_m + std::numbers::pi * radius_m;
  }
  return path;
}

std::vector<bench::Figure> measure(double hours) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.battery.capacity_ah *= 1000.0;  // no charging in between
  const Heightfield terrain = test::hills(1.0, 30.0);
  const Field field = test::open_field();
  const SoilMap soil = test::textbook_soil();
  const Path path = laps(vehicle, hours);
  SimulationOptions options;
  options.max_time_s = hours * 3600.0;
  const double before_mb = resident_mb();
  double first_minute_mb = 0.0;
  double last_mb = 0.0;
  const auto start = std::chrono::steady_clock::now();
  const RunRecord run = simulate(
      {field, terrain, soil, vehicle, path, options, [&](const SimulationProgress& progress) {
         last_mb = resident_mb();
         if (progress.time_s < 60.0) first_minute_mb = last_mb;
         return true;
       }});
  const double spent_s = bench::seconds_since(start);
  const auto bytes = [](const auto& rows) {
    return static_cast<double>(rows.size() * sizeof(rows.front()));
  };
  const double record_mb =
      (bytes(run.samples) + bytes(run.footprints) + bytes(run.segments)) / kMega;
  return {{"simulated time", run.duration_s / 3600.0, "h", ""},
          {"wall time", spent_s, "s", ""},
          {"resident before the drive (path, terrain)", before_mb, "MB", ""},
          {"resident more after a minute (route, world)", first_minute_mb - before_mb, "MB", ""},
          {"record: samples, footprints, segments", record_mb, "MB", ""},
          {"resident more since that minute, less the record",
           last_mb - first_minute_mb - record_mb, "MB", "<= 1"}};
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  double hours = 24.0;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::string_view(argv[i]) == "--hours") hours = std::strtod(argv[i + 1], nullptr);
  }
  headland::bench::print(headland::measure(hours), headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

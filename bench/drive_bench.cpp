// Speed and truth of a whole drive: real-time factor, closed forms, brake hold.
// Usage: drive_bench [--json]
#include <cmath>
#include <cstdlib>

#include "bench/figures.h"
#include "bench/textbook_vehicle.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRate_hz = 240.0;

void add_speed(std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::hills(1.0, 25.0);
  const SoilMap soil = test::textbook_soil();
  const Path path = test::rows_with_omega_turns(12, 40.0, 2.0, planning_turning_radius_m(vehicle));
  const Field field = test::open_field();
  constexpr int kRuns = 9;
  std::vector<double> factor;
  for (int i = 0; i < kRuns; ++i) {
    const double start_s = bench::cpu_seconds();
    const RunRecord run = simulate({field, terrain, soil, vehicle, path, {}, {}});
    factor.push_back(run.duration_s / (bench::cpu_seconds() - start_s));
  }
  figures.push_back({"drive without coverage, times real time, 240 Hz, one core",
                     bench::median(factor), "x", ">= 1000"});
}

double energy_per_metre(const Vehicle& vehicle, double slope) {
  const RunRecord run =
      test::run(test::straight(120.0), vehicle, test::plane(slope, 0.0), test::textbook_soil());
  double power_w = 0.0;
  double speed_mps = 0.0;
  for (std::size_t i = run.samples.size() / 2; i < run.samples.size() * 3 / 4; ++i) {
    power_w += run.samples[i].battery_power_w;
    speed_mps += run.samples[i].speed_mps;
  }
  return power_w / speed_mps;
}

void add_closed_forms(std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = bench::textbook_vehicle();
  const double weight_n = total_mass_kg(vehicle) * kGravity_mps2;
  const double flat = energy_per_metre(vehicle, 0.0) / (0.05 * weight_n / 0.8) - 1.0;
  const double slope_rad = std::atan(0.1);
  const double climb = energy_per_metre(vehicle, 0.1) /
                           (weight_n * (0.05 * std::cos(slope_rad) + std::sin(slope_rad)) / 0.8) -
                       1.0;
  figures.push_back({"flat J/m over Crr m g / efficiency, less 1", 100.0 * flat, "%", "<= 0.1"});
  figures.push_back({"10 % climb J/m over its formula, less 1 (slip)", 100.0 * climb, "%", "<= 2"});
}

void add_brake_hold(std::vector<bench::Figure>& figures) {
  const test::ParkedVehicle parked = test::park(load_vehicle("transplanter"), 0.2, kRate_hz);
  figures.push_back({"drift braked on a 20 % slope", parked.drift_mm_per_min, "mm/min", "<= 0.1"});
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  std::vector<headland::bench::Figure> figures;
  headland::add_speed(figures);
  headland::add_closed_forms(figures);
  headland::add_brake_hold(figures);
  headland::bench::print(figures, headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

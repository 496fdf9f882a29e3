// How well every built-in vehicle keeps to the path, what the ledger leaves over and what the step
// costs, over the physics' rate: the user chooses the step knowing the price. With --turns instead
// turns without jumps of curvature beside plain ones.
// Usage: tracking_bench [VEHICLE..] [--turns] [--json]
#include <cstdlib>

#include "bench/figures.h"
#include "planner/drivable_path.h"
#include "planner/planned_vehicle.h"
#include "planner/planners.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRates_hz[] = {60.0, 120.0, 240.0, 500.0, 1000.0};

struct Ground {
  const char* name;
  Heightfield terrain;
};

void add_drive(const std::string& name, const Ground& ground, double rate_hz,
               std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = load_vehicle(name);
  const Path path = test::rows_for(vehicle, 6, 60.0);
  SimulationOptions options;
  options.rate_hz = rate_hz;
  const double start_s = bench::cpu_seconds();
  const RunRecord run =
      test::run(path, vehicle, ground.terrain, test::textbook_soil(0.6, 0.07), options);
  const double spent_s = bench::cpu_seconds() - start_s;
  const test::TrackingError error = test::tracking_error(path, run);
  const auto add = [&](const char* what, double value, const char* unit, const char* target) {
    figures.push_back({fmt::format("{}, {}, {:.0f} Hz: {}", name, ground.name, rate_hz, what),
                       value, unit, target});
  };
  double driven_m = 0.0;
  for (const SegmentRecord& segment : run.segments) driven_m += segment.distance_m;
  add("driven of the path", 100.0 * driven_m / length_m(path), "%", "");
  add("rows rms", 100.0 * error.rows_m, "cm", "<= 3");
  add("turns rms", 100.0 * error.turns_m, "cm", "<= 15");
  add("worst on rows", 100.0 * std::abs(run.peaks.cross_track_working_m.value), "cm", "<= 20");
  add("worst in turns", 100.0 * std::abs(run.peaks.cross_track_turning_m.value), "cm", "<= 20");
  const double residual_j = test::cause_j(run.energy, EnergyCause::kResidual);
  add("ledger residual", 100.0 * std::abs(residual_j) / run.energy.battery_j, "%", "<= 0.01");
  add("battery energy", run.energy.battery_j / 3600.0, "Wh", "");
  add("times real time", run.duration_s / spent_s, "x", rate_hz == 240.0 ? ">= 1000" : "");
}

void add_parking(const std::string& name, double rate_hz, std::vector<bench::Figure>& figures) {
  const test::ParkedVehicle parked = test::park(load_vehicle(name), 0.2, rate_hz);
  figures.push_back({fmt::format("{}, parked on 20 %, {:.0f} Hz: drift", name, rate_hz),
                     parked.drift_mm_per_min, "mm/min", "<= 0.1"});
}

// The same rows with what receivers and steering valves have.
void add_imperfections(const std::string& name, std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = load_vehicle(name);
  const Path path = test::rows_for(vehicle, 6, 60.0);
  const Heightfield terrain = test::hills(1.0, 30.0, 120.0);
  const auto add = [&](const char* what, const SimulationOptions& options, const char* target) {
    const RunRecord run =
        test::run(path, vehicle, terrain, test::textbook_soil(0.6, 0.07), options);
    figures.push_back({fmt::format("{}, hills, {}: rows rms", name, what),
                       100.0 * test::tracking_error(path, run).rows_m, "cm", target});
  };
  for (const double noise_time_s : {1.0, 10.0, 100.0}) {
    SimulationOptions options;
    options.positioning.noise_m = 0.02;
    options.positioning.noise_time_s = noise_time_s;
    add(fmt::format("2 cm noise over {:.0f} s", noise_time_s).c_str(), options, "<= 5");
  }
  SimulationOptions late;
  late.positioning.latency_s = 0.1;
  late.steering_latency_s = 0.2;
  add("positions 0.1 s and steering 0.2 s late", late, "<= 3");
}

// A field with slanted ends on level firm ground, planned and driven with plain turns and with
// continuous ones.
void add_turns(const std::string& name, std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = load_vehicle(name);
  if (vehicle.steering.kind == SteeringKind::kSkid) return;
  const PlannerEntry& planner = find_planner("boustrophedon", "bench");
  PlanRequest request;
  request.field.boundary = {{0.0, 0.0}, {120.0, 0.0}, {120.0, 80.0}, {0.0, 70.0}};
  set_vehicle(request, vehicle);
  request.parameters = resolve_parameters(planner.parameters, {}, "bench", "planner");
  const Plan plan = planner.plan(request);
  for (const bool continuous : {false, true}) {
    PathOptions options;
    options.continuous_turns = continuous;
    const Path path = make_path(request.field, vehicle, plan, options);
    const RunRecord run = test::run(path, vehicle, test::plane(0.0, 0.0),
                                    test::textbook_soil(0.6, 0.07), {}, request.field);
    const auto add = [&](const char* what, double value, const char* unit) {
      figures.push_back(
          {fmt::format("{}, {} turns: {}", name, continuous ? "continuous" : "plain", what), value,
           unit, ""});
    };
    add("rms", 1000.0 * test::tracking_error(path, run).turns_m, "mm");
    add("worst", 1000.0 * std::abs(run.peaks.cross_track_turning_m.value), "mm");
    add("path", length_m(path), "m");
    add("time", run.duration_s, "s");
    if (continuous) add("with jumps", path.abrupt_turns, "");
  }
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  using namespace headland;
  std::vector<bench::Figure> figures;
  const Ground grounds[] = {{"flat", test::plane(0.0, 0.0)},
                            {"hills", test::hills(1.0, 30.0, 120.0)},
                            {"20 % side slope", test::plane(0.0, 0.2)},
                            {"hills on 12 % side slope", test::hillside(0.12, 0.8, 40.0)}};
  std::vector<std::string> vehicles(argv + 1, argv + argc);
  std::erase(vehicles, "--json");
  const bool turns = std::erase(vehicles, "--turns") > 0;
  if (vehicles.empty()) vehicles = vehicle_names();
  for (const std::string& name : vehicles) {
    if (turns) {
      add_turns(name, figures);
      continue;
    }
    for (const Ground& ground : grounds) {
      for (const double rate_hz : kRates_hz) add_drive(name, ground, rate_hz, figures);
    }
    for (const double rate_hz : kRates_hz) add_parking(name, rate_hz, figures);
    add_imperfections(name, figures);
  }
  bench::print(figures, bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

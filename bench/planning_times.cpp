#include "bench/planning_times.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "bench/figures.h"
#include "evaluate/scenario.h"
#include "planner/planners.h"
#include "terrains/field_source.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {
namespace {

constexpr int kLargestOptimised = 4000;  // more take minutes in all that is near each swath
constexpr double kSwath_m = 300.0;
constexpr char kGartner[] = HEADLAND_SOURCE_DIR "/../shared/data/gartner/boundary.geojson";

// About `swaths` of 2 m across a strip whose sides wave, with a hole every 50 swaths.
Field strip_field(int swaths) {
  const double length_m = 2.0 * swaths;
  constexpr double kWave_m = 200.0;
  const int steps = std::max(4, static_cast<int>(length_m / 20.0));
  Field field;
  field.name = fmt::format("{} swaths", swaths);
  const auto side = [&](int i, double y_m, double sign) {
    const double x_m = length_m * i / steps;
    field.boundary.emplace_back(x_m, y_m + sign * 10.0 * std::sin(x_m / kWave_m));
  };
  for (int i = 0; i <= steps; ++i) side(i, 0.0, 1.0);
  for (int i = steps; i >= 0; --i) side(i, kSwath_m, -1.0);
  for (double x_m = 50.0; x_m < length_m - 40.0; x_m += 100.0) {
    field.holes.push_back({{x_m, 140.0}, {x_m, 160.0}, {x_m + 15.0, 155.0}, {x_m + 15.0, 140.0}});
  }
  check_field(field, field.name);
  return field;
}

struct Timed {
  double plan_s = 0.0;
  double path_s = 0.0;  // making it drivable
  std::size_t swaths = 0;
};

Timed timed(const Field& field, const std::string& vehicle, const Parameters& parameters,
            bool drivable) {
  Scenario scenario;
  scenario.vehicle = vehicle;
  const PlannerEntry& planner = find_planner(scenario.planner.name, "bench");
  scenario.planner.parameters =
      resolve_parameters(planner.parameters, parameters, "bench", "planner");
  Stage stage;
  stage.field = field;
  stage.vehicle = load_vehicle(vehicle);
  Timed result;
  auto begun = std::chrono::steady_clock::now();
  const Plan plan = planner.plan(plan_request(scenario, stage));
  result.plan_s = seconds_since(begun);
  result.swaths =
      static_cast<std::size_t>(std::ranges::count(plan.passes, PassKind::kSwath, &Pass::kind));
  if (!drivable) return result;
  begun = std::chrono::steady_clock::now();
  make_path(stage.field, stage.vehicle, plan, scenario.path);
  result.path_s = seconds_since(begun);
  return result;
}

void add_size(int swaths, std::vector<Figure>& figures) {
  const Field field = strip_field(swaths);
  const auto add = [&](const std::string& name, double value, const char* unit,
                       const char* target) {
    figures.push_back(
        {fmt::format("{} swaths: {}", swaths, name), value, unit, swaths == 2000 ? target : ""});
  };
  const Timed across = timed(field, "transplanter", {{"swath_direction_deg", 90.0}}, true);
  add("laid out", static_cast<double>(across.swaths), "swaths", "");
  add("planned and ordered", across.plan_s, "s", "< 5");
  add("made drivable", across.path_s, "s", "");
  if (swaths <= kLargestOptimised) {
    const Timed optimised =
        timed(field, "transplanter",
              {{"swath_direction_deg", 90.0}, {"swath_order", std::string("optimised")}}, false);
    add("planned, order optimised", optimised.plan_s, "s", "< 5");
  }
  add("peak of memory so far", peak_memory_bytes() / 1e9, "GB", "< 1");
}

}  // namespace

void print_planning_times(bool as_json) {
  std::vector<Figure> figures;
  for (const int swaths : {100, 200, 500, 1000, 2000, 5000, 10000}) {
    std::fprintf(stderr, "%d swaths\n", swaths);
    add_size(swaths, figures);
  }
  if (std::filesystem::exists(kGartner)) {
    FieldSource source;
    source.file = kGartner;
    const Timed gartner = timed(read_field(source, "bench"), "utility_tractor", {}, true);
    figures.push_back({"Gartner: planned, best direction", gartner.plan_s, "s", "< 2"});
    figures.push_back({"Gartner: made drivable", gartner.path_s, "s", ""});
  } else {
    std::fprintf(stderr, "polygon_bench: %s is not there, the Gartner field is left out\n",
                 kGartner);
  }
  print(figures, as_json);
}

}  // namespace headland::bench

#include "bench/planning_times.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/figures.h"
#include "evaluate/scenario.h"
#include "planner/planners.h"
#include "terrains/field_source.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {
namespace {

constexpr double kSwath_m = 300.0;

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
  double length_m = 0.0;
  std::size_t swaths = 0;
};

// Of this thread alone.
Timed timed(const Field& field, const std::string& vehicle, const Parameters& parameters) {
  Scenario scenario;
  scenario.vehicle = vehicle;
  const PlannerEntry& planner = find_planner(scenario.planner.name, "bench");
  scenario.planner.parameters =
      resolve_parameters(planner.parameters, parameters, "bench", "planner");
  Stage stage;
  stage.field = field;
  stage.vehicle = load_vehicle(vehicle);
  Timed result;
  double begun_s = cpu_seconds();
  const Plan plan = planner.plan(plan_request(scenario, stage));
  result.plan_s = cpu_seconds() - begun_s;
  result.swaths =
      static_cast<std::size_t>(std::ranges::count(plan.passes, PassKind::kSwath, &Pass::kind));
  begun_s = cpu_seconds();
  const Path path = make_path(stage.field, stage.vehicle, plan, scenario.path);
  result.path_s = cpu_seconds() - begun_s;
  result.length_m = length_m(path);
  return result;
}

void add_times(const Field& field, const std::string& vehicle, Parameters parameters, double most_s,
               std::vector<Figure>& figures) {
  const std::string target = most_s > 0.0 ? fmt::format("< {:g}", most_s) : "";
  for (const std::string order : {"boustrophedon", "optimised"}) {
    parameters["swath_order"] = order;
    const Timed took = timed(field, vehicle, parameters);
    const auto add = [&](const std::string& what, double value, const char* unit,
                         const std::string& wanted = "") {
      figures.push_back({fmt::format("{}, {}: {}", field.name, order, what), value, unit, wanted});
    };
    add("laid out", static_cast<double>(took.swaths), "swaths");
    add("planned and ordered", took.plan_s, "s", target);
    add("made drivable", took.path_s, "s", target);
    add("length of the path", 1e-3 * took.length_m, "km");
  }
  figures.push_back({fmt::format("{}: peak of memory so far", field.name),
                     peak_memory_bytes() / 1e9, "GB", "< 1"});
}

}  // namespace

void print_planning_times(const TimesAsked& asked) {
  std::vector<Figure> figures;
  for (const int swaths : asked.swaths) {
    std::fprintf(stderr, "%d swaths\n", swaths);
    add_times(strip_field(swaths), "transplanter", {{"swath_direction_deg", 90.0}},
              swaths == 2000 ? 5.0 : 0.0, figures);
  }
  for (const std::string& file : asked.files) {
    FieldSource source;
    source.file = file;
    add_times(read_field(source, "bench"), "utility_tractor", asked.parameters, 2.0, figures);
  }
  print(figures, asked.json);
}

}  // namespace headland::bench

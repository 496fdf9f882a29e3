#include "bench/field_suite_rows.h"

#include <algorithm>

#include "bench/figures.h"
#include "evaluate/reachable_ground.h"
#include "planner/planners.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {
namespace {

constexpr double kMostCells = 2e7;  // of the coverage raster
constexpr double kLeastCell_m = 0.1;
constexpr double kMostCell_m = 0.25;

void judge_path(const SuiteField& made, SuiteRow& row) {
  const Field& field = made.stage.field;
  const Audit audit =
      audit_path(field, made.stage.vehicle, lines_of(made.path), coverage_cell_m(field));
  const auto totals = [&](AuditFault fault) {
    return audit.totals[static_cast<std::size_t>(fault)];
  };
  row.faults = audit.places;
  row.left_out = made.path.left_out;
  row.length_m = audit.length_m;
  row.work_m = audit.working_length_m;
  row.states_outside = totals(AuditFault::kOutside).states + totals(AuditFault::kInHole).states +
                       totals(AuditFault::kInObstacle).states;
  row.other_faults = static_cast<std::size_t>(totals(AuditFault::kTooTight).places +
                                              totals(AuditFault::kJump).places);
  row.field_m2 = audit.coverage.workable_m2;
  row.overlap_m2 = audit.coverage.overlap_m2;
  row.outside_m2 = audit.coverage.outside_m2;
  const CoverageRaster reachable =
      reachable_part(audit.raster, field, made.stage.vehicle, made.scenario.path.clearance_m);
  const CoverageFigures figures = coverage_figures(reachable);
  row.reachable_m2 = figures.workable_m2;
  row.missed_m2 = figures.missed_m2;
  row.missed = missed_patches(reachable, kLeastPatch_m2);
}

}  // namespace

SuiteRow suite_row(const FieldRecipe& recipe, const std::string& vehicle,
                   const Parameters& parameters, double clearance_m, SuiteField* kept) {
  SuiteRow row;
  row.recipe = recipe;
  row.vehicle = vehicle;
  SuiteField made;
  made.scenario.vehicle = vehicle;
  made.scenario.path.clearance_m = clearance_m;
  const PlannerEntry& planner = find_planner(made.scenario.planner.name, "bench");
  made.scenario.planner.parameters =
      resolve_parameters(planner.parameters, parameters, "bench", "planner");
  made.stage.field = made_up_field(recipe);
  made.stage.vehicle = load_vehicle(vehicle);
  try {
    auto begun = std::chrono::steady_clock::now();
    const Plan plan = planner.plan(plan_request(made.scenario, made.stage));
    row.plan_s = seconds_since(begun);
    row.passes = plan.passes.size();
    begun = std::chrono::steady_clock::now();
    made.path = make_path(made.stage.field, made.stage.vehicle, plan, made.scenario.path);
    row.path_s = seconds_since(begun);
  } catch (const PlanInfeasible& refused) {
    row.refusal = refused.what();
    return row;
  } catch (const InputError& refused) {
    row.refusal = refused.what();
    return row;
  }
  const auto begun = std::chrono::steady_clock::now();
  judge_path(made, row);
  row.audit_s = seconds_since(begun);
  if (kept != nullptr) *kept = std::move(made);
  return row;
}

double coverage_cell_m(const Field& field) {
  return std::clamp(std::sqrt(field_area_m2(field) / kMostCells), kLeastCell_m, kMostCell_m);
}

double covered_percent(const SuiteRow& row) {
  return 100.0 * (1.0 - row.missed_m2 / std::max(row.reachable_m2, 1e-9));
}

nlohmann::ordered_json row_json(const SuiteRow& row) {
  nlohmann::ordered_json json;
  json["shape"] = field_shape_name(row.recipe.shape);
  json["seed"] = row.recipe.seed;
  json["area_ha"] = 1e-4 * row.recipe.area_m2;
  json["holes"] = row.recipe.holes;
  json["trees"] = row.recipe.trees;
  json["vehicle"] = row.vehicle;
  json["refusal"] = row.refusal;
  if (!row.refusal.empty()) return json;
  json["plan_s"] = row.plan_s;
  json["path_s"] = row.path_s;
  json["audit_s"] = row.audit_s;
  json["passes"] = row.passes;
  json["length_m"] = row.length_m;
  json["work_m"] = row.work_m;
  json["states_outside"] = row.states_outside;
  json["other_faults"] = row.other_faults;
  json["field_m2"] = row.field_m2;
  json["reachable_m2"] = row.reachable_m2;
  json["missed_m2"] = row.missed_m2;
  json["covered_of_reachable_percent"] = covered_percent(row);
  json["overlap_percent"] = 100.0 * row.overlap_m2 / row.field_m2;
  json["outside_percent"] = 100.0 * row.outside_m2 / row.field_m2;
  auto missed = nlohmann::ordered_json::array();
  for (const GroundPatch& patch : row.missed) {
    missed.push_back({{"x_m", patch.p_W.x()}, {"y_m", patch.p_W.y()}, {"area_m2", patch.area_m2}});
  }
  json["missed"] = missed;
  auto faults = nlohmann::ordered_json::array();
  for (const AuditPlace& place : row.faults) {
    faults.push_back({{"fault", audit_fault_name(place.fault)},
                      {"x_m", place.p_W.x()},
                      {"y_m", place.p_W.y()},
                      {"from_m", place.from_m},
                      {"length_m", place.length_m},
                      {"states", place.states},
                      {"worst", place.worst}});
  }
  json["faults"] = faults;
  auto left_out = nlohmann::ordered_json::array();
  for (const LeftOutPass& pass : row.left_out) {
    left_out.push_back({{"pass", pass.pass}, {"why", pass.why}});
  }
  json["left_out"] = left_out;
  return json;
}

SuiteRow row_of(const nlohmann::json& json, const FieldRecipe& recipe) {
  SuiteRow row;
  row.recipe = recipe;
  row.vehicle = json.at("vehicle");
  row.refusal = json.at("refusal");
  if (!row.refusal.empty()) return row;
  row.plan_s = json.at("plan_s");
  row.path_s = json.at("path_s");
  row.audit_s = json.at("audit_s");
  row.passes = json.at("passes");
  row.length_m = json.at("length_m");
  row.work_m = json.at("work_m");
  row.states_outside = json.at("states_outside");
  row.other_faults = json.at("other_faults");
  row.field_m2 = json.at("field_m2");
  row.reachable_m2 = json.at("reachable_m2");
  row.missed_m2 = json.at("missed_m2");
  row.overlap_m2 = 0.01 * json.at("overlap_percent").get<double>() * row.field_m2;
  row.outside_m2 = 0.01 * json.at("outside_percent").get<double>() * row.field_m2;
  for (const auto& patch : json.at("missed")) {
    GroundPatch& missed = row.missed.emplace_back();
    missed.p_W = {patch.at("x_m").get<double>(), patch.at("y_m").get<double>()};
    missed.area_m2 = patch.at("area_m2");
  }
  return row;
}

}  // namespace headland::bench

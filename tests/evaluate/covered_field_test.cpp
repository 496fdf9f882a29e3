// Paths over made-up fields, audited: a small sample of `polygon_bench suite`.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "evaluate/audit.h"
#include "evaluate/audit_file.h"
#include "evaluate/reachable_ground.h"
#include "evaluate/scenario.h"
#include "planner/drivable_path.h"
#include "planner/planners.h"
#include "terrains/field_generator.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kCoveredCell_m = 0.2;
constexpr double kLeastCovered = 0.995;

struct Audited {
  Audit audit;
  double covered_ratio = 0.0;  // of what can be reached
};

Audited audited(const FieldRecipe& recipe, const std::string& vehicle, const std::string& corners) {
  Scenario scenario;
  const PlannerEntry& planner = find_planner("boustrophedon", "test");
  scenario.planner.parameters =
      resolve_parameters(planner.parameters, {{"headland_corners", corners}}, "test", "planner");
  Stage stage;
  stage.field = made_up_field(recipe);
  stage.vehicle = load_vehicle(vehicle);
  const Plan plan = planner.plan(plan_request(scenario, stage));
  const Path path = make_path(stage.field, stage.vehicle, plan, scenario.path);
  Audited made;
  made.audit = audit_path(stage.field, stage.vehicle, lines_of(path), kCoveredCell_m);
  const CoverageFigures figures = coverage_figures(
      reachable_part(made.audit.raster, stage.field, stage.vehicle, scenario.path.clearance_m));
  made.covered_ratio = 1.0 - figures.missed_m2 / figures.workable_m2;
  return made;
}

using CoveredCase = std::tuple<FieldRecipe, std::string>;
class CoveredField : public testing::TestWithParam<CoveredCase> {};

TEST_P(CoveredField, IsWorkedAllOverAndNeverLeft) {
  const auto& [recipe, vehicle] = GetParam();
  const Audited made = audited(recipe, vehicle, "covered");
  EXPECT_TRUE(made.audit.places.empty())
      << (made.audit.places.empty() ? "" : audit_place_text(made.audit.places.front()));
  EXPECT_GE(made.covered_ratio, kLeastCovered);
}

const std::vector<CoveredCase> kCoveredCases = {
    {{FieldShape::kThin, 3000.0, 0, 0, 3}, "transplanter"},
    {{FieldShape::kL, 4000.0, 0, 0, 4}, "transplanter"},
    {{FieldShape::kConvex, 4000.0, 1, 0, 11}, "transplanter"},
    {{FieldShape::kThin, 9000.0, 0, 1, 18}, "utility_tractor"},
    {{FieldShape::kConcave, 12000.0, 0, 0, 12}, "utility_tractor"},
};

std::string covered_case_name(const testing::TestParamInfo<CoveredCase>& info) {
  const FieldRecipe& recipe = std::get<0>(info.param);
  return std::string(field_shape_name(recipe.shape)) + "_" + std::get<1>(info.param) + "_" +
         std::to_string(recipe.seed);
}

INSTANTIATE_TEST_SUITE_P(MadeUp, CoveredField, testing::ValuesIn(kCoveredCases), covered_case_name);

// The same field with rounds past its corners is not.
TEST(RoundedHeadland, LeavesMoreOfWhatCanBeReached) {
  const Audited made = audited(std::get<0>(kCoveredCases[1]), "transplanter", "rounded");
  EXPECT_TRUE(made.audit.places.empty());
  EXPECT_LT(made.covered_ratio, kLeastCovered);
}

// Of a square, all but for what the clearance keeps the front and the sides from; behind a gap
// that the vehicle does not fit through, nothing.
TEST(ReachableGround, IsWhatSomePoseWorks) {
  const Vehicle vehicle = load_vehicle("transplanter");
  Field field;
  field.boundary = {{0, 0}, {30, 0}, {30, 30}, {0, 30}};
  const auto reachable_m2 = [&] {
    const CoverageRaster raster = measure_coverage(field, {}, 2.0, 0.2);
    return coverage_figures(reachable_part(raster, field, vehicle, 0.1)).workable_m2;
  };
  EXPECT_GT(reachable_m2(), 0.98 * 900.0);
  // A chamber of 10 m x 10 m with a way in of 0.8 m.
  field.boundary = {{0, 0},   {30, 0},  {30, 14},   {32, 14},   {32, 10}, {42, 10},
                    {42, 20}, {32, 20}, {32, 14.8}, {30, 14.8}, {30, 30}, {0, 30}};
  EXPECT_GT(reachable_m2(), 0.98 * 900.0);
  EXPECT_LT(reachable_m2(), 1.005 * 900.0);
}

}  // namespace
}  // namespace headland

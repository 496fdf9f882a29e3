// What paths of ours work as planned.
#include "evaluate/planned_coverage.h"

#include <gtest/gtest.h>

#include "evaluate/audit.h"
#include "planner/drivable_path.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kCell_m = 0.1;

Field bare_square() {
  Field field;
  field.name = "square";
  field.boundary = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  return field;
}

TEST(PlannedCoverage, IsWhatTheImplementSweepsAndWhatTheAuditTells) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const double width_m = vehicle.implement.working_width_m;
  Plan plan;
  plan.passes.push_back({PassKind::kSwath, {{20, 10}, {20, 45}}});
  plan.passes.push_back({PassKind::kSwath, {{40, 45}, {40, 15}}});
  const Path path = make_path(bare_square(), vehicle, plan, {});
  const CoverageFigures coverage = planned_coverage(bare_square(), vehicle, path, kCell_m);
  EXPECT_NEAR(coverage.workable_m2, 3600.0, 1e-6);
  // The edges lie on cells' edges but for half a cell at the four ends.
  EXPECT_NEAR(coverage.covered_m2, width_m * (35.0 + 30.0), 4.0 * kCell_m * width_m);
  EXPECT_EQ(coverage.overlap_m2, 0.0);
  const Audit audit = audit_path(bare_square(), vehicle, lines_of(path), kCell_m);
  EXPECT_NEAR(coverage.covered_m2, audit.coverage.covered_m2, kCell_m * width_m);
}

}  // namespace
}  // namespace headland

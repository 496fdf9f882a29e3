#include "evaluate/planner_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "evaluate/measure.h"
#include "planner/path_energy.h"
#include "tests/evaluate/made_up_costs.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DriveCostOf, TakesTheTableApart) {
  const DriveCost cost = drive_cost_of(made_up_table(), load_vehicle("transplanter"), "costs");
  constexpr double kRounded_wh = 1e-9;
  EXPECT_NEAR(wh_per_m(cost.working, 0.05), 2.5, kRounded_wh);
  EXPECT_NEAR(wh_per_m(cost.raised, -0.05, 0.1), 0.5 + 0.05, kRounded_wh);
  EXPECT_NEAR(wh_per_m(cost.transit, 0.0), 1.0, kRounded_wh);  // at the only speed there is
  EXPECT_NEAR(cost.bend_wh, 2.0, kRounded_wh);
  EXPECT_NEAR(cost.stop_working_wh, 0.5, kRounded_wh);
  EXPECT_NEAR(cost.stop_raised_wh, 0.5, kRounded_wh);
  EXPECT_NEAR(cost.movement.cycle_wh, 3.0, kRounded_wh);
  EXPECT_NEAR(cost.movement.quarter_wh, 2.0, kRounded_wh);
  EXPECT_NEAR(cost.movement.cusp_wh, 4.0, kRounded_wh);
  EXPECT_EQ(cost.movement.pivot_wh, 0.0);  // it has none
  EXPECT_EQ(cheapest_row_turn(cost, 6.0).kind, RowTurn::kU);
}

TEST(DriveCostOf, RefusesTablesThatLackWhatPlansAreMadeOf) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const auto refused = [&](ManoeuvreKind kind, bool down) {
    CostTable table = made_up_table();
    for (MeasuredCost& cost : table.costs) {
      const bool slope = cost.manoeuvre.slope_along != 0.0 || cost.manoeuvre.slope_across != 0.0;
      if (cost.manoeuvre.kind == kind && cost.manoeuvre.implement_down == down && !slope) {
        cost.outcome = Outcome::kStuck;
      }
    }
    return refusal([&] { drive_cost_of(table, vehicle, "costs.yaml"); });
  };
  EXPECT_THAT(
      refused(ManoeuvreKind::kStraight, true),
      HasSubstr("costs.yaml: costs: a finished straight on the flat with the implement down"));
  EXPECT_THAT(refused(ManoeuvreKind::kTurn90, false),
              HasSubstr("a finished 90-degree turn with the implement raised is needed"));
  EXPECT_THAT(refused(ManoeuvreKind::kImplementCycle, true),
              HasSubstr("a finished implement cycle"));
  EXPECT_EQ(refused(ManoeuvreKind::kStopStart, true), "accepted");
  CostTable table = made_up_table();
  table.costs.front().energy_j.mean = std::nan("");
  EXPECT_THAT(refusal([&] { drive_cost_of(table, vehicle, "costs.yaml"); }),
              HasSubstr("costs that are finite numbers are needed"));
}

class DriveCostFile : public ScratchFolder {};

TEST_F(DriveCostFile, IsForItsVehicleAndTellsOfOtherWidthsAndSoils) {
  const std::filesystem::path file = written("costs.yaml", cost_table_yaml(made_up_table()));
  Vehicle vehicle = load_vehicle("transplanter");
  std::vector<std::string> notes;
  static_cast<void>(read_drive_cost(file, vehicle, "firm", notes));
  EXPECT_THAT(notes, IsEmpty());
  vehicle.implement.working_width_m = 1.5;
  static_cast<void>(read_drive_cost(file, vehicle, "tilled", notes));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "costs: measured with 2 m, planned with 1.5 m");
  EXPECT_EQ(notes[1], "costs: measured on firm, planned for tilled");
  EXPECT_THAT(
      refusal([&] { read_drive_cost(file, load_vehicle("utility_tractor"), "firm", notes); }),
      HasSubstr("vehicle: 'transplanter': costs of utility_tractor are needed"));
}

// Measured in physics, the manoeuvres' own courses are predicted to within a few percent: what the
// fit of bends and cusps leaves over. The course has a stop at either end besides.
TEST(DriveCostOf, PredictsWhatItWasMeasuredOn) {
  const Vehicle vehicle = load_vehicle("transplanter");
  MeasureOptions options;
  options.ranges.speed_shares = {1.0};
  options.ranges.slopes = {0.0};
  options.ranges.side_slopes = {};
  options.ranges.spacings_m = {2.0, 6.0};
  options.micro_relief.rms_m = 0.0;
  options.repeats = 1;
  const Soil soil{"textbook", ConstantGround{0.8, 0.05, 10.0}, 0.09, ""};
  const CostTable table = measure_costs(vehicle, soil, options);
  const DriveCost cost = drive_cost_of(table, vehicle, "costs");
  for (const MeasuredCost& measured : table.costs) {
    if (measured.manoeuvre.kind < ManoeuvreKind::kTurn90) continue;
    SCOPED_TRACE(manoeuvre_name(measured.manoeuvre.kind));
    const Course course = course_of(measured.manoeuvre, vehicle);
    const PredictedEnergy whole = predicted_energy(course.path, nullptr, cost);
    double straights_wh = 0.5 * (measured.manoeuvre.implement_down ? 2.0 * cost.stop_working_wh
                                                                   : 2.0 * cost.stop_raised_wh);
    for (const PathSegment& segment : course.path.segments) {
      const bool straight = segment.kind == PathKind::kSwath || segment.kind == PathKind::kTransit;
      if (!straight) continue;
      straights_wh +=
          length_m(segment) * wh_per_m(segment.implement_down ? cost.working : cost.raised, 0.0);
    }
    const double turn_wh = kPerJoule_wh * measured.energy_j.mean;
    constexpr double kFit = 0.08;  // of the turn
    EXPECT_NEAR(whole.energy_wh - straights_wh, turn_wh, kFit * turn_wh);
  }
}

}  // namespace
}  // namespace headland

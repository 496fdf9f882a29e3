// Every planner on fields takes measured costs, and is no worse by them.
#include "planner/least_energy_path.h"

#include <gtest/gtest.h>

#include <string>

#include "planner/polygon.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_cost.h"
#include "tests/planner/made_up_vehicle.h"
#include "tests/planner/waves.h"

namespace headland {
namespace {

constexpr double kRadius_m = 2.5;  // of the made-up cost
constexpr double kWidth_m = 2.0;
constexpr double kRounding_wh = 1e-9;

Field with_a_hole() {
  Field field = field_of("hole", {{0, 0}, {36, -4}, {42, 24}, {22, 36}, {-4, 28}});
  field.holes.push_back(reversed(rectangle_ring(16, 12, 21, 17)));
  return field;
}

PlanRequest request_for(const Field& field, const std::string& planner,
                        const Heightfield& terrain) {
  PlanRequest request = transplanter_request(field, planner);
  request.working_width_m = kWidth_m;
  request.turning_radius_m = kRadius_m;
  request.terrain = &terrain;
  return request;
}

double wh_of(const PlannerEntry& planner, const PlanRequest& request, const Vehicle& vehicle,
             const DriveCost& cost) {
  PlannedPath planned{planner.plan(request), {}};
  planned.path = make_path(request.field, vehicle, planned.plan, {});
  return chosen_by_wh(planned, request.terrain, cost);
}

class EveryFieldPlanner : public testing::TestWithParam<std::size_t> {
 protected:
  const PlannerEntry& planner_ = planners()[GetParam()];
  Vehicle vehicle_ = made_up_vehicle(kRadius_m, kWidth_m);
  DriveCost cost_ = made_up_cost();
};

TEST_P(EveryFieldPlanner, TakesNoMoreByMeasuredCostsThanWithoutThem) {
  const Heightfield terrain = waves(2.0, 40.0, 0.05);
  PlanRequest request = request_for(with_a_hole(), std::string(planner_.name), terrain);
  const double without_wh = wh_of(planner_, request, vehicle_, cost_);
  request.cost = &cost_;
  const PlannedPath chosen = least_energy_path(planner_, request, vehicle_, {});
  EXPECT_LE(chosen_by_wh(chosen, &terrain, cost_), without_wh + kRounding_wh);
}

// What the request does ask for is not left to costs.
TEST_P(EveryFieldPlanner, KeepsTheDirectionAskedFor) {
  const Heightfield terrain = waves(2.0, 40.0);
  PlanRequest request = request_for(with_a_hole(), std::string(planner_.name), terrain);
  request.cost = &cost_;
  request.parameters["swath_direction_deg"] = 30.0;
  const PlannedPath chosen = least_energy_path(planner_, request, vehicle_, {});
  EXPECT_NEAR(chosen.plan.swath_direction_rad, kPi / 6.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryFieldPlanner,
                         testing::Range(std::size_t{0}, planners().size()),
                         [](const auto& planner) {
                           return std::string(planners()[planner.param].name);
                         });

// On a plane that rises steeply to the east alone, working across the slope is cheaper here.
TEST(LeastEnergyPath, TurnsSwathsOutOfTheSlope) {
  const Heightfield terrain = waves(0.0, 40.0, 0.2);
  DriveCost cost = made_up_cost();
  cost.working.across_wh_per_m = 0.0;
  const Field field = field_of("oblong", rectangle_ring(0, 0, 50, 40));
  PlanRequest request = request_for(field, "boustrophedon", terrain);
  request.cost = &cost;
  const PlannedPath chosen = least_energy_path(find_planner("boustrophedon", "test"), request,
                                               made_up_vehicle(kRadius_m, kWidth_m), {});
  EXPECT_NEAR(chosen.plan.swath_direction_rad, kPi / 2.0, 1e-9);
  request.cost = nullptr;
  EXPECT_NEAR(find_planner("boustrophedon", "test").plan(request).swath_direction_rad, 0.0, 1e-9);
}

}  // namespace
}  // namespace headland

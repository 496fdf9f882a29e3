// What every planner of the table must do on every field.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "planner/headland_rings.h"
#include "planner/planners.h"
#include "planner/polygon.h"
#include "planner/ring_smoothing.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

// Swaths lie in offsets whose arcs are chords: 0.05 % of at most 10 m, and doubles.
constexpr double kSwathClearanceTolerance_m = 0.01;
// Rings: rounding (1 %), clearance slack (2 %) and filter (0.5 % of the radius) may add up.
constexpr double kRingClearancePerRadius = 0.035;
// Ground deeper in the field than the headland must be covered but for seams: swaths may end a
// millimetre short of each other along their whole length.
constexpr double kInnerMissRatio = 1e-4;
// What may be missed are corners of the headland: outside the arc of a round, 0.21 (R + w/2)^2 at a
// right corner, and between the arcs of two rounds. The triangle's sharp corners are the worst.
constexpr double kCoverageRatio = 0.965;
// Rounded rings depend on where the chords of arcs begin, which turns with the field's axes.
constexpr double kMovedLengthRatio = 2e-3;

enum class Machine { kTractor, kTransplanter };

PlanRequest request_for(const Field& field, Machine machine, const std::string& planner) {
  return machine == Machine::kTractor ? tractor_request(field, planner)
                                      : transplanter_request(field, planner);
}

double clearance_m(const Field& field, const Eigen::Vector2d& p_W) {
  double clearance_m = field_clearance_m(field, p_W);
  for (const Obstacle& obstacle : field.obstacles) {
    clearance_m = std::min(clearance_m, obstacle_gap_m(obstacle, p_W));
  }
  return clearance_m;
}

// Least clearance on the line between its points too, every 0.5 m.
double least_clearance_m(const Field& field, const Polyline& line) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d edge = line[i] - line[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(edge.norm() / 0.5)));
    for (int k = 0; k <= steps; ++k) {
      least_m = std::min(least_m, clearance_m(field, line[i - 1] + edge * k / steps));
    }
  }
  return least_m;
}

PolygonSet covered(const Plan& plan, double width_m) {
  std::vector<PolygonSet> strips;
  for (const Pass& pass : plan.passes) strips.push_back(strip(pass.points_W, width_m));
  return united(strips);
}

std::size_t swath_count(const Plan& plan) {
  return static_cast<std::size_t>(std::ranges::count(plan.passes, PassKind::kSwath, &Pass::kind));
}

using Case = std::tuple<std::size_t, std::size_t, Machine>;  // planner, field, machine

class EveryPlanner : public testing::TestWithParam<Case> {
 protected:
  const PlannerEntry& planner_ = planners()[std::get<0>(GetParam())];
  Field field_ = field_shapes()[std::get<1>(GetParam())];
  PlanRequest request_ = request_for(field_, std::get<2>(GetParam()), std::string(planner_.name));
};

TEST_P(EveryPlanner, KeepsImplementAndHullOnTheField) {
  const double reach_m = std::max(request_.working_width_m, request_.vehicle_width_m) / 2.0;
  const Plan plan = planner_.plan(request_);
  ASSERT_FALSE(plan.passes.empty());
  for (const Pass& pass : plan.passes) {
    const double slack_m = pass.kind == PassKind::kSwath
                               ? kSwathClearanceTolerance_m
                               : kRingClearancePerRadius * request_.turning_radius_m;
    EXPECT_GE(least_clearance_m(field_, pass.points_W), reach_m - slack_m)
        << pass_kind_name(pass.kind) << " from " << pass.points_W.front().transpose();
  }
}

TEST_P(EveryPlanner, CoversTheFieldButForCornersOfTheHeadland) {
  const Plan plan = planner_.plan(request_);
  const PolygonSet ground = from_field(field_);
  const PolygonSet missed = difference(ground, covered(plan, request_.working_width_m));
  EXPECT_GE(1.0 - area_m2(missed) / area_m2(ground), kCoverageRatio);
  const PolygonSet inner = buffered(ground, -plan.headland_width_m, Join::kRound);
  EXPECT_LE(area_m2(inner) - area_m2(difference(inner, missed)), kInnerMissRatio * area_m2(ground));
}

TEST_P(EveryPlanner, MakesPassesThatCanBeDriven) {
  const Plan plan = planner_.plan(request_);
  EXPECT_EQ(plan.planner, planner_.name);
  double sum_m = 0.0;
  for (const Pass& pass : plan.passes) {
    sum_m += length_m(pass.points_W);
    if (pass.kind == PassKind::kSwath) {
      ASSERT_EQ(pass.points_W.size(), 2U);
      EXPECT_GT(length_m(pass.points_W), 0.0);
      continue;
    }
    ASSERT_GT(pass.points_W.size(), 3U);
    EXPECT_EQ(pass.points_W.front(), pass.points_W.back());
    for (std::size_t i = 1; i < pass.points_W.size(); ++i) {
      ASSERT_LE((pass.points_W[i] - pass.points_W[i - 1]).norm(), kRingSpacing_m + 1e-9);
    }
    EXPECT_GE(tightest_radius_m(pass.points_W, request_.turning_radius_m / 5.0),
              request_.turning_radius_m);
  }
  EXPECT_DOUBLE_EQ(plan.planned_length_m, sum_m);
}

TEST_P(EveryPlanner, PlansTheSameEveryTime) {
  const Plan a = planner_.plan(request_);
  const Plan b = planner_.plan(request_);
  ASSERT_EQ(a.passes.size(), b.passes.size());
  for (std::size_t i = 0; i < a.passes.size(); ++i) {
    ASSERT_EQ(a.passes[i].points_W, b.passes[i].points_W);
  }
}

TEST_P(EveryPlanner, DoesNotCareWhereTheFieldLies) {
  const Plan plan = planner_.plan(request_);
  PlanRequest elsewhere = request_;
  elsewhere.field = moved(field_, 2.2, Eigen::Vector2d(1500.0, -700.0));
  const Plan other = planner_.plan(elsewhere);
  EXPECT_EQ(swath_count(other), swath_count(plan));
  EXPECT_NEAR(other.planned_length_m, plan.planned_length_m,
              kMovedLengthRatio * plan.planned_length_m);
}

TEST_P(EveryPlanner, RefusesAnImplementWiderThanTheField) {
  request_.working_width_m = 500.0;
  EXPECT_THROW(planner_.plan(request_), InputError);
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  const auto& [planner, field, machine] = info.param;
  return std::string(planners()[planner].name) + "_" + field_shapes()[field].name +
         (machine == Machine::kTractor ? "_tractor" : "_transplanter");
}

INSTANTIATE_TEST_SUITE_P(Conformance, EveryPlanner,
                         testing::Combine(testing::Range(std::size_t{0}, planners().size()),
                                          testing::Range(std::size_t{0}, field_shapes().size()),
                                          testing::Values(Machine::kTractor,
                                                          Machine::kTransplanter)),
                         case_name);

TEST(Planners, UnknownNameIsAnsweredWithTheNearest) {
  try {
    find_planner("bustrophedon", "scenario.yaml");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "scenario.yaml: planner.name: 'bustrophedon': unknown planner; the nearest is "
                 "boustrophedon");
  }
}

}  // namespace
}  // namespace headland

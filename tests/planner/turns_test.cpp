#include "planner/turns.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

constexpr double kTurnRounding_m = 1e-9;  // closed forms against closed forms
constexpr double kEndTolerance = 1e-6;    // what turns.h promises, m and rad

// Two swath ends side by side, the second `spacing_m` to the right and driven back.
struct Neighbours {
  Pose from{{0.0, 0.0}, kPi / 2.0};
  Pose to;
  explicit Neighbours(double spacing_m) : to{{spacing_m, 0.0}, -kPi / 2.0} {}
};

// The curve's name: L, R, S for left, right, straight, with ' after what is reversed. Between
// opposite neighbouring swaths LSL is the U turn, RLR and LRL the omega (bulb) turn and LS'L the
// three-point (fishtail) turn.
std::string word_of(const std::vector<Arc>& arcs) {
  std::string word;
  for (const Arc& arc : arcs) {
    word += arc.curvature_per_m > 0.0 ? 'L' : (arc.curvature_per_m < 0.0 ? 'R' : 'S');
    if (arc.gear == Gear::kReverse) word += '\'';
  }
  return word;
}

const Turn* find_word(const std::vector<Turn>& found, const std::string& word) {
  const Turn* best = nullptr;
  for (const Turn& turn : found) {
    if (word_of(turn.arcs) == word &&
        (best == nullptr || length_m(turn.arcs) < length_m(best->arcs))) {
      best = &turn;
    }
  }
  return best;
}

double highest_y_m(const Pose& from, const Turn& turn) {
  double highest = from.p_W.y();
  for (const PathSegment& segment : sample(from, turn.arcs, 0.001)) {
    for (const PathPoint& point : segment.points) highest = std::max(highest, point.p_W.y());
  }
  return highest;
}

TEST(Turns, UTurnIsTwoQuarterCirclesAndALine) {
  const double radius_m = 3.0;
  const double spacing_m = 9.0;
  const Neighbours ends(spacing_m);
  const auto found = turns(ends.from, ends.to, radius_m);
  const Turn* turn = find_word(found, "RSR");
  ASSERT_NE(turn, nullptr);
  EXPECT_NEAR(length_m(turn->arcs), spacing_m + (kPi - 2.0) * radius_m, kTurnRounding_m);
  EXPECT_EQ(word_of(found.front().arcs), "RSR") << "the cheapest of all";
}

TEST(Turns, OmegaTurnHasItsClosedFormLengthAndDepth) {
  const double radius_m = 2.6;
  const double spacing_m = 2.0;
  const Neighbours ends(spacing_m);
  const auto found = turns(ends.from, ends.to, radius_m);
  const Turn* turn = find_word(found, "LRL");
  ASSERT_NE(turn, nullptr);
  const double sine = (2.0 * radius_m + spacing_m) / (4.0 * radius_m);
  EXPECT_NEAR(length_m(turn->arcs), radius_m * (3.0 * kPi - 4.0 * std::asin(sine)),
              kTurnRounding_m);
  const double sampling_m = 1e-6;  // sagitta of 1 mm steps on this radius
  EXPECT_NEAR(highest_y_m(ends.from, *turn),
              radius_m + 2.0 * radius_m *
                             std::sin(std::acos((radius_m + spacing_m / 2.0) / (2.0 * radius_m))),
              sampling_m);
  EXPECT_NEAR(highest_y_m(ends.from, *turn), 6.35, 0.005) << "the reference figure, two digits";
}

TEST(Turns, FishtailHasItsClosedFormLengthAndTwoCusps) {
  const double radius_m = 2.6;
  const double spacing_m = 2.0;
  const Neighbours ends(spacing_m);
  const auto found = turns(ends.from, ends.to, radius_m);
  const Turn* turn = find_word(found, "RS'R");
  ASSERT_NE(turn, nullptr);
  EXPECT_NEAR(length_m(turn->arcs), kPi * radius_m + 2.0 * radius_m - spacing_m, kTurnRounding_m);
  EXPECT_NEAR(reverse_length_m(turn->arcs), 2.0 * radius_m - spacing_m, kTurnRounding_m);
  EXPECT_EQ(cusp_count(turn->arcs), 2);
  EXPECT_NEAR(turn->cost_m,
              length_m(turn->arcs) + (kReverseMetreCost - 1.0) * reverse_length_m(turn->arcs) +
                  2.0 * kCuspCost_m,
              kTurnRounding_m);
  const auto segments = sample(ends.from, turn->arcs, kPathSpacing_m);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].gear, Gear::kForward);
  EXPECT_EQ(segments[1].gear, Gear::kReverse);
  EXPECT_EQ(segments[2].gear, Gear::kForward);
}

TEST(Turns, SameWayOnIsAStraightLine) {
  const Pose from{{1.0, 2.0}, 0.3};
  const Pose to = pose_along(from, {7.0, 0.0, Gear::kForward}, 7.0);
  const auto found = turns(from, to, 4.0);
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found.front().cost_m, 7.0, kTurnRounding_m);
}

Pose random_pose() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) * 1e-3; };
  return {{number(-20000, 20000), number(-20000, 20000)}, number(-3141, 3142)};
}

double ompl_dubins_m(const Pose& from, const Pose& to, double radius_m) {
  ompl::base::DubinsStateSpace space(radius_m);
  auto* a = space.allocState()->as<ompl::base::SE2StateSpace::StateType>();
  auto* b = space.allocState()->as<ompl::base::SE2StateSpace::StateType>();
  a->setXY(from.p_W.x(), from.p_W.y());
  a->setYaw(from.heading_rad);
  b->setXY(to.p_W.x(), to.p_W.y());
  b->setYaw(to.heading_rad);
  const double length_m = space.distance(a, b);
  space.freeState(a);
  space.freeState(b);
  return length_m;
}

RC_GTEST_PROP(Turns, ShortestForwardTurnIsDubins, ()) {
  const Pose from = random_pose();
  const Pose to = random_pose();
  const double radius_m = *rc::gen::inRange(1000, 9000) * 1e-3;
  double shortest_m = 1e9;
  for (const Turn& turn : turns(from, to, radius_m)) {
    if (reverse_length_m(turn.arcs) == 0.0) {
      shortest_m = std::min(shortest_m, length_m(turn.arcs));
    }
  }
  const double ompl_rounding_m = 1e-5;  // OMPL treats arcs under 1e-6 rad as none
  RC_ASSERT(std::abs(shortest_m - ompl_dubins_m(from, to, radius_m)) < ompl_rounding_m * radius_m);
}

RC_GTEST_PROP(Turns, EveryTurnEndsWhereItShouldWithinTheRadius, ()) {
  const Pose from = random_pose();
  const Pose to = random_pose();
  const double radius_m = *rc::gen::inRange(1000, 9000) * 1e-3;
  const double least_m = reeds_shepp_length_m(from, to, radius_m);
  double cost_before = 0.0;
  const auto found = turns_with_run_outs(from, to, radius_m);
  RC_ASSERT(found.size() >= 10U);
  for (const Turn& turn : found) {
    const Pose end = end_of(from, turn.arcs);
    RC_ASSERT((end.p_W - to.p_W).norm() < kEndTolerance);
    RC_ASSERT(std::abs(wrap_angle(end.heading_rad - to.heading_rad)) < kEndTolerance);
    RC_ASSERT(length_m(turn.arcs) > least_m - kEndTolerance);
    RC_ASSERT(turn.cost_m >= cost_before);
    cost_before = turn.cost_m;
    for (const Arc& arc : turn.arcs) {
      RC_ASSERT(std::abs(arc.curvature_per_m) < 1.0 / radius_m + kTurnRounding_m);
    }
  }
}

RC_GTEST_PROP(Turns, MirroredPosesGiveMirroredTurns, ()) {
  const Pose from = random_pose();
  const Pose to = random_pose();
  const auto mirrored = [](const Pose& pose) {
    return Pose{{pose.p_W.x(), -pose.p_W.y()}, -pose.heading_rad};
  };
  const auto right = turns(from, to, 3.0);
  const auto left = turns(mirrored(from), mirrored(to), 3.0);
  // Of equally short Reeds-Shepp curves OMPL takes either, so: forward turns, and as sets.
  const auto every_length_in = [](const std::vector<Turn>& a, const std::vector<Turn>& b) {
    return std::all_of(a.begin(), a.end(), [&](const Turn& turn) {
      return reverse_length_m(turn.arcs) > 0.0 ||
             std::any_of(b.begin(), b.end(), [&](const Turn& other) {
               return reverse_length_m(other.arcs) == 0.0 &&
                      std::abs(turn.cost_m - other.cost_m) < kEndTolerance;
             });
    });
  };
  RC_ASSERT(every_length_in(right, left));
  RC_ASSERT(every_length_in(left, right));
}

// Curvature is steer over wheelbase in either gear: with the wheels to the left, a metre in
// reverse turns the body clockwise.
TEST(Arcs, ReversingWithLeftSteerTurnsTheBodyClockwise) {
  const Pose end = pose_along({}, {1.0, 0.5, Gear::kReverse}, 1.0);
  EXPECT_NEAR(end.heading_rad, -0.5, kTurnRounding_m);
  EXPECT_LT(end.p_W.x(), 0.0);
  EXPECT_GT(end.p_W.y(), 0.0);
  const Pose back = pose_along(end, {1.0, 0.5, Gear::kForward}, 1.0);
  EXPECT_NEAR(back.p_W.norm(), 0.0, kTurnRounding_m);
  EXPECT_NEAR(back.heading_rad, 0.0, kTurnRounding_m);
}

RC_GTEST_PROP(Arcs, SamplesObeyTheirOwnHeadingAndCurvature, ()) {
  const Pose from = random_pose();
  const Pose to = random_pose();
  const double radius_m = 3.0;
  for (const Turn& turn : turns(from, to, radius_m)) {
    for (const PathSegment& segment : sample(from, turn.arcs, kPathSpacing_m)) {
      const double sign = segment.gear == Gear::kForward ? 1.0 : -1.0;
      for (std::size_t i = 1; i < segment.points.size(); ++i) {
        const PathPoint& a = segment.points[i - 1];
        const PathPoint& b = segment.points[i];
        const Eigen::Vector2d chord = b.p_W - a.p_W;
        RC_ASSERT(chord.norm() <= kPathSpacing_m + kTurnRounding_m);
        // On an arc the chord lies along the mean heading, against it in reverse.
        const double turned_rad = wrap_angle(b.heading_rad - a.heading_rad);
        const double mean_rad = a.heading_rad + 0.5 * turned_rad;
        RC_ASSERT(sign * chord.dot(direction_of(mean_rad)) >= chord.norm() - kTurnRounding_m);
        const double arc_m = std::abs(turned_rad) < 1e-9
                                 ? chord.norm()
                                 : chord.norm() * 0.5 * turned_rad / std::sin(0.5 * turned_rad);
        RC_ASSERT(std::abs(turned_rad - sign * a.curvature_per_m * arc_m) < kEndTolerance);
      }
    }
  }
}

}  // namespace
}  // namespace headland

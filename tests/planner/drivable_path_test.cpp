#include "planner/drivable_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>
#include <regex>

#include "planner/arcs.h"
#include "planner/connection.h"
#include "planner/free_space.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr double kJoint_m = 1e-6;
constexpr double kJoint_rad = 1e-6;
constexpr double kRounding = 1e-9;

Field rectangle(double width_m, double height_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  return field;
}

// Up and down swaths of a rectangle with the same headland on every side.
Plan up_and_down(double width_m, double height_m, double working_width_m, double headland_m) {
  Plan plan;
  bool up = true;
  for (double x = headland_m + 0.5 * working_width_m;
       x + 0.5 * working_width_m <= width_m - headland_m + kRounding; x += working_width_m) {
    const Eigen::Vector2d low(x, headland_m);
    const Eigen::Vector2d high(x, height_m - headland_m);
    plan.passes.push_back({PassKind::kSwath, up ? std::vector<Eigen::Vector2d>{low, high}
                                                : std::vector<Eigen::Vector2d>{high, low}});
    up = !up;
  }
  return plan;
}

void expect_continuous(const Path& path, const Vehicle& vehicle) {
  const double tightest = 1.0 / planning_turning_radius_m(vehicle) + kRounding;
  int manoeuvre = 0;
  const PathPoint* last = nullptr;
  for (const PathSegment& segment : path.segments) {
    ASSERT_GE(segment.points.size(), 2U);
    EXPECT_GE(segment.manoeuvre, manoeuvre);
    EXPECT_LE(segment.manoeuvre, manoeuvre + 1);
    manoeuvre = segment.manoeuvre;
    if (last != nullptr) {
      EXPECT_LT((segment.points.front().p_W - last->p_W).norm(), kJoint_m);
      EXPECT_LT(std::abs(wrap_angle(segment.points.front().heading_rad - last->heading_rad)),
                kJoint_rad);
    }
    for (std::size_t i = 1; i < segment.points.size(); ++i) {
      const PathPoint& a = segment.points[i - 1];
      const PathPoint& b = segment.points[i];
      EXPECT_LE((b.p_W - a.p_W).norm(), kPathSpacing_m + kRounding);
      EXPECT_GT((b.p_W - a.p_W).norm(), 0.0);
      EXPECT_LE(std::abs(wrap_angle(b.heading_rad - a.heading_rad)),
                kPathSpacing_m * tightest + kJoint_rad);
      EXPECT_LE(std::abs(b.curvature_per_m), tightest);
    }
    last = &segment.points.back();
  }
}

void expect_inside(const Path& path, const Field& field, const Vehicle& vehicle,
                   double clearance_m) {
  const FreeSpace space = free_space(field, hull_of(vehicle));
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      EXPECT_TRUE(fits(space, {point.p_W, point.heading_rad}, clearance_m))
          << point.p_W.transpose() << " in a " << path_kind_name(segment.kind);
    }
  }
}

TEST(MakePath, OmegaTurnsJoinNarrowSwathsInsideTheField) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  const Plan plan = up_and_down(40.0, 60.0, 2.0, 10.0);
  const Path path = make_path(field, vehicle, plan, {});
  EXPECT_TRUE(path.violations.empty());
  ASSERT_EQ(path.segments.size(), 2 * plan.passes.size() - 1) << "no cusps where there is room";
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const PathSegment& segment = path.segments[i];
    EXPECT_EQ(segment.kind, i % 2 == 0 ? PathKind::kSwath : PathKind::kUTurn);
    EXPECT_EQ(segment.implement_down, i % 2 == 0);
    EXPECT_EQ(segment.manoeuvre, static_cast<int>(i));
  }
}

TEST(MakePath, ImplementWorksFromEndToEndOfEachSwath) {
  const Vehicle vehicle = made_up_vehicle(2.6, 6.0);
  const Plan plan = up_and_down(40.0, 60.0, 6.0, 10.0);
  const Path path = make_path(rectangle(40.0, 60.0), vehicle, plan, {});
  std::size_t pass = 0;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind != PathKind::kSwath) continue;
    const auto implement = [&](const PathPoint& axle) -> Eigen::Vector2d {
      return axle.p_W + vehicle.implement.x_B_m * direction_of(axle.heading_rad);
    };
    const auto& points = plan.passes.at(pass++).points_W;
    EXPECT_LT((implement(segment.points.front()) - points.front()).norm(), kRounding);
    EXPECT_LT((implement(segment.points.back()) - points.back()).norm(), kRounding);
  }
  EXPECT_EQ(pass, plan.passes.size());
}

TEST(MakePath, ThreePointTurnsWhereOmegasDoNotFit) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  const Path path = make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, 6.0), {});
  expect_continuous(path, vehicle);
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
  int reversed = 0;
  for (const PathSegment& segment : path.segments) {
    if (segment.gear != Gear::kReverse) continue;
    ++reversed;
    EXPECT_EQ(segment.kind, PathKind::kUTurn);
    EXPECT_FALSE(segment.implement_down);
  }
  EXPECT_GT(reversed, 0);
}

TEST(MakePath, NarrowHeadlandIsRefusedWithAWidthThatWorks) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const Field field = rectangle(40.0, 60.0);
  std::string message;
  try {
    make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, 3.0), {});
  } catch (const PlanInfeasible& infeasible) {
    message = infeasible.what();
  }
  EXPECT_THAT(message,
              HasSubstr("no turn from pass 1 (swath) to pass 2 (swath) fits at (4.0, 57.0) m"));
  EXPECT_THAT(message, HasSubstr("there are 3.0 m"));
  std::smatch width;
  ASSERT_TRUE(std::regex_search(message, width, std::regex("a headland of ([0-9.]+) m")));
  const double would_do_m = std::stod(width[1]);
  const Path path = make_path(field, vehicle, up_and_down(40.0, 60.0, 2.0, would_do_m), {});
  EXPECT_TRUE(path.violations.empty());
  expect_inside(path, field, vehicle, PathOptions{}.clearance_m);
}

TEST(MakePath, OverrunsAreRecordedWhenAllowed) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  PathOptions options;
  options.allow_overrun = true;
  const Path path =
      make_path(rectangle(40.0, 60.0), vehicle, up_and_down(40.0, 60.0, 2.0, 3.0), options);
  expect_continuous(path, vehicle);
  ASSERT_FALSE(path.violations.empty());
  for (const PathViolation& violation : path.violations) {
    EXPECT_GT(violation.overrun_m, 0.0);
    EXPECT_THAT(violation.what, HasSubstr("beyond the boundary"));
    EXPECT_TRUE(violation.p_W.y() <= kRounding || violation.p_W.y() >= 60.0 - kRounding);
  }
}

}  // namespace
}  // namespace headland

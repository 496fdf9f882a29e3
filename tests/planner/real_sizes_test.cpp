// Planning to the end on any field: big, detailed, crowded, odd.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "planner/drivable_path.h"
#include "planner/free_space.h"
#include "planner/headland_rings.h"
#include "planner/outline.h"
#include "planner/planned_vehicle.h"
#include "planner/planners.h"
#include "planner/ring_smoothing.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/random_field.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

// What the outline's simplification and the tolerance of a fit may add up to, and rounding.
constexpr double kOverrun_m = kOutlineTolerance_m + kFitTolerance_m + 1e-6;

PlanRequest request_for(const Field& field, const Vehicle& vehicle) {
  const PlannerEntry& planner = find_planner("boustrophedon", "test");
  PlanRequest request;
  request.field = field;
  set_vehicle(request, vehicle);
  request.parameters = resolve_parameters(planner.parameters, {}, "test", "planner");
  return request;
}

Path path_for(const PlanRequest& request, const Vehicle& vehicle, const PathOptions& options = {}) {
  const Plan plan = find_planner("boustrophedon", "test").plan(request);
  return make_path(request.field, vehicle, plan, options);
}

void expect_inside(const Path& path, const Field& field, const Vehicle& vehicle) {
  const FreeSpace space = free_space(field, hull_of(vehicle));
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      ASSERT_LE(overrun(space, {point.p_W, point.heading_rad}).depth_m, kOverrun_m)
          << point.p_W.transpose() << " in a " << path_kind_name(segment.kind);
    }
  }
}

TEST(RealSizes, RandomFieldsArePlannedInsideOrRefusedWithAPlace) {
  constexpr std::uint64_t kSeeds = 12;
  // Of 118 plans for the two vehicles none was refused when this was written.
  constexpr int kMostRefused = 2;
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Vehicle vehicle = load_vehicle(seed % 2 == 0 ? "utility_tractor" : "transplanter");
    SCOPED_TRACE(seed);
    try {
      const Field field = random_field(seed);
      expect_inside(path_for(request_for(field, vehicle), vehicle), field, vehicle);
    } catch (const PlanInfeasible& infeasible) {
      ++refused;
      EXPECT_THAT(infeasible.what(), testing::ContainsRegex("at \\(.* m"));
    } catch (const InputError&) {
      continue;  // no field at all: holes that touch
    }
  }
  EXPECT_LE(refused, kMostRefused);
}

// Rows of trees nearer to each other than two turning circles: rounds around them merge.
TEST(RealSizes, AnOrchardIsPlannedWithRoundsThatCanBeFollowed) {
  Field field = field_of("orchard", rectangle_ring(0, 0, 100, 100));
  for (int column = 1; column <= 4; ++column) {
    for (int row = 1; row <= 4; ++row) {
      const Eigen::Vector2d at_W(20.0 * column + std::sin(7.0 * row + column),
                                 20.0 * row + std::cos(5.0 * column + row));
      field.obstacles.push_back({ObstacleKind::kTree, at_W, 0.3, 5.0});
    }
  }
  const Vehicle vehicle = load_vehicle("transplanter");
  const PlanRequest request = request_for(field, vehicle);
  for (const HeadlandRing& ring : make_headland(request, 3).rings) {
    EXPECT_GE(tightest_radius_m(ring.line_W, 0.2 * request.turning_radius_m),
              request.turning_radius_m);
  }
  expect_inside(path_for(request, vehicle), field, vehicle);
}

TEST(RealSizes, AnOutlineKeepsItsShapeWithFarFewerPoints) {
  constexpr int kPoints = 100000;
  Field field = field_of("round", regular_ring({0, 0}, 250.0, kPoints));
  field.holes = {reversed(regular_ring({50, 20}, 12.0, 5000))};
  const Field outline = simplified(field);
  // Chords with a sagitta of 1 cm: 4.5 m on the boundary, 1 m around the hole.
  EXPECT_LT(outline.boundary.size(), 1000U);
  ASSERT_EQ(outline.holes.size(), 1U);
  EXPECT_LT(outline.holes[0].size(), 300U);
  for (std::size_t i = 0; i < outline.boundary.size(); ++i) {
    const Eigen::Vector2d& a = outline.boundary[i];
    const Eigen::Vector2d& b = outline.boundary[(i + 1) % outline.boundary.size()];
    EXPECT_NEAR((0.5 * (a + b)).norm(), 250.0, kOutlineTolerance_m + 1e-6);
  }
  EXPECT_GT(signed_area_m2(outline.boundary), 0.0);
  EXPECT_LT(signed_area_m2(outline.holes[0]), 0.0);
}

TEST(RealSizes, ABoundaryOf100000PointsIsPlanned) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const Field field = field_of("round", regular_ring({0, 0}, 250.0, 100000));
  const Path path = path_for(request_for(field, vehicle), vehicle);
  EXPECT_TRUE(path.violations.empty());
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      ASSERT_LT(point.p_W.norm(), 250.0 - 0.5 * vehicle.body.width_m + kOverrun_m);
    }
  }
}

TEST(RealSizes, AZigzagOf10000PointsEnds) {
  Field field = field_of("zigzag", {{0, 0}});
  constexpr int kTeeth = 5000;
  for (int i = 0; i < kTeeth; ++i) {
    field.boundary.emplace_back(200.0 * (i + 0.5) / kTeeth, 3.0);
    field.boundary.emplace_back(200.0 * (i + 1.0) / kTeeth, 0.0);
  }
  field.boundary.emplace_back(200.0, 100.0);
  field.boundary.emplace_back(0.0, 100.0);
  const Vehicle vehicle = load_vehicle("transplanter");
  try {
    path_for(request_for(field, vehicle), vehicle);
    FAIL() << "teeth of 4 cm are no outline";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), testing::HasSubstr("still has 10003 points"));
  }
}

TEST(RealSizes, PlanningEndsWhenAskedTo) {
  const Vehicle vehicle = load_vehicle("transplanter");
  PlanRequest request = request_for(field_shapes()[5], vehicle);
  const PlannerEntry& planner = find_planner("boustrophedon", "test");
  int asked = 0;
  request.cancelled = [&asked] {
    ++asked;
    return false;
  };
  const Plan plan = planner.plan(request);
  const int times = asked;
  EXPECT_GT(times, 100);  // rounds, directions, cells
  // Wherever it is asked, planning ends.
  for (const int last : {0, times / 2, times - 1}) {
    asked = 0;
    request.cancelled = [&asked, last] { return asked++ == last; };
    EXPECT_THROW(planner.plan(request), Cancelled) << "asked " << last << " times before";
  }
  int looks = 0;
  make_path(request.field, vehicle, plan, {}, [&looks] {
    ++looks;
    return false;
  });
  EXPECT_GE(looks, static_cast<int>(plan.passes.size()));
  EXPECT_THROW(make_path(request.field, vehicle, plan, {}, [] { return true; }), Cancelled);
}

TEST(RealSizes, TheClearanceAskedForIsKept) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = field_of("square", rectangle_ring(0, 0, 90, 70));
  PlanRequest request = request_for(field, vehicle);
  for (const double clearance_m : {0.1, 1.0, 4.0}) {
    request.clearance_m = clearance_m;
    PathOptions options;
    options.clearance_m = clearance_m;
    const Path path = path_for(request, vehicle, options);
    EXPECT_TRUE(std::isinf(path.tightest.clearance_m)) << path.tightest.clearance_m;
    const FreeSpace space = free_space(field, hull_of(vehicle));
    for (const PathSegment& segment : path.segments) {
      for (const PathPoint& point : segment.points) {
        ASSERT_TRUE(fits(space, {point.p_W, point.heading_rad}, clearance_m - kFitTolerance_m));
      }
    }
  }
  request.clearance_m = 33.0;
  try {
    path_for(request, vehicle);
    FAIL() << "35 m from the middle to the nearest edge leave no round 33 m inside";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), testing::HasSubstr("clearance 33.00 m"));
    EXPECT_THAT(infeasible.what(), testing::HasSubstr("the widest is 70.0 m at ("));
  }
}

TEST(RealSizes, AWallInTheFieldIsWorkedAround) {
  const Vehicle vehicle = load_vehicle("transplanter");
  Field field = field_of("walled", rectangle_ring(0, 0, 56, 44));
  PlanRequest request = request_for(field, vehicle);
  const Path open = path_for(request, vehicle);
  field.obstacles = {{ObstacleKind::kWall, {20, 18}, 0.2, 1.5, {12, 3}},
                     {ObstacleKind::kWall, {32, 21}, 0.2, 1.5, {1, 6}}};
  request.field = field;
  const Path path = path_for(request, vehicle);
  const FreeSpace space = free_space(field, hull_of(vehicle));
  const auto hits = [&space](const Path& driven) {
    int count = 0;
    for (const PathSegment& segment : driven.segments) {
      for (const PathPoint& point : segment.points) {
        count += fits(space, {point.p_W, point.heading_rad}, -kFitTolerance_m) ? 0 : 1;
      }
    }
    return count;
  };
  EXPECT_EQ(hits(path), 0);
  EXPECT_GT(hits(open), 100) << "the wall is in the way of a plan that does not know it";
}

Plan two_swaths(double end_y_m) {
  Plan plan;
  plan.headland_width_m = 10.0;
  plan.passes = {{PassKind::kSwath, {{30, 20}, {30, end_y_m}}},
                 {PassKind::kSwath, {{42, end_y_m}, {42, 20}}}};
  return plan;
}

TEST(RealSizes, APassThatKeepsLessThanTheClearanceIsTold) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = field_of("square", rectangle_ring(0, 0, 90, 70));
  Plan plan;
  const double x_m = 0.5 * vehicle.body.width_m + 0.3;
  plan.passes = {{PassKind::kSwath, {{x_m, 20}, {x_m, 50}}}};
  PathOptions options;
  options.clearance_m = 1.0;
  const Path path = make_path(field, vehicle, plan, options);
  EXPECT_NEAR(path.tightest.clearance_m, 0.3, 1e-9);
  EXPECT_NEAR(path.tightest.p_W.x(), x_m, 1e-9);
}

TEST(RealSizes, APassWithoutLengthIsRefused) {
  Plan plan = two_swaths(50.0);
  plan.passes[1].points_W[1] = plan.passes[1].points_W[0];
  try {
    make_path(field_of("square", rectangle_ring(0, 0, 90, 70)), load_vehicle("transplanter"), plan,
              {});
    FAIL() << "accepted";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_STREQ(infeasible.what(), "pass 2 has no length");
  }
}

}  // namespace
}  // namespace headland

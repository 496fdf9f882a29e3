#include "evaluate/path_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "planner/drivable_path.h"
#include "planner/planned_vehicle.h"
#include "planner/planners.h"
#include "tests/terrains/refusal.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

Field square() {
  Field field;
  field.name = "square";
  field.boundary = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  return field;
}

// East along y = 10, then backwards along a circle to the left of radius 4 m.
Path good_path() {
  Path path;
  PathSegment line{PathKind::kSwath, Gear::kForward, true, 0, {}};
  for (int i = 0; i < 5; ++i) line.points.push_back({{10.0 + 0.25 * i, 10.0}, 0.0, 0.0});
  PathSegment bend{PathKind::kTurn, Gear::kReverse, false, 1, {}};
  constexpr double kRadius_m = 4.0;
  for (int i = 0; i < 5; ++i) {
    const double angle_rad = -0.0625 * i;
    bend.points.push_back(
        {Eigen::Vector2d(11.0, 10.0 + kRadius_m) +
             kRadius_m * Eigen::Vector2d(std::sin(angle_rad), -std::cos(angle_rad)),
         angle_rad, 1.0 / kRadius_m});
  }
  path.segments = {line, bend};
  return path;
}

std::string refused(const std::function<void(Path&)>& damage) {
  Path path = good_path();
  damage(path);
  return refusal([&] { check_path(path, square(), "path.geojson"); });
}

TEST(PathCheck, AcceptsWhatPlannersMake) {
  EXPECT_EQ(refused([](Path&) {}), "accepted");
  const Field field = square();
  const Vehicle vehicle = load_vehicle("transplanter");
  PlanRequest request;
  request.field = field;
  set_vehicle(request, vehicle);
  for (const PlannerEntry& planner : planners()) {
    request.parameters = resolve_parameters(planner.parameters, {}, "test", "");
    const Path path = make_path(field, vehicle, planner.plan(request), {});
    EXPECT_EQ(refusal([&] { check_path(path, field, "path.geojson"); }), "accepted")
        << planner.name;
  }
}

TEST(PathCheck, RefusesNumbersThatAreNone) {
  EXPECT_EQ(refused([](Path& path) {
              path.segments[0].points[1].p_W.x() = std::numeric_limits<double>::quiet_NaN();
            }),
            "path.geojson: feature 1, point 2: 'x nan m, y 10 m': a point within 1000 m of the "
            "field 'square'");
  EXPECT_EQ(refused([](Path& path) { path.segments[0].points[2].heading_rad = 1e300; }),
            "path.geojson: feature 1, point 3: 'heading_rad 1e+300': a heading from -100 to 100 "
            "rad");
  EXPECT_EQ(refused([](Path& path) { path.segments[1].points[4].curvature_per_m = 1e9; }),
            "path.geojson: feature 2, point 5: 'curvature_per_m 1e+09': a curvature from -10 to 10 "
            "per m");
}

TEST(PathCheck, RefusesPointsFarFromTheField) {
  EXPECT_EQ(refused([](Path& path) { path.segments[0].points[3].p_W.x() += 1e6; }),
            "path.geojson: feature 1, point 4: 'x 1000011 m, y 10 m': a point within 1000 m of the "
            "field 'square'");
  // Beyond the boundary alone is no fault of the file: the run tells what comes of it.
  EXPECT_EQ(refused([](Path& path) {
              for (PathSegment& segment : path.segments) {
                for (PathPoint& point : segment.points) point.p_W.x() -= 30.0;
              }
            }),
            "accepted");
}

TEST(PathCheck, RefusesALineOfOnePlace) {
  EXPECT_EQ(refused([](Path& path) {
              for (PathPoint& point : path.segments[0].points) point.p_W = {11.0, 10.0};
            }),
            "path.geojson: feature 1, point 1: all points of the line are the same; at least two "
            "different ones are needed");
}

TEST(PathCheck, RefusesHeadingsAndCurvaturesThatTheLineDoesNotHave) {
  EXPECT_EQ(
      refused([](Path& path) {
        for (PathPoint& point : path.segments[0].points) point.heading_rad = 2.0;
      }),
      "path.geojson: feature 1, point 2: 'heading_rad 2': the line from the point before runs "
      "at 0 rad: headings and points must agree within 0.5 rad");
  EXPECT_EQ(
      refused([](Path& path) {
        for (PathPoint& point : path.segments[0].points) point.curvature_per_m = 5.0;
      }),
      "path.geojson: feature 1, point 2: 'curvature_per_m 5': the headings turn by 0 rad over "
      "0.25 m: curvatures and headings must agree within 0.5 rad");
  // 0.6 per m over the straight metre: no step of it shows, all together do.
  EXPECT_EQ(
      refused([](Path& path) {
        for (PathPoint& point : path.segments[0].points) point.curvature_per_m = 0.6;
      }),
      "path.geojson: feature 1, point 5: 'curvature_per_m 0.6': the headings turn by 0 rad over "
      "1 m: curvatures and headings must agree within 0.5 rad");
  // The gear belongs to it: the same line driven forwards would be driven tail first.
  EXPECT_NE(refused([](Path& path) { path.segments[1].gear = Gear::kForward; }), "accepted");
}

TEST(PathCheck, RefusesLinesThatDoNotJoin) {
  EXPECT_EQ(refused([](Path& path) {
              for (PathPoint& point : path.segments[1].points) point.p_W.y() += 3.0;
            }),
            "path.geojson: feature 2, point 1: '3 m away': a line begins where the one before it "
            "ends");
}

}  // namespace
}  // namespace headland

#include "evaluate/line_headings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"

namespace headland {
namespace {

constexpr double kArcRadius_m = 4.0;
constexpr double kTightest_m = 3.9;

// Where the headings told from points alone are furthest from those they were drawn with [rad].
struct Errors {
  double at_points_rad = 0.0;
  double of_directions_rad = 0.0;  // of the edges themselves
};

Errors errors_of(const std::vector<Arc>& arcs) {
  const std::vector<PathPoint> points = sample({{3.0, -2.0}, 0.4}, arcs, kPathSpacing_m)[0].points;
  std::vector<Eigen::Vector2d> points_W;
  for (const PathPoint& point : points) points_W.push_back(point.p_W);
  const std::vector<EdgeHeading> edges = edge_headings(points_W, kTightest_m);
  Errors errors;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto off = [&](double heading_rad, std::size_t point) {
      return std::abs(wrap_angle(heading_rad - points[point].heading_rad));
    };
    errors.at_points_rad = std::max({errors.at_points_rad, off(heading_on(edges[i], 0.0), i),
                                     off(heading_on(edges[i], edges[i].length_m), i + 1)});
    errors.of_directions_rad = std::max(errors.of_directions_rad, off(edges[i].direction_rad, i));
  }
  return errors;
}

// Of arcs, of arcs that meet straight lines and of arcs that turn the other way, to rounding;
// directions of edges are half an edge's turn off, and the reading must be better for a reason.
TEST(LineHeadings, AreThoseOfTheCurveThatPointsWereTakenFrom) {
  constexpr double kRounding_rad = 1e-6;
  const double curvature = 1.0 / kArcRadius_m;
  const double half_edge_rad = 0.5 * kPathSpacing_m / kArcRadius_m;
  const std::vector<std::vector<Arc>> ways = {
      {{6.0, curvature}},
      {{5.0, 0.0}, {6.0, curvature}, {5.0, 0.0}},
      {{6.0, curvature}, {6.0, -curvature}},
      {{3.0, -curvature}, {2.0, 0.0}, {7.1, curvature}, {3.3, -curvature}}};
  for (const std::vector<Arc>& arcs : ways) {
    const Errors errors = errors_of(arcs);
    EXPECT_LT(errors.at_points_rad, kRounding_rad);
    EXPECT_GT(errors.of_directions_rad, 0.9 * half_edge_rad);
  }
}

TEST(LineHeadings, SharpAndTightCornersKeepTheirEdgesDirections) {
  const std::vector<Eigen::Vector2d> sharp = {{0, 0}, {10, 0}, {10, 10}};
  const std::vector<Eigen::Vector2d> tight = {{0, 0}, {0.3, 0}, {0.6, 0.09}};  // radius 1 m
  for (const auto& points_W : {sharp, tight}) {
    const std::vector<EdgeHeading> edges = edge_headings(points_W, kTightest_m);
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_DOUBLE_EQ(heading_on(edges[0], edges[0].length_m), edges[0].direction_rad);
    EXPECT_DOUBLE_EQ(heading_on(edges[1], 0.0), edges[1].direction_rad);
  }
  // Who may be as tight as that is headed between the two.
  const std::vector<EdgeHeading> edges = edge_headings(tight, 0.5);
  EXPECT_NEAR(heading_on(edges[1], 0.0), 0.5 * edges[1].direction_rad, 0.01);
}

// A bend of long edges is a curve near its corner alone.
TEST(LineHeadings, ABendOfLongEdgesIsShort) {
  const std::vector<Eigen::Vector2d> bend = {{0, 0}, {20, 0}, {40, 2}};
  const std::vector<EdgeHeading> edges = edge_headings(bend, kTightest_m);
  EXPECT_NEAR(heading_on(edges[0], 20.0), 0.5 * std::atan2(2.0, 20.0), 1e-3);
  EXPECT_DOUBLE_EQ(heading_on(edges[0], 10.0), 0.0);
  EXPECT_DOUBLE_EQ(heading_on(edges[0], 0.0), 0.0);
}

}  // namespace
}  // namespace headland

// Rows, a ring, and what every path has to be, as tests of paths use them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "planner/arcs.h"
#include "planner/free_space.h"
#include "planner/path.h"
#include "planner/plan.h"
#include "terrains/field.h"
#include "tests/planner/field_shapes.h"
#include "vehicle_models/vehicle.h"

namespace headland::test {

inline constexpr double kJoint_m = 1e-6;
inline constexpr double kJoint_rad = 1e-6;
inline constexpr double kRounding = 1e-9;

inline Field rectangle(double width_m, double height_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  return field;
}

// Up and down swaths of a rectangle with the same headland on every side.
inline Plan up_and_down(double width_m, double height_m, double working_width_m,
                        double headland_m) {
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

// A rounded square ring as planners make them: closed, cut open at its first point.
inline std::vector<Eigen::Vector2d> ring_m(double low_m, double high_m, double radius_m) {
  std::vector<Eigen::Vector2d> points;
  const std::vector<Eigen::Vector2d> centres = {{high_m - radius_m, low_m + radius_m},
                                                {high_m - radius_m, high_m - radius_m},
                                                {low_m + radius_m, high_m - radius_m},
                                                {low_m + radius_m, low_m + radius_m}};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    for (int i = 0; i <= 12; ++i) {
      const double angle_rad = kPi / 2.0 * (static_cast<double>(corner) - 1.0 + i / 12.0);
      points.push_back(centres[corner] + radius_m * direction_of(angle_rad));
    }
  }
  points.push_back(points.front());
  return points;
}

inline void expect_continuous(const Path& path, const Vehicle& vehicle) {
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

inline void expect_inside(const Path& path, const Field& field, const Vehicle& vehicle,
                          double clearance_m) {
  const FreeSpace space = free_space(field, hull_of(vehicle));
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      EXPECT_TRUE(fits(space, {point.p_W, point.heading_rad}, clearance_m))
          << point.p_W.transpose() << " in a " << path_kind_name(segment.kind);
    }
  }
}

}  // namespace headland::test

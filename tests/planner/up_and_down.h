// A rectangle and rows in it, as tests of paths drive them.
#pragma once

#include <vector>

#include "planner/plan.h"
#include "terrains/field.h"

namespace headland::test {

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
       x + 0.5 * working_width_m <= width_m - headland_m + 1e-9; x += working_width_m) {
    const Eigen::Vector2d low(x, headland_m);
    const Eigen::Vector2d high(x, height_m - headland_m);
    plan.passes.push_back({PassKind::kSwath, up ? std::vector<Eigen::Vector2d>{low, high}
                                                : std::vector<Eigen::Vector2d>{high, low}});
    up = !up;
  }
  return plan;
}

}  // namespace headland::test

// Rings for property tests.
#pragma once

#include <rapidcheck.h>
#include <cmath>
#include <numbers>

#include "terrains/field.h"

namespace headland {

// A number in [low, high] on a grid of a millionth of the range.
inline double any_number(double low, double high) {
  return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1000001);
}

// A counter-clockwise ring of 3 to 24 points around `middle`, 20 to 100 m from it: star-shaped, so
// never self-intersecting, and concave as a rule.
inline Ring any_ring(const Eigen::Vector2d& middle = Eigen::Vector2d::Zero()) {
  const int points = *rc::gen::inRange(3, 25);
  const double start_rad = any_number(0.0, 2.0 * std::numbers::pi);
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle_rad = start_rad + 2.0 * std::numbers::pi * i / points;
    ring.push_back(middle + any_number(20.0, 100.0) *
                                Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return ring;
}

}  // namespace headland

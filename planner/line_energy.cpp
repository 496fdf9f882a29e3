#include "planner/line_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "planner/turns.h"

namespace headland {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;

double height_m(const Heightfield* terrain, const Eigen::Vector2d& p_W) {
  return terrain == nullptr ? 0.0 : surface_at(*terrain, p_W.x(), p_W.y()).height_m;
}

}  // namespace

double line_wh(const SlopeCost& cost, const Heightfield* terrain, const Eigen::Vector2d& from_W,
               const Eigen::Vector2d& to_W) {
  const Eigen::Vector2d way = to_W - from_W;
  const double length_m = way.norm();
  if (length_m == 0.0) return 0.0;
  if (terrain == nullptr) return length_m * wh_per_m(cost, 0.0);
  const Eigen::Vector2d along_W = way / length_m;
  const Eigen::Vector2d left_W(-along_W.y(), along_W.x());
  const double wanted = std::ceil(length_m / kEnergyStep_m);
  const int steps = static_cast<int>(std::clamp(wanted, 1.0, 1.0 * kMostLineSteps));
  double sum_wh_per_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d p_W = from_W + way * ((i + 0.5) / steps);
    const Eigen::Vector2d gradient = surface_at(*terrain, p_W.x(), p_W.y()).gradient;
    sum_wh_per_m += wh_per_m(cost, gradient.dot(along_W), gradient.dot(left_W));
  }
  return length_m * sum_wh_per_m / steps;
}

double turn_wh(const DriveCost& cost, const std::vector<Arc>& arcs, double slope) {
  double quarters = 0.0;
  for (const Arc& arc : arcs) {
    quarters += arc.length_m * std::abs(0.5 * (arc.curvature_per_m + end_curvature_per_m(arc))) /
                kQuarter_rad;
  }
  const MovementCost& movement = cost.movement;
  return length_m(arcs) * wh_per_m(cost.raised, slope) + movement.cycle_wh +
         movement.quarter_wh * quarters + movement.cusp_wh * cusp_count(arcs);
}

double least_turn_wh(const DriveCost& cost, const Heightfield* terrain, const Pose& from,
                     const Pose& to) {
  const Gears gears = cost.forward_only ? Gears::kForwardOnly : Gears::kBoth;
  const double rise_m = height_m(terrain, to.p_W) - height_m(terrain, from.p_W);
  double least = std::numeric_limits<double>::infinity();
  for (const Turn& turn : turns(from, to, cost.turning_radius_m, gears)) {
    const double length = length_m(turn.arcs);
    least = std::min(least, turn_wh(cost, turn.arcs, length > 0.0 ? rise_m / length : 0.0));
  }
  return least;
}

}  // namespace headland

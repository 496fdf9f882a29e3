#include "planner/swath_objective.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/arcs.h"
#include "planner/segment.h"

namespace headland {
namespace {

double swath_wh(const SwathGrid& grid, const Swath& swath, double most_step_m,
                const DriveCost& cost, const Heightfield* terrain) {
  const double length = swath.to_m - swath.from_m;
  if (terrain == nullptr) return length * wh_per_m(cost.working, 0.0);
  const Eigen::Vector2d along(std::cos(grid.direction_rad), std::sin(grid.direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const int steps = std::max(1, static_cast<int>(std::ceil(length / most_step_m)));
  double sum_wh_per_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d p_W =
        point_on_line(grid, swath.line, swath.from_m + length * (i + 0.5) / steps);
    const Eigen::Vector2d gradient = surface_at(*terrain, p_W.x(), p_W.y()).gradient;
    const double uphill = gradient.dot(along);
    const double sideways = gradient.dot(across);
    sum_wh_per_m += 0.5 * (wh_per_m(cost.working, uphill, sideways) +
                           wh_per_m(cost.working, -uphill, sideways));
  }
  return length * sum_wh_per_m / steps;
}

// Whether a ray from p_W meets the segment ab between -within_m and within_m ahead.
bool meets(const Eigen::Vector2d& p_W, const Eigen::Vector2d& ray, const Eigen::Vector2d& a_W,
           const Eigen::Vector2d& b_W, double within_m) {
  const double across = cross(ray, b_W - a_W);
  if (across == 0.0) return false;
  const double ahead_m = cross(a_W - p_W, b_W - a_W) / across;
  const double along = cross(a_W - p_W, ray) / across;
  return std::abs(ahead_m) <= within_m && along >= 0.0 && along <= 1.0;
}

int ends_without_room(const SwathGrid& grid, const std::vector<NarrowEdge>& narrow,
                      double width_m) {
  const Eigen::Vector2d ray = direction_of(grid.direction_rad);
  int count = 0;
  for (const Swath& swath : grid.swaths) {
    for (const double end_m : {swath.from_m, swath.to_m}) {
      const Eigen::Vector2d p_W = point_on_line(grid, swath.line, end_m);
      const bool no_room = std::ranges::any_of(narrow, [&](const NarrowEdge& edge) {
        for (std::size_t i = 1; i < edge.line_W.size(); ++i) {
          const Eigen::Vector2d& a_W = edge.line_W[i - 1];
          const Eigen::Vector2d& b_W = edge.line_W[i];
          if (is_grazed(b_W - a_W, grid.direction_rad)) continue;
          if (meets(p_W, ray, a_W, b_W, edge.width_m + width_m)) return true;
        }
        return false;
      });
      count += no_room ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

SwathGridCost with_room_to_turn(SwathGridCost cost, std::vector<NarrowEdge> narrow, double width_m,
                                const SwathGround& ground) {
  if (narrow.empty()) return cost;
  return
      [cost = std::move(cost), narrow = std::move(narrow), width_m, ground](const SwathGrid& grid) {
        const double unworked_m = length_m(grid) - length_m(kept_within(grid, ground, width_m));
        return cost(grid) + kUnworkedCost * unworked_m +
               kNoRoomCost * ends_without_room(grid, narrow, width_m);
      };
}

SwathGridCost length_and_turns(double turn_m) {
  return [turn_m](const SwathGrid& grid) {
    return length_m(grid) + turn_m * static_cast<double>(grid.swaths.size());
  };
}

SwathGridCost fewest_turns() {
  return [](const SwathGrid& grid) {
    // No grid is so long that its length outweighs a turn.
    constexpr double kPerMetre = 1e-9;
    return static_cast<double>(grid.swaths.size()) + kPerMetre * length_m(grid);
  };
}

SwathGridCost least_length() {
  return [](const SwathGrid& grid) { return length_m(grid); };
}

SwathGridCost least_energy(const DriveCost& cost, const Heightfield* terrain) {
  return [&cost, terrain](const SwathGrid& grid) {
    const double step_m = std::max(kEnergyStep_m, length_m(grid) / kMostEnergySteps);
    const double turn_wh = energy_wh(cost, cheapest_row_turn(cost, grid.spacing_m));
    double sum_wh = turn_wh * static_cast<double>(grid.swaths.size());
    for (const Swath& swath : grid.swaths) sum_wh += swath_wh(grid, swath, step_m, cost, terrain);
    return sum_wh;
  };
}

}  // namespace headland

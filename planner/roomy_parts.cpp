#include "planner/roomy_parts.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

constexpr double kFinestPartCell_m = 0.15;
constexpr double kMostPartCells = 4e5;

}  // namespace

int RoomyParts::at(const Pose& pose) const {
  const Eigen::Vector2d middle_W = pose.p_W + middle_x_m * direction_of(pose.heading_rad);
  return part[static_cast<std::size_t>(cells.at(middle_W))];
}

RoomyParts roomy_parts(const FreeSpace& space, double clearance_m) {
  const Hull& hull = space.hull;
  const Eigen::Vector2d size = space.cell_m * Eigen::Vector2d(space.columns, space.rows);
  const double cell_m = std::max(kFinestPartCell_m, std::sqrt(size.prod() / kMostPartCells));
  RoomyParts parts;
  parts.middle_x_m = 0.5 * (hull.front_m - hull.rear_m);
  parts.cells = disc_cells(space, hull.half_width_m + clearance_m + kTightGap_m, cell_m);
  parts.part = disc_components(parts.cells);
  // A chassis that fits has its middle in one of these cells, though not in the middle of it.
  const DiscCells all = disc_cells(space, std::max(0.0, hull.half_width_m - cell_m), cell_m);
  parts.part = grown_components(all, std::move(parts.part));
  return parts;
}

}  // namespace headland

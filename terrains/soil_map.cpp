#include "terrains/soil_map.h"

namespace headland {

const Soil& soil_at(const SoilMap& map, const Eigen::Vector2d& p_W) {
  const Eigen::Vector2d cell = (p_W - map.origin_W) / map.cell_m;
  const bool inside =
      cell.x() >= 0.0 && cell.x() < map.columns && cell.y() >= 0.0 && cell.y() < map.rows;
  if (!inside) return map.soils.front();
  const auto column = static_cast<std::size_t>(cell.x());
  const auto row = static_cast<std::size_t>(cell.y());
  return map.soils[map.index[row * static_cast<std::size_t>(map.columns) + column]];
}

}  // namespace headland

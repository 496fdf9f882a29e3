// Soil over the field: one everywhere, or one per cell of a grid.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "terrains/soil.h"

namespace headland {

// Row j, column i of the grid covers the square of side cell_m whose lower left corner is
// origin_W + cell_m (i, j) and has soils[index[j * columns + i]]. Outside the grid, and with no
// grid, soils[0] holds.
struct SoilMap {
  std::vector<Soil> soils;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<std::uint16_t> index;
};

inline SoilMap uniform_soil(Soil soil) {
  SoilMap map;
  map.soils.push_back(std::move(soil));
  return map;
}

const Soil& soil_at(const SoilMap& map, const Eigen::Vector2d& p_W);

}  // namespace headland

// Rolling ground for tests.
#pragma once

#include <cmath>

#include "terrains/heightfield.h"

namespace headland {

// Waves of `amplitude_m` running north-east, `wavelength_m` long, over 400 m x 400 m from the
// south-west corner (-100, -100) m, on a plane that rises by `slope` to the east.
inline Heightfield waves(double amplitude_m, double wavelength_m, double slope = 0.0) {
  constexpr int kNodes = 201;
  Heightfield terrain;
  terrain.columns = terrain.rows = kNodes;
  terrain.cell_m = 2.0;
  terrain.origin_W = {-100.0, -100.0};
  for (int row = 0; row < kNodes; ++row) {
    for (int column = 0; column < kNodes; ++column) {
      const double along_m = terrain.cell_m * (column + row) * std::sqrt(0.5);
      terrain.height_m.push_back(amplitude_m * std::sin(2.0 * M_PI * along_m / wavelength_m) +
                                 slope * terrain.cell_m * column);
    }
  }
  return terrain;
}

}  // namespace headland

// Terrain heights on a regular grid, and the one surface they define.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace headland {

// Node (column i, row j) is at p_W = origin_W + cell_m * (i, j) with height
// height_m[j * columns + i]; columns run east, rows run north. At least 2 x 2 nodes, all finite.
struct Heightfield {
  int columns = 0;
  int rows = 0;
  double cell_m = 1.0;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  std::vector<double> height_m;

  double at(int column, int row) const {
    return height_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)];
  }
};

// Height and gradient of the terrain at a point. Past the edge of the grid the nearest edge's
// height holds and `inside` is false.
struct SurfacePoint {
  double height_m = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // dh/dx, dh/dy
  bool inside = false;
};

// THE surface of the project: two triangles a cell, split along the diagonal from (i+1, j) to
// (i, j+1), which is what Bullet's btHeightfieldTerrainShape collides with by default.
// Everything that needs a height (wheels, planners, pictures) asks here. Inline: it is called for
// every wheel in every step.
inline SurfacePoint surface_at(const Heightfield& terrain, double x_m, double y_m) {
  const double u = (x_m - terrain.origin_W.x()) / terrain.cell_m;
  const double v = (y_m - terrain.origin_W.y()) / terrain.cell_m;
  SurfacePoint point;
  point.inside = u >= 0.0 && v >= 0.0 && u <= terrain.columns - 1 && v <= terrain.rows - 1;
  // The negated test also sends NaN to a defined place.
  const double u_in = !(u > 0.0) ? 0.0 : std::min(u, terrain.columns - 1.0);
  const double v_in = !(v > 0.0) ? 0.0 : std::min(v, terrain.rows - 1.0);
  const int i = std::min(static_cast<int>(u_in), terrain.columns - 2);
  const int j = std::min(static_cast<int>(v_in), terrain.rows - 2);
  const double fu = u_in - i;
  const double fv = v_in - j;
  const double h10 = terrain.at(i + 1, j);
  const double h01 = terrain.at(i, j + 1);
  if (fu + fv <= 1.0) {
    const double h00 = terrain.at(i, j);
    point.height_m = h00 + fu * (h10 - h00) + fv * (h01 - h00);
    point.gradient = Eigen::Vector2d(h10 - h00, h01 - h00) / terrain.cell_m;
  } else {
    const double h11 = terrain.at(i + 1, j + 1);
    point.height_m = h11 + (1.0 - fu) * (h01 - h11) + (1.0 - fv) * (h10 - h11);
    point.gradient = Eigen::Vector2d(h11 - h01, h11 - h10) / terrain.cell_m;
  }
  return point;
}

}  // namespace headland

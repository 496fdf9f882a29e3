// Ground that is never worked or worked again, patch by patch.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "evaluate/coverage.h"

namespace headland {

// Workable cells that share edges and were never covered, or more than once.
struct GroundPatch {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // a cell of it, the nearest to its middle
  double area_m2 = 0.0;
};

// Those of at least `least_m2`, largest first, equals by place.
std::vector<GroundPatch> missed_patches(const CoverageRaster& raster, double least_m2);
std::vector<GroundPatch> overlapped_patches(const CoverageRaster& raster, double least_m2);

}  // namespace headland

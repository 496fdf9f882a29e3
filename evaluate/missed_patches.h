// Ground that is never worked, patch by patch.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "evaluate/coverage.h"

namespace headland {

// Workable cells that were never covered and share edges.
struct MissedPatch {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // a cell of it, the nearest to its middle
  double area_m2 = 0.0;
};

// Those of at least `least_m2`, largest first, equals by place.
std::vector<MissedPatch> missed_patches(const CoverageRaster& raster, double least_m2);

}  // namespace headland

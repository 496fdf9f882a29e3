// A grid map of a field: which squares of the working width lie wholly on ground to be worked.
#pragma once

#include "terrains/field.h"
#include "terrains/grid_map.h"

namespace headland {

// Free cells that cannot be reached from the rest and were blocked therefore.
struct GridPocket {
  GridCell first;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // middle of `first`
  int cells = 0;
};

struct FieldGrid {
  GridMap map;
  std::vector<GridPocket> pockets;
  double left_out_m2 = 0.0;  // of the field (without holes), in cells that are blocked
};

// Wu et al. 2023 (10.20944/preprints202305.1306.v1), 2.1: the box around the field along
// `direction_rad` is cut into squares of cell_m (2.1.1). What is irregular is dilated to whole
// cells (2.1.2): a cell through whose inside runs the boundary or a hole's edge, or that an
// obstacle touches, is blocked. Of the areas that are left, the one that is nearest to the field's
// entry is kept, without an entry the largest; the others are filled and reported. The paper also
// fills notches that could be driven into; here they stay free. No heights.
// Throws InputError: cell_m out of range, more than kMaxGridSide columns or rows, no cell that
// fits.
FieldGrid grid_of_field(const Field& field, double cell_m, double direction_rad,
                        const std::string& source);

// An edge must reach this far [m] into a cell to block it: borders of cells may be shared.
inline constexpr double kEdgeInside_m = 1e-6;

}  // namespace headland

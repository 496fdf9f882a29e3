// The parts into which a region is divided, each worked up and down in one piece.
#pragma once

#include <string_view>
#include <vector>

#include "planner/cancel.h"
#include "planner/polygon.h"

namespace headland {

// A part that lines along sweep_rad (0 to pi) meet in one piece. The outline is counter-clockwise,
// with points where the corners of its neighbours touch (decomposition.h).
struct RegionPart {
  Ring outline_W;
  double sweep_rad = 0.0;
};

struct RegionParts {
  std::vector<RegionPart> parts;
  std::vector<Ring> dropped_W;  // pieces too small to be worked
};
double area_m2(const RegionParts& parts);
double dropped_m2(const RegionParts& parts);

// How ground is cut (decomposition.h); cells of boustrophedon are swept along the slices, other
// pieces along their longest edge.
enum class Decomposition { kConvex, kTrapezoidal, kBoustrophedon };
std::string_view decomposition_name(Decomposition decomposition);

enum class SmallParts { kDrop, kMerge };

struct PartsOptions {
  Decomposition decomposition = Decomposition::kConvex;
  double slice_rad = -1.0;  // of slices; less than 0: least_width_direction_rad
  double width_m = 0.0;     // between the lines of sweeps, what merging counts
  double least_m2 = 0.0;    // smaller parts are not worth working
  SmallParts small = SmallParts::kDrop;
  bool merge = false;  // merge_parts after all else
};

// The ground's pieces with what merging and filtering leave. Throws InputError as polygon.h;
// Cancelled.
RegionParts region_parts(const PolygonSet& ground, const PartsOptions& options,
                         const CancelAsked& cancelled = {});

// Step 4 of the paper's decomposition: parts smaller than least_m2 are dropped.
void drop_small_parts(RegionParts& parts, double least_m2);

// The other way: from the smallest on, each goes to the neighbour with the longest common edge
// with which it is swept whole, in the neighbour's direction or else in that of an edge of both. A
// part that suits no neighbour stays what it is.
void merge_small_parts(RegionParts& parts, double least_m2, double width_m,
                       const CancelAsked& cancelled = {});

// Merges neighbours where one direction of sweep, that of either, serves both: the two together are
// swept whole and need no more lines width_m apart than apart (as Oksanen and Visala, 'Coverage
// path planning algorithms for agricultural field machines', 2009, merge trapezoids). The pair that
// saves most lines comes first, of equal ones that with the longest common edge, until no pair is
// left.
void merge_parts(RegionParts& parts, double width_m, const CancelAsked& cancelled = {});

}  // namespace headland

// The terrain as it is drawn.
#pragma once

#include <Eigen/Core>

#include "render/mesh.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"

namespace headland {

// Frame D of the pictures: x and y of W, heights from `base_m` and stretched by `exaggeration`.
// Taking the base off keeps single precision fine enough high above the sea.
struct Relief {
  double base_m = 0.0;
  double exaggeration = 1.0;
};

// Axis-parallel rectangle of W [m].
struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
  Eigen::Vector2d size() const { return high - low; }
  Eigen::Vector2d centre() const { return 0.5 * (low + high); }
};

Extent extent_of(const Ring& ring);
Extent extent_of(const Heightfield& terrain);
Extent grown(const Extent& extent, double by_m);
Extent overlap(const Extent& a, const Extent& b);

struct HeightRange {
  double low_m = 0.0;
  double high_m = 0.0;
};
// Over the nodes inside the extent.
HeightRange height_range(const Heightfield& terrain, const Extent& extent);

// 90th percentile of the slope (rise over run) over the nodes inside the extent.
double steep_slope(const Heightfield& terrain, const Extent& extent);

// The terrain's surface at p_W, in D.
Eigen::Vector3d on_ground(const Heightfield& terrain, const Relief& relief,
                          const Eigen::Vector2d& p_W);

// A line along the terrain's surface in D: `ring` with further points wherever its legs are longer
// than `spacing_m`, `lift_m` above the ground.
std::vector<Eigen::Vector3d> draped(const Heightfield& terrain, const Relief& relief,
                                    const std::vector<Eigen::Vector2d>& line, bool closed,
                                    double spacing_m, double lift_m);

// The terrain's surface inside the extent, in D, with at most kMaxNodes each way and, where the
// terrain is much finer than `spacing_m`, nodes about that far apart (the others are left out
// evenly).
inline constexpr int kMaxNodes = 1000;
Mesh relief_mesh(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                 Rgba colour, double spacing_m = 0.0);

// The same with every node near the centre and ever fewer with distance, as a camera near the
// centre sees them.
Mesh graded_relief_mesh(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                        const Eigen::Vector2d& centre_W, Rgba colour);

// Upright sides from the edge of that surface down to height z of D, as of a cut block of earth.
Mesh relief_sides(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                  double bottom_D, Rgba colour);

}  // namespace headland

// A field: boundary, holes, obstacles, entry point, in the local frame W.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "terrains/geo_frame.h"

namespace headland {

// Closed ring of points p_W [m]; the first point is not repeated at the end.
using Ring = std::vector<Eigen::Vector2d>;

enum class ObstacleKind { kTree, kPole, kRock, kWall, kFence };

// Something solid that stands upright on the terrain: all ground within radius_m of the point p_W
// or, of walls and fences, of the straight piece from p_W to p_W + run_W.
struct Obstacle {
  ObstacleKind kind = ObstacleKind::kTree;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double radius_m = 0.3;  // of walls and fences half the thickness
  double height_m = 5.0;
  Eigen::Vector2d run_W = Eigen::Vector2d::Zero();
};

// The boundary runs counter-clockwise, holes run clockwise, no ring touches or crosses another or
// itself, every hole, tree, pole and rock lies inside the boundary: the readers establish this
// (check_field). Walls and fences may also run along it or beyond. A hole is ground that may
// neither be worked nor driven on.
struct Field {
  std::string name;
  Ring boundary;
  std::vector<Ring> holes;
  std::vector<Obstacle> obstacles;
  std::optional<Eigen::Vector2d> entry_W;
  GeoFrame frame;
  // Outlines of the ground to be worked where that is less than the whole field, as of grid maps:
  // what an odd number of them encloses. Empty: all of it.
  std::vector<Ring> to_work;
};

// Signed area [m2] of a ring, positive when counter-clockwise (shoelace).
double signed_area_m2(const Ring& ring);

// Boundary minus holes [m2]; obstacles are not subtracted.
double field_area_m2(const Field& field);

// Whether p_W is inside a ring.
bool inside_ring(const Ring& ring, const Eigen::Vector2d& p_W);

// Whether p_W is inside the boundary and outside every hole.
bool inside_field(const Field& field, const Eigen::Vector2d& p_W);

// Distance [m] from p_W to the nearest boundary or hole edge, positive inside the field and
// negative outside it or in a hole.
double field_clearance_m(const Field& field, const Eigen::Vector2d& p_W);

// The point of the obstacle's middle line nearest to p_W, and the distance [m] from p_W to its
// side, negative inside it.
Eigen::Vector2d nearest_of(const Obstacle& obstacle, const Eigen::Vector2d& p_W);
double obstacle_gap_m(const Obstacle& obstacle, const Eigen::Vector2d& p_W);

inline constexpr std::array kEveryObstacleKind = {ObstacleKind::kTree, ObstacleKind::kPole,
                                                  ObstacleKind::kRock, ObstacleKind::kWall,
                                                  ObstacleKind::kFence};
std::string_view obstacle_kind_name(ObstacleKind kind);
// Whether it stands along a line (walls and fences) and not at a point.
inline bool runs_along_line(ObstacleKind kind) {
  return kind == ObstacleKind::kWall || kind == ObstacleKind::kFence;
}

}  // namespace headland

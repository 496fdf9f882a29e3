// A field: boundary, holes, obstacles, entry point, in the local frame W.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "terrains/geo_frame.h"

namespace headland {

// Closed ring of points p_W [m]; the first point is not repeated at the end.
using Ring = std::vector<Eigen::Vector2d>;

enum class ObstacleKind { kTree, kPole, kRock };

// A solid upright cylinder on the terrain.
struct Obstacle {
  ObstacleKind kind = ObstacleKind::kTree;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double radius_m = 0.3;
  double height_m = 5.0;
};

// The boundary runs counter-clockwise, holes run clockwise, no ring touches or crosses another or
// itself, every hole and obstacle lies inside the boundary: the readers establish this
// (check_field). A hole is ground that may neither be worked nor driven on.
struct Field {
  std::string name;
  Ring boundary;
  std::vector<Ring> holes;
  std::vector<Obstacle> obstacles;
  std::optional<Eigen::Vector2d> entry_W;
  GeoFrame frame;
};

// Signed area [m2] of a ring, positive when counter-clockwise (shoelace).
double signed_area_m2(const Ring& ring);

// Boundary minus holes [m2]; obstacles are not subtracted.
double field_area_m2(const Field& field);

// Whether p_W is inside the boundary and outside every hole.
bool inside_field(const Field& field, const Eigen::Vector2d& p_W);

// Distance [m] from p_W to the nearest boundary or hole edge, positive inside the field and
// negative outside it or in a hole.
double field_clearance_m(const Field& field, const Eigen::Vector2d& p_W);

std::string_view obstacle_kind_name(ObstacleKind kind);

}  // namespace headland

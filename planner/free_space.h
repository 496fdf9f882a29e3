// Where a vehicle's hull may be: inside the boundary, outside holes, clear of obstacles.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "planner/arcs.h"
#include "planner/hull.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// A hull that protrudes by less than this [m] is taken as fitting, on passes and in turns alike:
// planners lay passes along limits, and boundaries are simplified by as much (outline.h).
inline constexpr double kFitTolerance_m = 0.01;

// Obstacles are kept so many times as far away as boundary and holes: touching one ends a run, and
// besides the driver's error in turns, where steering takes its time, they meet a hull that leans
// (0.2 m and 0.1 m on slopes of 6 %, measured with polygon_bench drive).
inline constexpr double kObstacleClearances = 3.0;

enum class Limit { kNone, kBoundary, kHole, kObstacle };

// Edges and obstacles of a field in a grid of square cells, made once by free_space(). Each cell
// lists what touches it and has the distance from its centre to the nearest of all.
struct WorkedGround;

struct FreeSpace {
  struct Edge {
    Eigen::Vector2d a_W;
    Eigen::Vector2d b_W;
    Limit limit = Limit::kBoundary;
  };
  struct Cell {
    float edge_distance_m = 0.0F;  // negative outside the field or in a hole
    float obstacle_distance_m = 0.0F;
    std::vector<int> edges;
    std::vector<int> obstacles;
  };
  Hull hull;
  double reach_m = 0.0;  // of the hull, see hull.h
  double reach_with_bar_m = 0.0;
  std::vector<Edge> edges;
  std::vector<Obstacle> obstacles;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<Cell> cells;  // row by row
  // Ground that wheels keep off as well; not owned; null: none.
  const WorkedGround* worked = nullptr;
};

// The field as it is, edge by edge. 0.1 s for 100 000 edges.
FreeSpace free_space(const Field& field, const Hull& hull);

// Whether p_W is inside the boundary and outside every hole.
bool inside(const FreeSpace& space, const Eigen::Vector2d& p_W);

// The edge nearest to any place, inside the field or not.
struct NearestEdge {
  double distance_m = 0.0;
  int edge = 0;  // index into FreeSpace::edges
};
NearestEdge nearest_edge(const FreeSpace& space, const Eigen::Vector2d& p_W);

// Whether the hull keeps `clearance_m` (>= -kFitTolerance_m) from boundary and holes at this pose,
// and kObstacleClearances times as much from obstacles, and its wheels keep off worked ground.
// Under 1 us.
bool fits(const FreeSpace& space, const Pose& pose, double clearance_m);

// Whether every wheel stands beside `worked`.
bool keeps_off_worked(const FreeSpace& space, const Pose& pose);

// How much more [m] than the clearance the hull keeps from everything, at most `most_m` (>= 0);
// negative where it does not fit. Worked ground does not count.
double spare_m(const FreeSpace& space, const Pose& pose, double clearance_m, double most_m);

// Whether the implement at this pose works inside the boundary and outside holes, but for
// `overhang_m` (>= 0, to within kFitTolerance_m) at both of its ends.
bool works_inside(const FreeSpace& space, const Pose& pose, double overhang_m);

// The clearance [m] the hull keeps so, at most `most_m` (>= 0); negative by how far it protrudes.
double clearance_m(const FreeSpace& space, const Pose& pose, double most_m);

// Whether a disc does, without the implement.
bool disc_fits(const FreeSpace& space, const Eigen::Vector2d& p_W, double radius_m);

// A lower bound [m] on the way the hull can move from here, in any direction, and still fit with
// no clearance. Negative or small near limits whether it fits or not.
double safe_distance_m(const FreeSpace& space, const Pose& pose);

// How far [m] the hull protrudes at this pose, 0 when it fits: the depth of its corners beyond the
// limits, or of the limits inside the hull where no corner is beyond. With the deepest place.
struct Overrun {
  double depth_m = 0.0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  Limit limit = Limit::kNone;
};
Overrun overrun(const FreeSpace& space, const Pose& pose);

// The first boundary or hole edge that a ray from p_W meets: how far away, and its unit normal
// pointing out of the field. Distance is the largest double where it meets none.
struct EdgeAhead {
  double distance_m = 0.0;
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();
};
EdgeAhead edge_ahead(const FreeSpace& space, const Eigen::Vector2d& p_W, double heading_rad);

}  // namespace headland

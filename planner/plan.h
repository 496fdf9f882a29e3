// A plan: what to cover and in which order. No time, no vehicle dynamics.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "planner/cancel.h"
#include "planner/polygon.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "terrains/parameter.h"

namespace headland {

enum class PassKind { kSwath, kHeadlandPass };

// A line p_W [m] along which the middle of the implement works, from front() to back(). A swath
// has two points, a headland pass is a rounded ring cut open, never tighter than the radius of the
// request.
struct Pass {
  PassKind kind = PassKind::kSwath;
  std::vector<Eigen::Vector2d> points_W;
  bool optional = false;  // left out where no turn leads there and away
};

// How many headland passes an edge of the field gets, where that is not as many as the others get.
// It is named by a place on it, or by number (headland_edges.h).
struct EdgeHeadland {
  std::optional<Eigen::Vector2d> at_W;
  int hole = 0;               // 0: the boundary
  int edge = 0;               // 0: all edges of that ring
  std::optional<int> passes;  // 0: none; without it as many as are width_m wide
  double width_m = 0.0;
};

// An edge of a plan with its headland.
struct PlannedEdge {
  int hole = 0;
  int edge = 0;
  int passes = 0;
  double width_m = 0.0;
  Eigen::Vector2d from_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_W = Eigen::Vector2d::Zero();
};

struct DriveCost;

struct PlanRequest {
  Field field;
  const Heightfield* terrain = nullptr;  // not owned; may be null for planners that are flat
  double working_width_m = 0.0;
  double turning_radius_m = 0.0;  // planning radius of the vehicle
  double vehicle_width_m = 0.0;   // hull, without implement
  double vehicle_front_m = 0.0;   // hull ahead of B's origin
  double vehicle_rear_m = 0.0;    // hull behind it
  double implement_x_B_m = 0.0;   // of the working line; negative: behind B's origin
  bool forward_only = false;      // cannot turn with reverse gear (see arcs.h)
  double clearance_m = 0.1;       // to be kept between hull and boundary, holes and obstacles
  // Through A and B, along which and with which in line swaths are laid; none: by parameters.
  std::optional<std::array<Eigen::Vector2d, 2>> ab_line_W;
  std::vector<EdgeHeadland> headland_edges;  // empty: all edges alike, by parameters
  Parameters parameters;                     // resolved against the planner's specs
  std::uint64_t seed = 1;
  const DriveCost* cost = nullptr;  // measured ones; not owned; null: none
  CancelAsked cancelled;            // ends planning with Cancelled
};

// What of its planner's choices may help where no turn fits, for refusals.
struct TurnRemedies {
  bool has_headland = true;           // that could be wider
  std::vector<std::string> off_rows;  // where wheels are to keep off rows
};

struct Plan {
  std::string planner;
  TurnRemedies remedies;
  std::vector<Pass> passes;
  double swath_direction_rad = 0.0;         // of the first swath's line, 0..pi
  double headland_width_m = 0.0;            // where it is widest
  double planned_length_m = 0.0;            // of the passes alone
  std::vector<PlannedEdge> headland_edges;  // where the request names some: all
  // What swaths are not cut back into; none: the field without headland_width_m along its edges.
  std::optional<PolygonSet> kept_whole;
};

// No plan or no drivable path exists for this request; what() says why and what would help.
struct PlanInfeasible : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string_view pass_kind_name(PassKind kind);

}  // namespace headland

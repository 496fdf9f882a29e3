// Parallel swaths over the ground inside the headland, and their best direction.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "planner/plan.h"
#include "planner/polygon.h"

namespace headland {

// More lines than this across one field are refused: a unit gone wrong, not a field.
inline constexpr int kMaxSwathLines = 20000;
// Angle between the directions tried besides those of the field's edges.
inline constexpr double kDirectionGrid_deg = 1.0;

// A swath on line `line` from along = from_m to along = to_m, from_m < to_m.
struct Swath {
  int line = 0;
  double from_m = 0.0;
  double to_m = 0.0;
};

// Lines in direction `direction_rad`, 0..pi, `spacing_m` apart; swaths by line, then along it.
struct SwathGrid {
  double direction_rad = 0.0;
  double first_line_m = 0.0;  // of line 0 across the direction, to its left
  double spacing_m = 0.0;
  int lines = 0;
  std::vector<Swath> swaths;
};

// p_W of a place on a line.
Eigen::Vector2d point_on_line(const SwathGrid& grid, int line, double along_m);

double length_m(const SwathGrid& grid);

// Length [m] of the shortest turn from a swath onto the next for turning radius R: U-turn
// w + (pi - 2) R where w >= 2 R, else three-point turn (pi + 2) R - w.
double turn_length_m(double width_m, double turning_radius_m);

// Ground that swaths are laid on.
struct SwathGround {
  PolygonSet inner{};     // to be covered
  PolygonSet drivable{};  // where the middle of a swath may run
  PolygonSet beyond{};    // what no implement may work; empty where none gets there
};

// Covers ground.inner with strips of width_m. As many lines as the width needs, spread evenly: what
// is left over of the last strip becomes an equal overlap of all, which tracking errors use up
// before they leave gaps. A swath reaches as far as the ground anywhere across its strip does, not
// just on its middle line, so slanted ends are covered. Swaths on one line are joined where the gap
// is at most bridge_m and the line between them runs in ground.drivable. With `through_m` one line,
// there or extended, lies at that distance to the left of the origin of W, and lines are width_m
// apart: those of a guidance line. Without it the first and the last strip are laid flush with the
// outermost ground, and all overlap is between lines, where that keeps them off ground.beyond.
// Throws PlanInfeasible for more than kMaxSwathLines lines.
SwathGrid lay_swaths(const SwathGround& ground, double direction_rad, double width_m,
                     double bridge_m, std::optional<double> through_m = std::nullopt);

// Swaths as far as the middle of each runs in ground.drivable and a strip of width_m keeps off
// ground.beyond; pieces shorter than kLeastKept_m are left out.
SwathGrid kept_within(const SwathGrid& grid, const SwathGround& ground, double width_m);
inline constexpr double kLeastKept_m = 2.0;

// What a grid of swaths costs, less being better (swath_objective.h).
using SwathGridCost = std::function<double(const SwathGrid&)>;

// The grid of least cost, over the directions of all edges of the field (longest first) and
// kDirectionGrid_deg steps from the longest. Of equal ones the first. Throws Cancelled.
SwathGrid best_swaths(const Field& field, const SwathGround& ground, double width_m,
                      double bridge_m, const SwathGridCost& cost,
                      const CancelAsked& cancelled = {});

}  // namespace headland

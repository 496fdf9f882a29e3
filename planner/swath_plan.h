// Swaths as a request's parameters ask for them: their direction and their order.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/headland_edges.h"
#include "planner/plan.h"
#include "planner/polygon.h"
#include "planner/swath_cells.h"
#include "planner/swaths.h"

namespace headland {

// `swath_direction_deg`, `swath_objective`, `swath_order` and `swath_skip`, for tables of planners.
std::span<const ParameterSpec> swath_parameters();

// Throws InputError(source, "where.swath_skip", ...) where it is given and `swath_order` leaves no
// swaths between.
void check_swath_parameters(const Parameters& parameters, const std::string& source,
                            const std::string& where);

// The lines of ab_line_W where the request has one, else in `swath_direction_deg`, else in the
// direction that is best by `swath_objective` (swath_objective.h). Throws InputError for an A-B
// line that does not come into the field, or with a direction besides it, and for energy without
// costs; PlanInfeasible as lay_swaths; Cancelled. A direction in which swaths run into `narrow`
// edges is the best one only where all do.
SwathGrid chosen_swaths(const PlanRequest& request, const SwathGround& ground,
                        const std::vector<NarrowEdge>& narrow = {});

// What that direction is best by.
SwathGridCost swath_cost(const PlanRequest& request, const SwathGround& ground,
                         const std::vector<NarrowEdge>& narrow);

// Cells of the grid with their swaths in the sequence of `swath_order` (of `optimised`: as they
// lie).
std::vector<SwathCell> patterned_cells(const SwathGrid& grid, const PlanRequest& request);

// Whether the order of swaths is improved one by one: `swath_order` optimised, or auto where the
// request has measured costs.
bool is_optimised(const PlanRequest& request);

// optimised_order by what the request's turns cost, in metres or by its measured costs.
std::vector<Pass> improved_order(std::vector<Pass> swaths, const PlanRequest& request,
                                 const std::optional<Eigen::Vector2d>& start_W);

// The passes of the grid by `swath_order`. Swaths cut by holes are grouped into cells (cells_of),
// each driven in one of the patterns of swath_pattern.h, in a short order of the cells
// (order_cells); `optimised` takes the better of going up and down and of leaving swaths between,
// and improves it swath by swath (optimised_order), by the request's measured costs if it has some.
// `start_W` is where the vehicle comes from. Throws Cancelled.
std::vector<Pass> ordered_swaths(const SwathGrid& grid, const PlanRequest& request,
                                 const std::optional<Eigen::Vector2d>& start_W);

}  // namespace headland

#include "planner/swath_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/arcs.h"
#include "planner/segment.h"
#include "planner/swath_cells.h"
#include "planner/swath_objective.h"
#include "planner/swath_order.h"
#include "planner/swath_pattern.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr double kShortestGuide_m = 1.0;
constexpr double kGuideStep_m = 0.5;  // between places of an A-B line looked at

[[noreturn]] void refuse_guide(const std::array<Vector2d, 2>& line, const std::string& allowed) {
  throw InputError("plan", "ab_line",
                   fmt::format("({:.1f}, {:.1f}) to ({:.1f}, {:.1f}) m", line[0].x(), line[0].y(),
                               line[1].x(), line[1].y()),
                   allowed);
}

SwathGrid swaths_along(const std::array<Vector2d, 2>& line, const PlanRequest& request,
                       const SwathGround& ground, double bridge_m) {
  const Vector2d run = line[1] - line[0];
  if (!(run.norm() >= kShortestGuide_m)) {
    refuse_guide(line, fmt::format("A and B must be {:g} m apart or more", kShortestGuide_m));
  }
  const int steps = static_cast<int>(std::ceil(std::min(1e6, run.norm() / kGuideStep_m)));
  bool inside = false;
  for (int i = 0; i <= steps && !inside; ++i) {
    inside = inside_field(request.field, line[0] + run * i / steps);
  }
  if (!inside) refuse_guide(line, "lies outside the field; it must lead through it");
  const double direction_rad = line_direction_rad(run);
  const double through_m = left_of(direction_rad).dot(line[0]);
  return lay_swaths(ground, direction_rad, request.working_width_m, bridge_m, through_m);
}

bool by_energy(const PlanRequest& request) {
  return request.cost != nullptr && !request.cost->row_turns.empty();
}

TurnCosts turn_costs(const PlanRequest& request) {
  return {request.turning_radius_m, request.forward_only ? Gears::kForwardOnly : Gears::kBoth,
          request.cost, request.terrain};
}

std::size_t skip_of(const SwathGrid& grid, const PlanRequest& request) {
  const auto asked = number_unless_word(request.parameters, "swath_skip");
  return asked ? static_cast<std::size_t>(*asked)
               : skip_for_u_turns(grid.spacing_m, request.turning_radius_m);
}

std::vector<SwathCell> cells_in(const SwathGrid& grid, SwathPattern pattern,
                                const PlanRequest& request) {
  std::vector<SwathCell> cells = cells_of(grid);
  for (SwathCell& cell : cells) {
    SwathCell in_sequence;
    for (const std::size_t at : swath_sequence(cell.size(), pattern, skip_of(grid, request))) {
      in_sequence.push_back(cell[at]);
    }
    cell = std::move(in_sequence);
  }
  return cells;
}

std::vector<Pass> passes_by(const SwathGrid& grid, const std::vector<SwathCell>& cells,
                            const std::optional<Vector2d>& start_W, const CancelAsked& cancelled) {
  std::vector<Pass> passes;
  for (const CellVisit& visit : order_cells(grid, cells, start_W, cancelled)) {
    for (Pass& pass : passes_of(grid, cells[visit.cell], visit)) passes.push_back(std::move(pass));
  }
  return passes;
}

}  // namespace

std::span<const ParameterSpec> swath_parameters() {
  static const std::array<ParameterSpec, 4> kParameters{{
      {"swath_direction_deg",
       std::string("auto"),
       0.0,
       360.0,
       {"auto"},
       "direction of the swaths, counter-clockwise from east; auto: the best one"},
      {"swath_objective",
       std::string("auto"),
       0.0,
       0.0,
       {"auto", "length_and_turns", "turns", "length", "energy"},
       "what the best direction has least of; auto: energy with measured costs, which it needs, "
       "else length_and_turns"},
      {"swath_order",
       std::string("auto"),
       0.0,
       0.0,
       {"auto", "boustrophedon", "skip", "spiral", "optimised"},
       "next to next, with some left between, from both sides inwards, or by what turns cost; "
       "auto: by that with measured costs, else next to next"},
      {"swath_skip",
       std::string("auto"),
       1.0,
       20.0,
       {"auto"},
       "swaths left between two with swath_order skip or optimised; auto: as many as a U-turn "
       "needs",
       true},
  }};
  return kParameters;
}

void check_swath_parameters(const Parameters& parameters, const std::string& source,
                            const std::string& where) {
  const auto skip = number_unless_word(parameters, "swath_skip");
  const std::string& order = word(parameters, "swath_order");
  if (!skip || order == "skip" || order == "optimised") return;
  throw InputError(source, key_path(where, "swath_skip"), fmt::format("{}", *skip),
                   fmt::format("only with swath_order skip or optimised, not with {}", order));
}

namespace {

SwathGridCost objective_of(const PlanRequest& request) {
  const std::string& objective = word(request.parameters, "swath_objective");
  if (objective == "turns") return fewest_turns();
  if (objective == "length") return least_length();
  const bool energy = objective == "energy" || (objective == "auto" && by_energy(request));
  if (!energy) {
    return length_and_turns(turn_length_m(request.working_width_m, request.turning_radius_m));
  }
  if (!by_energy(request)) {
    throw InputError("plan", "swath_objective", objective,
                     "needs measured costs with turns between rows: headland measure, then --cost "
                     "or planner.cost");
  }
  return least_energy(*request.cost, request.terrain);
}

SwathGrid laid_swaths(const PlanRequest& request, const SwathGround& ground,
                      const std::vector<NarrowEdge>& narrow) {
  const double width_m = request.working_width_m;
  const double turn_m = turn_length_m(width_m, request.turning_radius_m);
  const auto direction_deg = number_unless_word(request.parameters, "swath_direction_deg");
  if (request.ab_line_W) {
    if (direction_deg) {
      refuse_guide(*request.ab_line_W, "not together with swath_direction_deg");
    }
    return swaths_along(*request.ab_line_W, request, ground, turn_m);
  }
  if (direction_deg) {
    return lay_swaths(ground, std::fmod(*direction_deg, 180.0) * std::numbers::pi / 180.0, width_m,
                      turn_m);
  }
  return best_swaths(request.field, ground, width_m, turn_m, swath_cost(request, ground, narrow),
                     request.cancelled);
}

}  // namespace

SwathGridCost swath_cost(const PlanRequest& request, const SwathGround& ground,
                         const std::vector<NarrowEdge>& narrow) {
  return with_room_to_turn(objective_of(request), narrow, request.working_width_m, ground);
}

SwathGrid chosen_swaths(const PlanRequest& request, const SwathGround& ground,
                        const std::vector<NarrowEdge>& narrow) {
  SwathGrid grid = laid_swaths(request, ground, narrow);
  // Without a headland only an edge itself ends what swaths reach.
  return narrow.empty() ? grid : kept_within(grid, ground, request.working_width_m);
}

std::vector<SwathCell> patterned_cells(const SwathGrid& grid, const PlanRequest& request) {
  const std::string& order = word(request.parameters, "swath_order");
  if (order == "skip") return cells_in(grid, SwathPattern::kSkip, request);
  if (order == "spiral") return cells_in(grid, SwathPattern::kSpiral, request);
  return cells_in(grid, SwathPattern::kNext, request);
}

bool is_optimised(const PlanRequest& request) {
  const std::string& order = word(request.parameters, "swath_order");
  return order == "optimised" || (order == "auto" && by_energy(request));
}

std::vector<Pass> improved_order(std::vector<Pass> swaths, const PlanRequest& request,
                                 const std::optional<Vector2d>& start_W) {
  return optimised_order(std::move(swaths), start_W, turn_costs(request), request.cancelled);
}

std::vector<Pass> ordered_swaths(const SwathGrid& grid, const PlanRequest& request,
                                 const std::optional<Vector2d>& start_W) {
  const CancelAsked& cancelled = request.cancelled;
  if (!is_optimised(request)) {
    return passes_by(grid, patterned_cells(grid, request), start_W, cancelled);
  }
  const TurnCosts costs = turn_costs(request);
  std::vector<Pass> best;
  for (const SwathPattern pattern : {SwathPattern::kNext, SwathPattern::kSkip}) {
    std::vector<Pass> made = passes_by(grid, cells_in(grid, pattern, request), start_W, cancelled);
    made = improved_order(std::move(made), request, start_W);
    if (best.empty() || order_cost(made, start_W, costs) < order_cost(best, start_W, costs)) {
      best = std::move(made);
    }
  }
  return best;
}

}  // namespace headland

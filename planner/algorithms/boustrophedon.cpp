#include "planner/algorithms/boustrophedon.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "planner/headland_rings.h"
#include "planner/outline.h"
#include "planner/round_begin.h"
#include "planner/swath_cells.h"
#include "planner/swaths.h"
#include "planner/turns.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Rounds inside an outline of more points, all teeth, would take minutes.
constexpr std::size_t kMostPoints = 3000;

void check_request(const PlanRequest& request) {
  const auto positive = [](const char* key, double value_m) {
    if (!(value_m > 0.0) || !std::isfinite(value_m)) {
      throw InputError("plan", key, fmt::format("{}", value_m), "a length above 0 m");
    }
  };
  positive("working_width_m", request.working_width_m);
  positive("turning_radius_m", request.turning_radius_m);
  positive("vehicle_width_m", request.vehicle_width_m);
  std::size_t points = request.field.boundary.size();
  for (const Ring& hole : request.field.holes) points += hole.size();
  if (points > kMostPoints) {
    const Eigen::Vector2d& at_W = request.field.boundary.front();
    throw PlanInfeasible(fmt::format(
        "the outline around ({:.1f}, {:.1f}) m still has {} points when simplified to {} m, more "
        "than {}; draw it with fewer",
        at_W.x(), at_W.y(), points, kOutlineTolerance_m, kMostPoints));
  }
  const double widest_m = 2.0 * widest_disc(from_field(request.field)).radius_m;
  const auto narrow = [&](const char* key, double value_m) {
    if (value_m <= widest_m) return;
    throw InputError("plan", key, fmt::format("{}", value_m),
                     fmt::format("wider than the field '{}' anywhere; at most {:.1f} m",
                                 request.field.name, widest_m));
  };
  narrow("working_width_m", request.working_width_m);
  narrow("vehicle_width_m", request.vehicle_width_m);
}

SwathGrid make_swaths(const PlanRequest& request, const Headland& headland) {
  const auto direction_deg = number_unless_word(request.parameters, "swath_direction_deg");
  if (!direction_deg) {
    return best_swaths(request.field, headland.inner, headland.drivable, request.working_width_m,
                       request.turning_radius_m, request.cancelled);
  }
  return lay_swaths(headland.inner, headland.drivable,
                    std::fmod(*direction_deg, 180.0) * std::numbers::pi / 180.0,
                    request.working_width_m,
                    turn_length_m(request.working_width_m, request.turning_radius_m));
}

void append_swaths(const SwathGrid& grid, const std::optional<Eigen::Vector2d>& start_W,
                   const CancelAsked& cancelled, std::vector<Pass>& passes) {
  const std::vector<SwathCell> cells = cells_of(grid);
  for (const CellVisit& visit : order_cells(grid, cells, start_W, cancelled)) {
    for (Pass& pass : passes_of(grid, cells[visit.cell], visit)) passes.push_back(std::move(pass));
  }
}

std::optional<Eigen::Vector2d> end_of(const std::vector<Pass>& passes,
                                      const std::optional<Eigen::Vector2d>& entry_W) {
  if (passes.empty()) return entry_W;
  return passes.back().points_W.back();
}

double heading_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

Pose end_pose(const Pass& pass) {
  const Polyline& line = pass.points_W;
  return {line.back(), heading_of(line.back() - line[line.size() - 2])};
}

// How a round is best begun, and at what cost.
struct RoundChoice {
  RoundBegin begin;
  double cost_m = std::numeric_limits<double>::infinity();
};

// Where a vehicle at the end of `before` best joins `round`: the shortest forward curve, or, where
// nothing has been driven yet, the nearest point. Nothing that costs `enough_m` is looked for.
RoundChoice best_begin(const Polyline& round, const Pass* before, const Eigen::Vector2d& from_W,
                       double turning_radius_m, double enough_m) {
  RoundChoice best;
  const std::size_t count = round.size() - 1;
  for (const RoundBegin& begin : round_begins(round, from_W)) {
    const Eigen::Vector2d& p_W = round[begin.point];
    double cost_m = (p_W - from_W).norm();
    // No curve is shorter than the way as the crow flies, and the rest begins further away.
    if (cost_m >= std::min(enough_m, best.cost_m)) break;
    if (before != nullptr) {
      const Eigen::Vector2d along =
          round[begin.point + 1] - round[(begin.point + count - 1) % count];
      const Pose to{p_W, heading_of(begin.reversed ? Eigen::Vector2d(-along) : along)};
      cost_m = forward_length_m(end_pose(*before), to, turning_radius_m);
    }
    if (cost_m < best.cost_m) best = {begin, cost_m};
  }
  return best;
}

// Rings of the boundary in the order of their rounds, and those around holes by nearness: before
// the swaths the boundary comes first, after them last, next to where the field is left.
void append_rings(const Headland& headland, bool inwards, const PlanRequest& request,
                  std::vector<Pass>& passes) {
  std::vector<const HeadlandRing*> left;
  for (const HeadlandRing& ring : headland.rings) left.push_back(&ring);
  const auto rank = [&](const HeadlandRing* ring) {
    if (ring->around_hole) return inwards ? std::pair(1, 0) : std::pair(0, 0);
    return inwards ? std::pair(0, ring->round) : std::pair(1, -ring->round);
  };
  while (!left.empty()) {
    stop_if(request.cancelled);
    const auto least = rank(*std::min_element(left.begin(), left.end(),
                                              [&](auto* a, auto* b) { return rank(a) < rank(b); }));
    std::vector<const HeadlandRing*> nearest;
    std::ranges::copy_if(left, std::back_inserter(nearest),
                         [&](const HeadlandRing* ring) { return rank(ring) == least; });
    const Pass* before = passes.empty() ? nullptr : &passes.back();
    // Without an entry any round will do to begin with: the first one at its first point.
    const Eigen::Vector2d from_W =
        end_of(passes, request.field.entry_W).value_or(nearest.front()->line_W.front());
    const auto away_m = [&](const HeadlandRing* ring) {
      return ring->box_W.exteriorDistance(from_W);
    };
    std::ranges::stable_sort(nearest, {}, away_m);
    const HeadlandRing* next = nullptr;
    RoundChoice choice;
    for (const HeadlandRing* ring : nearest) {
      if (away_m(ring) >= choice.cost_m) break;
      const RoundChoice found =
          best_begin(ring->line_W, before, from_W, request.turning_radius_m, choice.cost_m);
      if (found.cost_m < choice.cost_m) {
        choice = found;
        next = ring;
      }
    }
    passes.push_back({PassKind::kHeadlandPass, begun_at(next->line_W, choice.begin)});
    std::erase(left, next);
  }
}

}  // namespace

std::span<const ParameterSpec> boustrophedon_parameters() {
  static const std::array<ParameterSpec, 3> kParameters{{
      {"headland_passes",
       std::string("auto"),
       1.0,
       20.0,
       {"auto"},
       "rounds along the boundary; auto: as many as turning needs",
       true},
      {"swath_direction_deg",
       std::string("auto"),
       0.0,
       360.0,
       {"auto"},
       "direction of the swaths, counter-clockwise from east; auto: the best one"},
      {"headland_order",
       std::string("last"),
       0.0,
       0.0,
       {"first", "last"},
       "whether the rounds are driven before or after the swaths"},
  }};
  return kParameters;
}

Plan plan_boustrophedon(const PlanRequest& asked_for) {
  PlanRequest request = asked_for;
  request.field = simplified(asked_for.field);
  check_request(request);
  const auto asked = number_unless_word(request.parameters, "headland_passes");
  const Headland headland =
      make_headland(request, asked ? static_cast<int>(*asked) : rounds_for_turning(request));
  const SwathGrid grid = make_swaths(request, headland);

  Plan plan;
  plan.planner = "boustrophedon";
  plan.swath_direction_rad = grid.direction_rad;
  plan.headland_width_m = headland.width_m;
  const bool headland_first = word(request.parameters, "headland_order") == "first";
  if (headland_first) append_rings(headland, true, request, plan.passes);
  append_swaths(grid, end_of(plan.passes, request.field.entry_W), request.cancelled, plan.passes);
  if (!headland_first) append_rings(headland, false, request, plan.passes);
  for (const Pass& pass : plan.passes) plan.planned_length_m += length_m(pass.points_W);
  return plan;
}

}  // namespace headland

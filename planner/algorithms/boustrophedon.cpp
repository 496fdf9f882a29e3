#include "planner/algorithms/boustrophedon.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "planner/headland_rings.h"
#include "planner/swath_cells.h"
#include "planner/swaths.h"
#include "planner/turns.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Points of a ring between which its begin is looked for [m]; finer changes no turn.
constexpr double kBeginSpacing_m = 1.0;
// How exactly a refusal states the width that would do.
constexpr double kWidthAnswer_m = 0.01;

// Diameter [m] of the largest disc in the field, which is below too_wide_m.
double widest_m(const PolygonSet& field, double too_wide_m) {
  double fits_m = 0.0;
  while (too_wide_m - fits_m > kWidthAnswer_m) {
    const double middle_m = 0.5 * (fits_m + too_wide_m);
    (buffered(field, -middle_m / 2.0, Join::kRound).parts.empty() ? too_wide_m : fits_m) = middle_m;
  }
  return fits_m;
}

void check_request(const PlanRequest& request) {
  const auto positive = [](const char* key, double value_m) {
    if (!(value_m > 0.0) || !std::isfinite(value_m)) {
      throw InputError("plan", key, fmt::format("{}", value_m), "a length above 0 m");
    }
  };
  positive("working_width_m", request.working_width_m);
  positive("turning_radius_m", request.turning_radius_m);
  positive("vehicle_width_m", request.vehicle_width_m);
  const PolygonSet field = from_field(request.field);
  const double reach_m = 0.5 * std::max(request.working_width_m, request.vehicle_width_m);
  if (!buffered(field, -reach_m, Join::kRound).parts.empty()) return;
  const bool hull = request.vehicle_width_m > request.working_width_m;
  throw InputError("plan", hull ? "vehicle_width_m" : "working_width_m",
                   fmt::format("{}", hull ? request.vehicle_width_m : request.working_width_m),
                   fmt::format("wider than the field '{}' anywhere; at most {:.1f} m",
                               request.field.name, widest_m(field, 2.0 * reach_m)));
}

SwathGrid make_swaths(const PlanRequest& request, const Headland& headland) {
  const auto direction_deg = number_unless_word(request.parameters, "swath_direction_deg");
  if (!direction_deg) {
    return best_swaths(request.field, headland.inner, headland.drivable, request.working_width_m,
                       request.turning_radius_m);
  }
  return lay_swaths(headland.inner, headland.drivable,
                    std::fmod(*direction_deg, 180.0) * std::numbers::pi / 180.0,
                    request.working_width_m,
                    turn_length_m(request.working_width_m, request.turning_radius_m));
}

void append_swaths(const SwathGrid& grid, const std::optional<Eigen::Vector2d>& start_W,
                   std::vector<Pass>& passes) {
  const std::vector<SwathCell> cells = cells_of(grid);
  for (const CellVisit& visit : order_cells(grid, cells, start_W)) {
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

struct RingBegin {
  std::size_t point = 0;
  bool reversed = false;
  double cost_m = std::numeric_limits<double>::infinity();
};

// Where a vehicle at the end of `before` best joins `ring`: the shortest forward curve, or, where
// nothing has been driven yet, the nearest point.
RingBegin best_begin(const Polyline& ring, const Pass* before,
                     const std::optional<Eigen::Vector2d>& entry_W, double turning_radius_m) {
  RingBegin best;
  const std::size_t count = ring.size() - 1;
  const auto step = std::max<std::size_t>(
      1, static_cast<std::size_t>(kBeginSpacing_m * static_cast<double>(count) / length_m(ring)));
  for (std::size_t i = 0; i < count; i += step) {
    const Eigen::Vector2d along = ring[i + 1] - ring[(i + count - 1) % count];
    for (const bool reversed : {false, true}) {
      double cost_m = 0.0;
      if (before != nullptr) {
        const Pose to{ring[i], heading_of(reversed ? Eigen::Vector2d(-along) : along)};
        cost_m = forward_length_m(end_pose(*before), to, turning_radius_m);
      } else if (entry_W) {
        cost_m = (ring[i] - *entry_W).norm();
      }
      if (cost_m < best.cost_m) best = {i, reversed, cost_m};
    }
  }
  return best;
}

Polyline opened_at(const Polyline& ring, const RingBegin& begin) {
  Polyline line(ring.begin() + static_cast<std::ptrdiff_t>(begin.point), ring.end() - 1);
  line.insert(line.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin.point));
  line.push_back(line.front());
  if (begin.reversed) std::reverse(line.begin(), line.end());
  return line;
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
    const auto least = rank(*std::min_element(left.begin(), left.end(),
                                              [&](auto* a, auto* b) { return rank(a) < rank(b); }));
    auto next = left.end();
    RingBegin begin;
    for (auto ring = left.begin(); ring != left.end(); ++ring) {
      if (rank(*ring) != least) continue;
      const RingBegin found = best_begin((*ring)->line_W, passes.empty() ? nullptr : &passes.back(),
                                         request.field.entry_W, request.turning_radius_m);
      if (found.cost_m < begin.cost_m) {
        begin = found;
        next = ring;
      }
    }
    passes.push_back({PassKind::kHeadlandPass, opened_at((*next)->line_W, begin)});
    left.erase(next);
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

Plan plan_boustrophedon(const PlanRequest& request) {
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
  append_swaths(grid, end_of(plan.passes, request.field.entry_W), plan.passes);
  if (!headland_first) append_rings(headland, false, request, plan.passes);
  for (const Pass& pass : plan.passes) plan.planned_length_m += length_m(pass.points_W);
  return plan;
}

}  // namespace headland

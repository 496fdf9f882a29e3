#include "planner/headland_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "planner/round_begin.h"
#include "planner/turns.h"

namespace headland {
namespace {

double heading_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

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
      cost_m = forward_length_m(end_pose(before->points_W), to, turning_radius_m);
    }
    if (cost_m < best.cost_m) best = {begin, cost_m};
  }
  return best;
}

// A stretch of a round is driven from either end.
RoundChoice best_way(const Polyline& line, const Pass* before, const Eigen::Vector2d& from_W,
                     double turning_radius_m) {
  RoundChoice best;
  for (const bool reversed : {false, true}) {
    const Polyline way = reversed ? Polyline(line.rbegin(), line.rend()) : line;
    const double cost_m = before == nullptr ? (way.front() - from_W).norm()
                                            : forward_length_m(end_pose(before->points_W),
                                                               begin_pose(way), turning_radius_m);
    if (cost_m < best.cost_m) best = {{0, reversed}, cost_m};
  }
  return best;
}

// Rings or edge passes that are driven before the swaths, or after them.
template <typename Along>  // HeadlandRing or EdgePass
std::vector<Along> in_turn(const std::vector<Along>& all, bool before, const PlanRequest& request) {
  const std::string& order = word(request.parameters, "headland_order");
  std::vector<Along> chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen), [&](const Along& along) {
    return (order == "first" || (order == "holes_first" && along.around_hole)) == before;
  });
  return chosen;
}

}  // namespace

std::span<const ParameterSpec> headland_parameters() {
  static const std::array<ParameterSpec, 2> kParameters{{
      {"headland_passes",
       std::string("auto"),
       1.0,
       20.0,
       {"auto"},
       "rounds along the boundary; auto: as many as turning needs",
       true},
      {"headland_order",
       std::string("last"),
       0.0,
       0.0,
       {"first", "last", "holes_first"},
       "whether the rounds are driven before or after the swaths, or those around holes before "
       "and those along the boundary after them"},
  }};
  return kParameters;
}

int asked_rounds(const PlanRequest& request) {
  const auto asked = number_unless_word(request.parameters, "headland_passes");
  return asked ? static_cast<int>(*asked) : rounds_for_turning(request);
}

std::vector<std::string> ways_off_rows(const PlanRequest& request) {
  std::vector<std::string> ways{
      fmt::format("another swath_order than {}", word(request.parameters, "swath_order"))};
  const std::string& order = word(request.parameters, "headland_order");
  if (order != "first") ways.emplace_back("headland_order: first");
  if (order == "last" && !request.field.holes.empty()) {
    ways.emplace_back("headland_order: holes_first");
  }
  return ways;
}

std::optional<Eigen::Vector2d> end_of(const std::vector<Pass>& passes,
                                      const std::optional<Eigen::Vector2d>& entry_W) {
  if (passes.empty()) return entry_W;
  return passes.back().points_W.back();
}

// Rings of the boundary in the order of their rounds, and those around holes by nearness: before
// the swaths the boundary comes first, after them last, next to where the field is left.
void append_rings(const std::vector<HeadlandRing>& rings, bool inwards, const PlanRequest& request,
                  std::vector<Pass>& passes) {
  std::vector<const HeadlandRing*> left;
  left.reserve(rings.size());
  for (const HeadlandRing& ring : rings) left.push_back(&ring);
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
          is_closed(*ring)
              ? best_begin(ring->line_W, before, from_W, request.turning_radius_m, choice.cost_m)
              : best_way(ring->line_W, before, from_W, request.turning_radius_m);
      if (found.cost_m < choice.cost_m) {
        choice = found;
        next = ring;
      }
    }
    Polyline line_W = next->line_W;
    if (is_closed(*next)) {
      line_W = begun_at(line_W, choice.begin);
    } else if (choice.begin.reversed) {
      std::ranges::reverse(line_W);
    }
    passes.push_back({PassKind::kHeadlandPass, std::move(line_W)});
    std::erase(left, next);
  }
}

void append_rings_before(const Headland& headland, const PlanRequest& request,
                         std::vector<Pass>& passes) {
  append_rings(in_turn(headland.rings, true, request), true, request, passes);
}

void append_rings_after(const Headland& headland, const PlanRequest& request,
                        std::vector<Pass>& passes) {
  append_rings(in_turn(headland.rings, false, request), false, request, passes);
}

// Passes of a ring follow each other around it, from the one that begins nearest on.
void append_edge_passes(const std::vector<EdgePass>& edges, bool inwards,
                        const PlanRequest& request, std::vector<Pass>& passes) {
  std::vector<std::vector<const EdgePass*>> rings;
  for (const EdgePass& edge : edges) {
    const bool same = !rings.empty() && rings.back().front()->round == edge.round &&
                      rings.back().front()->ring == edge.ring;
    if (!same) rings.emplace_back();
    rings.back().push_back(&edge);
  }
  const auto rank = [&](const std::vector<const EdgePass*>& ring) {
    const EdgePass& edge = *ring.front();
    if (edge.around_hole) return inwards ? std::pair(1, 0) : std::pair(0, 0);
    return inwards ? std::pair(0, edge.round) : std::pair(1, -edge.round);
  };
  while (!rings.empty()) {
    stop_if(request.cancelled);
    const Pass* before = passes.empty() ? nullptr : &passes.back();
    const auto least = rank(*std::ranges::min_element(rings, {}, rank));
    const Eigen::Vector2d from_W =
        end_of(passes, request.field.entry_W).value_or(rings.front().front()->line_W.front());
    std::size_t next = rings.size();
    std::size_t first = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      if (rank(rings[ring]) != least) continue;
      for (std::size_t i = 0; i < rings[ring].size(); ++i) {
        // Begun after a gap, its ring ends before it.
        const double away_m =
            (rings[ring][i]->line_W.front() - from_W).norm() - rings[ring][i]->gap_m;
        if (away_m >= nearest_m) continue;
        nearest_m = away_m;
        next = ring;
        first = i;
      }
    }
    const std::vector<const EdgePass*> ring = std::move(rings[next]);
    rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(next));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const EdgePass& edge = *ring[(first + i) % ring.size()];
      Polyline line = edge.line_W;
      if (edge.closed) {
        const RoundChoice choice = best_begin(line, before, from_W, request.turning_radius_m,
                                              std::numeric_limits<double>::infinity());
        line = begun_at(line, choice.begin);
      }
      passes.push_back({PassKind::kHeadlandPass, std::move(line), true});
    }
  }
}

void append_edge_passes_before(const std::vector<EdgePass>& edges, const PlanRequest& request,
                               std::vector<Pass>& passes) {
  append_edge_passes(in_turn(edges, true, request), true, request, passes);
}

void append_edge_passes_after(const std::vector<EdgePass>& edges, const PlanRequest& request,
                              std::vector<Pass>& passes) {
  append_edge_passes(in_turn(edges, false, request), false, request, passes);
}

}  // namespace headland

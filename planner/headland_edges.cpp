#include "planner/headland_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planner/segment.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Points at which a ring does not turn are no corners, whatever turns near them.
constexpr double kLeastTurn_rad = 0.05;
constexpr double kWidthTolerance = 1e-6;  // of a width that is a whole number of passes

const Ring& ring_of(const Field& field, int hole) {
  return hole == 0 ? field.boundary : field.holes[static_cast<std::size_t>(hole - 1)];
}

double turn_at(const Ring& ring, std::size_t i) {
  const Vector2d in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
  const Vector2d out = ring[(i + 1) % ring.size()] - ring[i];
  return std::atan2(cross(in, out), in.dot(out));
}

// Points of the ring no further than half a window from `corner` along it, itself included.
std::vector<std::size_t> near_corner(const Ring& ring, std::size_t corner) {
  std::vector<std::size_t> near{corner};
  for (const std::size_t step : {std::size_t{1}, ring.size() - 1}) {
    double away_m = 0.0;
    for (std::size_t i = corner; near.size() < ring.size();) {
      const std::size_t next = (i + step) % ring.size();
      away_m += (ring[next] - ring[i]).norm();
      if (away_m > 0.5 * kEdgeCornerWindow_m) break;
      near.push_back(i = next);
    }
  }
  return near;
}

// Whether an outline bends on from one corner to the next: no point turns by a corner's angle
// alone, every one turns the same way and sees such a turn (`turns_near`), and the next one as
// well.
bool bends_on(const Ring& ring, const std::vector<char>& turns_near, std::size_t from,
              std::size_t to) {
  const double way = turn_at(ring, from);
  for (std::size_t i = from;; i = (i + 1) % ring.size()) {
    const double turn_rad = turn_at(ring, i);
    if (turns_near[i] == 0 || turn_rad * way <= 0.0 || std::abs(turn_rad) > kEdgeCorner_rad) {
      return false;
    }
    if (i == to) return true;
    if ((ring[(i + 1) % ring.size()] - ring[i]).norm() > 0.5 * kEdgeCornerWindow_m) return false;
  }
}

// One corner, the middle one, of every row of them along a bend.
std::vector<std::size_t> without_bends(const Ring& ring, const std::vector<char>& turns_near,
                                       const std::vector<std::size_t>& corners) {
  const std::size_t count = corners.size();
  const auto goes_on = [&](std::size_t c) {  // from corner c to the next one
    return bends_on(ring, turns_near, corners[c % count], corners[(c + 1) % count]);
  };
  std::size_t first = 0;
  while (first < count && goes_on(first + count - 1)) ++first;
  if (first == count) first = 0;  // a bend all round
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t begin = c;
    while (c + 1 < count && goes_on(first + c)) ++c;
    kept.push_back(corners[(first + (begin + c) / 2) % count]);
  }
  std::ranges::sort(kept);
  return kept;
}

std::vector<std::size_t> corners_of_outline(const Ring& ring) {
  std::vector<double> turns(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) turns[i] = turn_at(ring, i);
  std::vector<char> turns_near(ring.size(), 0);
  std::vector<std::pair<double, std::size_t>> candidates;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    double turned_rad = 0.0;
    for (const std::size_t near : near_corner(ring, i)) turned_rad += turns[near];
    if (std::abs(turned_rad) > kEdgeCorner_rad && std::abs(turns[i]) > kLeastTurn_rad) {
      turns_near[i] = 1;
      candidates.emplace_back(-std::abs(turned_rad) - std::abs(turns[i]), i);
    }
  }
  // Of points that see the same turn the sharpest one is the corner.
  std::ranges::stable_sort(candidates);
  std::vector<char> taken(ring.size(), 0);
  std::vector<std::size_t> corners;
  for (const auto& [score, corner] : candidates) {
    if (taken[corner] != 0) continue;
    corners.push_back(corner);
    for (const std::size_t near : near_corner(ring, corner)) taken[near] = 1;
  }
  std::ranges::sort(corners);
  return without_bends(ring, turns_near, corners);
}

void append_edges(const Ring& ring, int hole, std::vector<FieldEdge>& edges) {
  std::vector<std::size_t> corners = corners_of_outline(ring);
  if (corners.empty()) corners.push_back(0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t end = corners[(c + 1) % corners.size()];
    FieldEdge edge{hole, static_cast<int>(c) + 1, {ring[corners[c]]}};
    for (std::size_t i = corners[c]; i != end || edge.line_W.size() == 1;) {
      i = (i + 1) % ring.size();
      edge.line_W.push_back(ring[i]);
    }
    edges.push_back(std::move(edge));
  }
}

double distance_m(const Polyline& line_W, const Vector2d& p_W) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line_W.size(); ++i) {
    least_m = std::min(least_m, distance_to_segment(p_W, line_W[i - 1], line_W[i]));
  }
  return least_m;
}

std::string ring_name(int hole) {
  return hole == 0 ? std::string("the boundary") : fmt::format("hole {}", hole);
}

// The edges that an entry names, as indices.
std::vector<std::size_t> named_edges(const EdgeHeadland& entry, std::size_t number,
                                     const Field& field, const std::vector<FieldEdge>& edges) {
  if (entry.at_W) {
    const auto away_m = [&](const FieldEdge& edge) { return distance_m(edge.line_W, *entry.at_W); };
    const auto nearest = std::ranges::min_element(edges, {}, away_m);
    const double least_m = away_m(*nearest);
    if (!(least_m <= kFarthestFromEdge_m)) {
      constexpr double kFar_m = 1e6;
      throw InputError(
          "plan", headland_edge_key(number),
          fmt::format("at ({:.7g}, {:.7g}) m", entry.at_W->x(), entry.at_W->y()),
          fmt::format("a place on an edge of the field, or at most {:g} m from it; the nearest, "
                      "{}, is {} away",
                      kFarthestFromEdge_m, edge_name(nearest->hole, nearest->edge),
                      least_m < kFar_m ? fmt::format("{:.0f} m", least_m) : "more than 1000 km"));
    }
    return {static_cast<std::size_t>(nearest - edges.begin())};
  }
  if (entry.hole < 0 || entry.hole > std::ssize(field.holes)) {
    throw InputError("plan", headland_edge_key(number), fmt::format("hole {}", entry.hole),
                     field.holes.empty()
                         ? std::string("the field has no holes")
                         : fmt::format("the field has holes 1 to {}", field.holes.size()));
  }
  std::vector<std::size_t> named;
  int count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].hole != entry.hole) continue;
    ++count;
    if (entry.edge == 0 || edges[i].edge == entry.edge) named.push_back(i);
  }
  if (named.empty()) {
    throw InputError("plan", headland_edge_key(number), fmt::format("edge {}", entry.edge),
                     fmt::format("{} has {} edge{}, counted from 1 with the field on their left",
                                 ring_name(entry.hole), count, count == 1 ? "" : "s"));
  }
  return named;
}

int rounds_asked(const EdgeHeadland& entry, std::size_t number, double width_m, double first_m) {
  if (entry.passes) {
    if (*entry.passes < 0 || *entry.passes > kMostRounds) {
      throw InputError("plan", headland_edge_key(number), fmt::format("passes {}", *entry.passes),
                       fmt::format("0 to {} passes", kMostRounds));
    }
    return *entry.passes;
  }
  if (entry.width_m <= 0.0) return 0;
  const double outside_m = first_m - 0.5 * width_m;
  const double rounds = std::ceil((entry.width_m - outside_m) / width_m - kWidthTolerance);
  if (rounds > kMostRounds) {
    throw InputError("plan", headland_edge_key(number), fmt::format("width_m {:g}", entry.width_m),
                     fmt::format("at most {} passes of {:g} m each", kMostRounds, width_m));
  }
  return std::max(1, static_cast<int>(rounds));
}

}  // namespace

std::vector<FieldEdge> edges_of(const Field& field) {
  std::vector<FieldEdge> edges;
  for (int hole = 0; hole <= std::ssize(field.holes); ++hole) {
    append_edges(ring_of(field, hole), hole, edges);
  }
  return edges;
}

std::string edge_name(int hole, int edge) {
  return hole == 0 ? fmt::format("edge {}", edge) : fmt::format("edge {} of hole {}", edge, hole);
}

std::string headland_edge_key(std::size_t entry) {
  return fmt::format("headland_edges[{}]", entry);
}

EdgeRounds edge_rounds(const PlanRequest& request, int others, double first_m) {
  EdgeRounds result{edges_of(request.field), {}, others};
  result.rounds.assign(result.edges.size(), others);
  // Which entry named an edge: one for its whole ring yields.
  std::vector<std::optional<std::size_t>> of_ring(result.edges.size());
  std::vector<std::optional<std::size_t>> alone(result.edges.size());
  for (std::size_t i = 0; i < request.headland_edges.size(); ++i) {
    const EdgeHeadland& entry = request.headland_edges[i];
    const int rounds = rounds_asked(entry, i, request.working_width_m, first_m);
    const bool whole_ring = !entry.at_W && entry.edge == 0;
    for (const std::size_t edge : named_edges(entry, i, request.field, result.edges)) {
      auto& named = (whole_ring ? of_ring : alone)[edge];
      if (named) {
        const FieldEdge& twice = result.edges[edge];
        throw InputError("plan", headland_edge_key(i), edge_name(twice.hole, twice.edge),
                         fmt::format("{} names it already", headland_edge_key(*named)));
      }
      named = i;
      if (!whole_ring || !alone[edge]) result.rounds[edge] = rounds;
    }
  }
  return result;
}

bool is_grazed(const Vector2d& run, double direction_rad) {
  const Vector2d direction(std::cos(direction_rad), std::sin(direction_rad));
  return std::abs(cross(run, direction)) < std::sin(kEdgeCorner_rad) * run.norm();
}

RoundsOfAll rounds_of_all(const EdgeRounds& edges, bool obstacles) {
  std::vector<int> rounds = edges.rounds;
  if (obstacles || rounds.empty()) rounds.push_back(edges.others);
  const auto [least, most] = std::ranges::minmax(rounds);
  return {least, most};
}

bool is_one_number(const RoundsOfAll& rounds) {
  return rounds.least == rounds.most && rounds.least > 0;
}

}  // namespace headland

#include "planner/headland_by_edge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/free_space.h"
#include "planner/outline.h"
#include "planner/segment.h"
#include "planner/work_line.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Shorter stretches of a round are not worth coming to [working widths].
constexpr double kShortestStretch = 1.0;
constexpr std::size_t kLeastPoints = 4;  // of a stretch that has a direction

// A line beside an edge is as far from it as its round, to within so many working widths.
constexpr double kBesideTolerance = 0.5;

HeadlandRing ring_along(const HeadlandRing& whole, Polyline line_W) {
  HeadlandRing ring{whole.round, whole.around_hole, std::move(line_W), {}};
  for (const Vector2d& p_W : ring.line_W) ring.box_W.extend(p_W);
  return ring;
}

// Cuts the ends of a stretch back to where the hull fits that follows it, either way round: the
// vehicle runs straight on as far as the implement is behind.
void cut_to_fit(const PlanRequest& request, const FreeSpace& space, Polyline& line_W) {
  for (int end = 0; end < 2; ++end) {
    const auto fits_at_end = [&] {
      return fits(
          space,
          pose_of(work_line_end({PassKind::kHeadlandPass, line_W, false}, request.implement_x_B_m)),
          request.clearance_m);
    };
    while (line_W.size() > kLeastPoints && !fits_at_end()) line_W.pop_back();
    std::ranges::reverse(line_W);
  }
}

int rounds_of_nearest(const EdgedGround& edged, const Vector2d& p_W) {
  int nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for_each_edge(edged, [&](const Vector2d& a_W, const Vector2d& b_W, int rounds) {
    const double away_m = distance_to_segment(p_W, a_W, b_W);
    if (away_m >= least_m) return;
    least_m = away_m;
    nearest = rounds;
  });
  return nearest;
}

// Which points of a closed ring are in `zone`, beside edges that have the round, and not in
// `worked`. Arcs that cut across a corner between two such edges are wanted as well, however deep
// they leave the zone.
std::vector<char> wanted_points(const HeadlandRing& ring, const EdgedGround& edged,
                                const PolygonSet& zone, const PolygonSet& worked) {
  const std::size_t count = ring.line_W.size() - 1;
  std::vector<char> wanted(count, 0);
  std::vector<char> cuts_corner(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d& p_W = ring.line_W[i];
    if (holds(worked, p_W)) continue;
    wanted[i] = holds(zone, p_W) ? 1 : 0;
    cuts_corner[i] = wanted[i] == 0 && rounds_of_nearest(edged, p_W) > ring.round ? 1 : 0;
  }
  for (std::size_t begin = 0; begin < count; ++begin) {
    if (cuts_corner[begin] == 0 || wanted[(begin + count - 1) % count] == 0) continue;
    std::size_t end = begin;
    while (cuts_corner[end % count] != 0) ++end;
    if (wanted[end % count] == 0) continue;
    for (std::size_t i = begin; i < end; ++i) wanted[i % count] = 1;
  }
  return wanted;
}

// The stretches of a closed ring whose points are wanted; the ring itself where all are.
void append_stretches(const HeadlandRing& ring, const std::vector<char>& is_wanted,
                      const PlanRequest& request, const FreeSpace& space,
                      std::vector<HeadlandRing>& stretches) {
  const double shortest_m = kShortestStretch * request.working_width_m;
  const std::size_t count = is_wanted.size();
  const auto unwanted = std::ranges::find(is_wanted, 0);
  if (unwanted == is_wanted.end()) {
    stretches.push_back(ring);
    return;
  }
  const auto first = static_cast<std::size_t>(unwanted - is_wanted.begin());
  Polyline line_W;
  for (std::size_t step = 1; step <= count; ++step) {
    const std::size_t i = (first + step) % count;
    if (is_wanted[i] != 0) {
      line_W.push_back(ring.line_W[i]);
      continue;
    }
    if (line_W.size() > kLeastPoints) cut_to_fit(request, space, line_W);
    if (length_m(line_W) >= shortest_m) stretches.push_back(ring_along(ring, std::move(line_W)));
    line_W.clear();
  }
}

// Rounds of the edge that a line runs along; 0 where there is none.
int rounds_beside(const EdgedGround& edged, const Vector2d& p_W, const Vector2d& along,
                  double distance_m, double tolerance_m) {
  int rounds = 0;
  double best = 0.0;
  for_each_edge(edged, [&](const Vector2d& a_W, const Vector2d& b_W, int of_edge) {
    if (std::abs(distance_to_segment(p_W, a_W, b_W) - distance_m) > tolerance_m) return;
    const double alike = std::abs(along.dot((b_W - a_W).normalized()));
    if (alike <= best) return;
    best = alike;
    rounds = of_edge;
  });
  return rounds;
}

}  // namespace

std::vector<Polyline> stretches_along(const EdgedGround& edged, const Polyline& line_W,
                                      double distance_m, double width_m, int round) {
  std::vector<Polyline> stretches(1);
  for (std::size_t i = 0; i < line_W.size(); ++i) {
    const Vector2d along = line_W[std::min(i + 1, line_W.size() - 1)] - line_W[i == 0 ? 0 : i - 1];
    if (rounds_beside(edged, line_W[i], along.normalized(), distance_m,
                      kBesideTolerance * width_m) > round) {
      stretches.back().push_back(line_W[i]);
    } else if (!stretches.back().empty()) {
      stretches.emplace_back();
    }
  }
  std::erase_if(stretches, [&](const Polyline& stretch) {
    return length_m(stretch) < kShortestStretch * width_m;
  });
  return stretches;
}

void add_rounds_by_edge(const PlanRequest& request, const PolygonSet& field,
                        const FirstRound& first, Headland& headland) {
  const double width_m = request.working_width_m;
  const double first_m = first.distance_m;
  const EdgedGround& edged = headland.edged;
  const bool corners_are_worked = !request.forward_only;
  const auto beside = [&](const PolygonSet& ground, double distance_m) {
    return simplified(buffered(ground, distance_m, Join::kRound), kOutlineTolerance_m);
  };
  const FreeSpace space = free_space(request.field, hull_of(request));
  PolygonSet worked;  // by the rounds so far
  PolygonSet inside_before = field;
  std::vector<PolygonSet> left;
  for (int round = 0; round < headland.rounds; ++round) {
    stop_if(request.cancelled);
    const double distance_m = first_m + round * width_m;
    const RoundsRange with{round + 1};
    const PolygonSet zone = zone_beside(edged, with, distance_m + 0.5 * width_m);
    if (round < headland.least_rounds) {
      const HeadlandRound made = round_of_all(request, field, first, round);
      headland.rings.insert(headland.rings.end(), made.rings.begin(), made.rings.end());
      if (round > 0 && corners_are_worked) {
        left.push_back(
            worth_working(difference(inside_before, beside(made.ground, 0.5 * width_m)), width_m));
      }
      inside_before = beside(made.ground, -0.5 * width_m);
      worked = united(std::vector<PolygonSet>{worked, zone});
      continue;
    }
    // Before an edge without headland every round turns off, swinging as near as the first one;
    // others end at the headland there. Wider corners than need be leave more to short swaths.
    const double corner_radius_m =
        headland.least_rounds == 0 ? first.radius_m : request.turning_radius_m;
    const Rounding rounding{kRadiusMargin * request.turning_radius_m,
                            kRadiusMargin * corner_radius_m, field, first_m};
    const PolygonSet ground =
        difference(field, united(std::vector<PolygonSet>{zone_beside(edged, with, distance_m),
                                                         zone_beside(edged, {0, round}, first_m)}));
    const HeadlandRound made = round_along(ground, round, rounding, request);
    const std::size_t before = headland.rings.size();
    for (const HeadlandRing& ring : made.rings) {
      stop_if(request.cancelled);
      append_stretches(ring, wanted_points(ring, edged, zone, worked), request, space,
                       headland.rings);
    }
    if (round > 0 && corners_are_worked) {
      left.push_back(worth_working(
          intersection(zone, difference(inside_before, beside(made.ground, 0.5 * width_m))),
          width_m));
    }
    std::vector<PolygonSet> driven{zone};
    for (std::size_t i = before; i < headland.rings.size(); ++i) {
      driven.push_back(strip(headland.rings[i].line_W, width_m));
    }
    inside_before = united(
        std::vector<PolygonSet>{difference(inside_before, united(driven)),
                                intersection(inside_before, beside(made.ground, -0.5 * width_m))});
    worked = united(std::vector<PolygonSet>{worked, zone});
  }
  if (corners_are_worked && headland.rounds > 0) {
    left.push_back(worth_working(difference(inside_before, headland.inside), width_m));
  }
  // In corners beside edges that are too narrow for turning nothing more can be come to.
  const PolygonSet without_room =
      zone_beside(edged, {0, rounds_for_turning(request) - 1}, turning_depth_m(request));
  for (PolygonSet& ground : left) ground = difference(ground, without_room);
  left.push_back(headland.inside);
  headland.inner = united(left);
  if (headland.rings.empty() && headland.rounds > 0) refuse_headland(request, field, first);
}

}  // namespace headland

#include "planner/edge_passes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/ring_smoothing.h"
#include "planner/segment.h"
#include "planner/space_cells.h"
#include "planner/work_line.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// The filter rounds a corner of kSharpCorner_rad to 1.14 turning radii and tightens an arc by 2 %.
constexpr double kSigmaPerRadius = 0.2;
constexpr double kPassRadiusMargin = 1.05;
// Corners are told by what a ring turns within this much of it [turning radii].
constexpr double kCornerWindow = 0.8;
constexpr double kShortestEdge_m = 1.0;  // pass
constexpr double kEndStep_m = 0.25;      // by which ends are drawn in
constexpr int kMostPushes = 30;
constexpr double kPushDone_m = 0.004;
constexpr double kBesideVertex_m = 0.3;  // by which edges are taken to run on
// Lines are moved in over this much on both sides of where the hull protrudes [hull lengths].
constexpr double kPushReach = 1.5;

Vector2d to_the_left(const Vector2d& along) { return Vector2d(-along.y(), along.x()); }

// A line with its length so far at every point.
struct Measured {
  Polyline points;
  std::vector<double> at_m;
};

Measured measured(Polyline points) {
  Measured line{std::move(points), {0.0}};
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    line.at_m.push_back(line.at_m.back() + (line.points[i] - line.points[i - 1]).norm());
  }
  return line;
}

Vector2d point_at(const Measured& line, double at_m) {
  const auto after = std::upper_bound(line.at_m.begin() + 1, line.at_m.end() - 1, at_m);
  const auto i = static_cast<std::size_t>(after - line.at_m.begin());
  const double t = (at_m - line.at_m[i - 1]) / (line.at_m[i] - line.at_m[i - 1]);
  return line.points[i - 1] + t * (line.points[i] - line.points[i - 1]);
}

Polyline evenly(const Measured& line) {
  const auto count =
      std::max<std::size_t>(1, static_cast<std::size_t>(line.at_m.back() / kRingSpacing_m));
  Polyline even;
  for (std::size_t i = 0; i <= count; ++i) {
    even.push_back(
        point_at(line, line.at_m.back() * static_cast<double>(i) / static_cast<double>(count)));
  }
  return even;
}

// Turn [rad] to the left at each corner of a ring.
std::vector<double> turns_of(const Ring& ring) {
  std::vector<double> turns(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vector2d out = ring[(i + 1) % ring.size()] - ring[i];
    turns[i] = std::atan2(cross(in, out), in.dot(out));
  }
  return turns;
}

// Corners at which the ring is cut, ascending: where it turns left most within the window.
std::vector<std::size_t> sharp_corners(const Ring& ring, double window_m) {
  const std::size_t count = ring.size();
  const std::vector<double> turns = turns_of(ring);
  std::vector<std::pair<double, std::size_t>> candidates;
  const auto visit_window = [&](std::size_t corner, auto visit) {
    visit(corner);
    double away_m = 0.0;
    for (std::size_t i = corner, steps = 0; ++steps < count;) {
      const std::size_t next = (i + 1) % count;
      away_m += (ring[next] - ring[i]).norm();
      if (away_m > 0.5 * window_m) break;
      visit(i = next);
    }
    away_m = 0.0;
    for (std::size_t i = corner, steps = 0; ++steps < count;) {
      const std::size_t before = (i + count - 1) % count;
      away_m += (ring[before] - ring[i]).norm();
      if (away_m > 0.5 * window_m) break;
      visit(i = before);
    }
  };
  for (std::size_t corner = 0; corner < count; ++corner) {
    double turned_rad = 0.0;
    visit_window(corner, [&](std::size_t i) { turned_rad += turns[i]; });
    // Of corners that see the same turn the sharpest one is it.
    if (turned_rad > kSharpCorner_rad && turns[corner] > 0.0) {
      candidates.emplace_back(-(turned_rad + turns[corner]), corner);
    }
  }
  std::ranges::stable_sort(candidates);
  std::vector<bool> taken(count, false);
  std::vector<std::size_t> corners;
  for (const auto& [score, corner] : candidates) {
    if (taken[corner]) continue;
    corners.push_back(corner);
    visit_window(corner, [&](std::size_t i) { taken[i] = true; });
  }
  std::ranges::sort(corners);
  return corners;
}

// The ring from one corner to another, run on straight at both ends.
Polyline chain_of(const Ring& ring, std::size_t from, std::size_t to, double run_on_m,
                  double chord_m) {
  Polyline points{ring[from]};
  for (std::size_t i = from; i != to || points.size() == 1;) {
    i = (i + 1) % ring.size();
    points.push_back(ring[i]);
  }
  const Measured line = measured(points);
  const double chord = std::min(chord_m, 0.5 * line.at_m.back());
  const Vector2d begin = (point_at(line, chord) - points.front()).normalized();
  const Vector2d end = (points.back() - point_at(line, line.at_m.back() - chord)).normalized();
  points.insert(points.begin(), points.front() - run_on_m * begin);
  points.push_back(points.back() + run_on_m * end);
  return points;
}

Polyline filtered(const Polyline& line, double sigma_m, bool closed) {
  if (closed) {
    return smoothed_ring(Ring(line.begin(), line.end() - 1), sigma_m);
  }
  const double spacing_m = (line[1] - line[0]).norm();
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * sigma_m / spacing_m));
  const auto last = std::ssize(line) - 1;
  const auto at = [&](std::ptrdiff_t i) -> Vector2d {
    if (i < 0) return 2.0 * line.front() - line[static_cast<std::size_t>(std::min(-i, last))];
    if (i > last) {
      return 2.0 * line.back() -
             line[static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, 2 * last - i))];
    }
    return line[static_cast<std::size_t>(i)];
  };
  Polyline smooth;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    Vector2d sum = Vector2d::Zero();
    double weights = 0.0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const double x = spacing_m * static_cast<double>(k) / sigma_m;
      const double weight = std::exp(-0.5 * x * x);
      sum += weight * at(i + k);
      weights += weight;
    }
    smooth.push_back(sum / weights);
  }
  return smooth;
}

struct Edging {
  const PlanRequest& request;
  const FreeSpace& space;
  double overhang_m = 0.0;
  double least_m2 = 0.0;
  WorkedGround& ground;

  WorkLine work_line_of(const Polyline& line) const {
    return work_line({PassKind::kHeadlandPass, line}, request.implement_x_B_m);
  }
  bool drivable(const PathPoint& point) const {
    return std::abs(point.curvature_per_m) <= kPassRadiusMargin / request.turning_radius_m &&
           fits(space, pose_of(point), request.clearance_m - 0.5 * kFitTolerance_m) &&
           works_inside(space, pose_of(point), overhang_m);
  }
};

// How much [m] the right side of the hull lacks of its clearance from edges that run along with it:
// what is ahead is no matter of swinging past an edge, the way ends there.
double lack_beside_m(const Edging& edging, const Pose& pose) {
  const FreeSpace& space = edging.space;
  const Hull& hull = space.hull;
  const double asked_m = edging.request.clearance_m;
  if (safe_distance_m(space, pose) > asked_m) return 0.0;
  const Vector2d ahead = direction_of(pose.heading_rad);
  const Vector2d right_W = pose.p_W - hull.half_width_m * left_of(pose.heading_rad);
  const Vector2d reach = Vector2d::Constant(reach_m(hull) + asked_m);
  double lack_m = 0.0;
  every_cell(space, cells_around(space, pose.p_W - reach, pose.p_W + reach),
             [&](const FreeSpace::Cell& cell) {
               for (const int index : cell.edges) {
                 const FreeSpace::Edge& edge = space.edges[static_cast<std::size_t>(index)];
                 const double length_m = (edge.b_W - edge.a_W).norm();
                 const Vector2d along = (edge.b_W - edge.a_W) / length_m;
                 if (along.dot(ahead) < std::cos(kSharpCorner_rad)) continue;
                 for (const double x_m : {hull.front_m, 0.5 * hull.front_m, 0.0, -hull.rear_m}) {
                   const Vector2d q = right_W + x_m * ahead - edge.a_W;
                   const double at_m = along.dot(q);
                   if (at_m < -kBesideVertex_m || at_m > length_m + kBesideVertex_m) continue;
                   lack_m = std::max(lack_m, asked_m - cross(along, q));
                 }
               }
               return true;
             });
  return lack_m;
}

// Moves a line to its left where the hull following it would come too near to what is at its right.
Polyline pushed(const Edging& edging, const Polyline& line, double sigma_m, bool closed) {
  const double spacing_m = (line[1] - line[0]).norm();
  const double reach_of_push_m = kPushReach * reach_m(edging.space.hull);
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(reach_of_push_m / spacing_m));
  const auto count = std::ssize(line);
  std::vector<double> moved_m(line.size(), 0.0);
  Polyline result = line;
  for (int step = 0; step < kMostPushes; ++step) {
    const WorkLine work = edging.work_line_of(result);
    std::vector<double> lack_m(line.size(), 0.0);
    double most_m = 0.0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      // The work line has its own spacing; its places are in proportion.
      const auto at = static_cast<std::size_t>(i * (std::ssize(work.points) - 1) / (count - 1));
      const double lack = lack_beside_m(edging, pose_of(work.points[at]));
      // What protrudes far is in the way.
      if (lack > edging.request.vehicle_front_m) continue;
      lack_m[static_cast<std::size_t>(i)] = lack;
      most_m = std::max(most_m, lack);
    }
    if (most_m <= kPushDone_m) break;
    std::vector<double> push_m(line.size(), 0.0);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const double lack = lack_m[static_cast<std::size_t>(i)];
      if (lack <= 0.0) continue;
      for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
        std::ptrdiff_t j = i + k;
        if (closed) j = (j % (count - 1) + count - 1) % (count - 1);
        if (j < 0 || j >= count) continue;
        const double share = std::cos(0.5 * std::numbers::pi * static_cast<double>(k) /
                                      static_cast<double>(reach + 1));
        double& push = push_m[static_cast<std::size_t>(j)];
        push = std::max(push, lack * share * share);
      }
    }
    if (closed) push_m.back() = push_m.front();
    for (std::size_t i = 0; i < line.size(); ++i) moved_m[i] += push_m[i];
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::size_t before = i > 0 ? i - 1 : (closed ? line.size() - 2 : 0);
      const std::size_t after = i + 1 < line.size() ? i + 1 : (closed ? 1 : i);
      result[i] = line[i] + moved_m[i] * to_the_left((line[after] - line[before]).normalized());
    }
    result = filtered(result, sigma_m, closed);
    if (result.size() != line.size()) break;
  }
  return result;
}

// Works the ground of a line from its first to its last place that find any to work.
void append_useful(const Edging& edging, Polyline line, EdgePass pass,
                   std::vector<EdgePass>& passes) {
  const double width_m = edging.request.working_width_m;
  std::vector<double> gain_m2;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d half_bar = 0.5 * width_m * to_the_left((line[i + 1] - line[i]).normalized());
    gain_m2.push_back(
        to_work_m2(edging.ground, between_bars(line[i], line[i + 1], half_bar, half_bar)));
  }
  // A crumb at an end is not worth its way: a twentieth of the width must be new.
  const double least_m2 = 0.05 * width_m * kRingSpacing_m;
  const auto worth = [&](double gain) { return gain > least_m2; };
  const auto first = std::ranges::find_if(gain_m2, worth);
  if (first == gain_m2.end()) return;
  const auto last = std::find_if(gain_m2.rbegin(), gain_m2.rend(), worth).base();
  if (!pass.closed) {
    line = Polyline(line.begin() + (first - gain_m2.begin()),
                    line.begin() + (last - gain_m2.begin()) + 1);
  }
  if (length_m(line) < kShortestEdge_m) return;
  double sum_m2 = 0.0;
  for (const double gain : gain_m2) sum_m2 += gain;
  if (sum_m2 < edging.least_m2) return;
  work_driven(edging.ground, edging.work_line_of(line).points, edging.request.implement_x_B_m,
              width_m);
  pass.line_W = std::move(line);
  passes.push_back(std::move(pass));
}

// The stretches of a line that the vehicle can drive, as lines of their own.
std::vector<Polyline> drivable_stretches(const Edging& edging, const Polyline& line) {
  const WorkLine work = edging.work_line_of(line);
  std::vector<Polyline> stretches;
  const Measured whole = measured(line);
  const auto place_m = [&](std::size_t i) {
    return whole.at_m.back() * static_cast<double>(i) / static_cast<double>(work.points.size() - 1);
  };
  for (std::size_t i = 0; i < work.points.size();) {
    if (!edging.drivable(work.points[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end + 1 < work.points.size() && edging.drivable(work.points[end + 1])) ++end;
    double from_m = place_m(i);
    double to_m = place_m(end);
    // Cut from a curve a line runs on straight at its end, which may need less of it.
    while (to_m - from_m >= kShortestEdge_m) {
      Polyline piece{point_at(whole, from_m)};
      for (std::size_t k = 0; k < whole.points.size(); ++k) {
        const bool inside = whole.at_m[k] > from_m + 0.01 && whole.at_m[k] < to_m - 0.01;
        if (inside) piece.push_back(whole.points[k]);
      }
      piece.push_back(point_at(whole, to_m));
      const WorkLine alone = edging.work_line_of(piece);
      const auto fine = [&](const PathPoint& point) { return edging.drivable(point); };
      if (std::ranges::all_of(alone.points, fine)) {
        stretches.push_back(std::move(piece));
        break;
      }
      const auto half = alone.points.begin() + std::ssize(alone.points) / 2;
      const bool at_begin = !std::all_of(alone.points.begin(), half, fine);
      (at_begin ? from_m : to_m) += at_begin ? kEndStep_m : -kEndStep_m;
    }
    i = end + 1;
  }
  return stretches;
}

}  // namespace

double edge_distance_m(const PlanRequest& request) {
  return std::max(0.5 * request.working_width_m,
                  0.5 * request.vehicle_width_m + request.clearance_m + kRoomBesideEdge_m);
}

std::vector<EdgePass> edge_round(const PlanRequest& request, const FreeSpace& space,
                                 const PolygonSet& field, double distance_m, int round,
                                 const EdgeOptions& options, WorkedGround& ground) {
  const double radius_m = request.turning_radius_m;
  const double sigma_m = kSigmaPerRadius * radius_m;
  const double run_on_m =
      request.vehicle_front_m + request.vehicle_rear_m + request.working_width_m + distance_m;
  const Edging edging{request, space, options.overhang_m, options.least_m2, ground};
  const Rounding rounding{kPassRadiusMargin * radius_m, kPassRadiusMargin * radius_m, field,
                          std::min(distance_m, edge_distance_m(request))};
  const PolygonSet inside =
      passable(buffered(field, -distance_m, Join::kMitre), rounding, request.cancelled);
  std::vector<EdgePass> passes;
  std::size_t rings = 0;
  const auto add_ring = [&](const Ring& ring, bool around_hole) {
    stop_if(request.cancelled);
    EdgePass pass{round, rings++, around_hole, false, {}};
    const auto add_line = [&](const Polyline& along, bool closed) {
      pass.closed = closed;
      Polyline line =
          closed ? smoothed_ring(ring, sigma_m) : filtered(evenly(measured(along)), sigma_m, false);
      line = pushed(edging, line, sigma_m, closed);
      if (closed) {
        const WorkLine work = edging.work_line_of(line);
        if (std::ranges::all_of(work.points,
                                [&](const PathPoint& p) { return edging.drivable(p); })) {
          append_useful(edging, std::move(line), pass, passes);
          return;
        }
        pass.closed = false;
      }
      for (Polyline& stretch : drivable_stretches(edging, line)) {
        append_useful(edging, std::move(stretch), pass, passes);
      }
    };
    const std::vector<std::size_t> corners = sharp_corners(ring, kCornerWindow * radius_m);
    if (corners.empty()) add_line({}, true);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add_line(chain_of(ring, corners[i], corners[(i + 1) % corners.size()], run_on_m, radius_m),
               false);
    }
  };
  for (const PolygonPart& part : inside.parts) {
    add_ring(part.outer, false);
    for (const Ring& hole : part.holes) add_ring(hole, true);
  }
  return passes;
}

}  // namespace headland

#include "planner/ring_smoothing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace headland {
namespace {

// GEOS simplifies what it buffers by 1 % of the distance, which flattens arcs that run the other
// way into chords; in steps the chords are short enough for the filter to remove.
constexpr int kErosionSteps = 3;
// Ground that may be lacking from the clearance before the boundary swings out [fraction of the
// radius]: below the rounding's own error.
constexpr double kClearanceSlack = 0.02;
// Points that the shape does without are left out before it is rounded again [m]; the chords of
// arcs are further from them.
constexpr double kShape_m = 0.001;
// Fillings smaller than this [part of the radius squared] are seams between arcs made of chords.
constexpr double kSliverPerRadius2 = 1e-3;
constexpr int kSwingBisections = 8;

int quadrant_segments(double radius_m) {
  return std::max(kQuadrantSegments,
                  static_cast<int>(std::ceil(radius_m * std::numbers::pi / 2.0 / kRingSpacing_m)));
}

PolygonSet in_steps(PolygonSet set, double distance_m) {
  for (int step = 0; step < kErosionSteps; ++step) {
    set = buffered(set, distance_m / kErosionSteps, Join::kRound,
                   quadrant_segments(std::abs(distance_m)));
  }
  return set;
}

PolygonSet closed_by(const PolygonSet& set, double radius_m) {
  return in_steps(buffered(set, radius_m, Join::kRound, quadrant_segments(radius_m)), -radius_m);
}

PolygonSet opened_by(const PolygonSet& set, double radius_m) {
  return in_steps(buffered(set, -radius_m, Join::kRound, quadrant_segments(radius_m)), radius_m);
}

// Ground that keeps the clearance but for the rounding's own error.
PolygonSet clear_ground(const Rounding& rounding) {
  return buffered(rounding.limit, -(rounding.clearance_m - kClearanceSlack * rounding.radius_m),
                  Join::kRound);
}

// What is to be kept out of around a place that closing brings too near, so that the boundary
// swings out there: the smallest shift of the ground with which closing keeps the clearance.
PolygonSet kept_out_of(const PolygonSet& ground, const PolygonSet& clear, const PolygonPart& around,
                       double radius_m, const CancelAsked& cancelled) {
  const PolygonSet place{{around}};
  const PolygonSet surroundings = buffered(place, 2.0 * radius_m, Join::kRound);
  const PolygonSet near = intersection(ground, surroundings);
  const PolygonSet clear_near = intersection(clear, surroundings);
  double low_m = 0.0;
  double high_m = radius_m;
  for (int i = 0; i < kSwingBisections; ++i) {
    stop_if(cancelled);
    const double shift_m = 0.5 * (low_m + high_m);
    const PolygonSet shifted = closed_by(buffered(near, -shift_m, Join::kMitre), radius_m);
    (covers(clear_near, intersection(shifted, place)) ? high_m : low_m) = shift_m;
  }
  return opened_by(difference(place, buffered(near, -high_m, Join::kMitre)), radius_m);
}

Eigen::AlignedBox2d box_of(std::span<const PolygonPart> parts) {
  Eigen::AlignedBox2d box;
  for (const PolygonPart& part : parts) {
    for (const Eigen::Vector2d& p_W : part.outer) box.extend(p_W);
  }
  return box;
}

// The same for many places, by halves with the ground around them, so that not all of it is looked
// at for each.
void append_kept_out(const PolygonSet& ground, const PolygonSet& clear,
                     std::span<PolygonPart> places, double radius_m, const CancelAsked& cancelled,
                     std::vector<PolygonSet>& kept_out) {
  if (places.size() == 1) {
    kept_out.push_back(kept_out_of(ground, clear, places.front(), radius_m, cancelled));
    return;
  }
  const Eigen::Vector2d size = box_of(places).sizes();
  const Eigen::Index axis = size.x() > size.y() ? 0 : 1;
  const std::size_t half = places.size() / 2;
  std::ranges::stable_sort(places, {}, [axis](const PolygonPart& part) {
    return box_of(std::span(&part, 1)).center()[axis];
  });
  for (const std::span<PolygonPart> some : {places.first(half), places.subspan(half)}) {
    Eigen::AlignedBox2d box = box_of(some);
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(3.0 * radius_m);
    box = {box.min() - margin, box.max() + margin};
    const Ring corners{
        box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
    const PolygonSet around{{{corners, {}}}};
    append_kept_out(intersection(ground, around), intersection(clear, around), some, radius_m,
                    cancelled, kept_out);
  }
}

}  // namespace

PolygonSet passable(const PolygonSet& ground, const Rounding& rounding,
                    const CancelAsked& cancelled) {
  const double radius_m = rounding.radius_m;
  const PolygonSet clear = clear_ground(rounding);
  PolygonSet free = closed_by(ground, radius_m);
  if (covers(clear, free)) return free;
  // Shifting only around those places: a union of sets that a disc can be rolled around inside is
  // such a set again, so the swing keeps the radius.
  PolygonSet places = buffered(difference(free, clear), 2.0 * radius_m, Join::kRound);
  if (places.parts.empty()) return free;
  std::vector<PolygonSet> kept_out;
  append_kept_out(ground, clear, places.parts, radius_m, cancelled, kept_out);
  return difference(free, united(kept_out));
}

PolygonSet rounded(const PolygonSet& ground, const Rounding& rounding,
                   const CancelAsked& cancelled) {
  return opened_by(passable(ground, rounding, cancelled), rounding.corner_radius_m);
}

PolygonSet closed_where_clear(const PolygonSet& ground, const Rounding& rounding) {
  const PolygonSet clear = clear_ground(rounding);
  const PolygonSet shape = simplified(ground, kShape_m);
  std::vector<PolygonSet> kept{shape};
  for (PolygonPart& filled : difference(closed_by(shape, rounding.radius_m), shape).parts) {
    PolygonSet filling{{std::move(filled)}};
    if (area_m2(filling) < kSliverPerRadius2 * rounding.radius_m * rounding.radius_m) continue;
    if (covers(clear, filling)) kept.push_back(std::move(filling));
  }
  return united(kept);
}

PolygonSet opened(const PolygonSet& ground, const Rounding& rounding) {
  return opened_by(simplified(ground, kShape_m), rounding.corner_radius_m);
}

Polyline smoothed_ring(const Ring& ring, double sigma_m) {
  const std::size_t corners = ring.size();
  std::vector<double> station_m(corners + 1, 0.0);
  for (std::size_t i = 0; i < corners; ++i) {
    station_m[i + 1] = station_m[i] + (ring[(i + 1) % corners] - ring[i]).norm();
  }
  const double perimeter_m = station_m.back();
  const auto count =
      std::max<std::size_t>(3, static_cast<std::size_t>(std::ceil(perimeter_m / kRingSpacing_m)));
  const double spacing_m = perimeter_m / static_cast<double>(count);
  std::vector<Eigen::Vector2d> even;
  even.reserve(count);
  for (std::size_t i = 0, edge = 0; i < count; ++i) {
    const double at_m = spacing_m * static_cast<double>(i);
    while (edge + 1 < corners && station_m[edge + 1] < at_m) ++edge;
    const double edge_m = station_m[edge + 1] - station_m[edge];
    const double along = edge_m > 0.0 ? (at_m - station_m[edge]) / edge_m : 0.0;
    even.emplace_back((1.0 - along) * ring[edge] + along * ring[(edge + 1) % corners]);
  }

  const auto reach =
      std::min(count / 2, static_cast<std::size_t>(std::ceil(4.0 * sigma_m / spacing_m)));
  std::vector<double> weight(reach + 1);
  double sum = 0.0;
  for (std::size_t k = 0; k <= reach; ++k) {
    const double x = spacing_m * static_cast<double>(k) / sigma_m;
    weight[k] = std::exp(-0.5 * x * x);
    sum += k == 0 ? weight[k] : 2.0 * weight[k];
  }
  Polyline smooth(count, Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector2d mean = weight[0] * even[i];
    for (std::size_t k = 1; k <= reach; ++k) {
      mean += weight[k] * (even[(i + k) % count] + even[(i + count - k) % count]);
    }
    smooth[i] = mean / sum;
  }
  smooth.push_back(smooth.front());
  return smooth;
}

double tightest_radius_m(const Polyline& closed, double window_m) {
  const std::size_t count = closed.size() - 1;
  const double spacing_m = length_m(closed) / static_cast<double>(count);
  const auto step =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(window_m / spacing_m)), 1,
                              std::max<std::size_t>(1, count / 3));
  double tightest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& middle = closed[i];
    const Eigen::Vector2d a = closed[(i + count - step) % count] - middle;
    const Eigen::Vector2d b = closed[(i + step) % count] - middle;
    const double twice_area_m2 = std::abs(a.x() * b.y() - a.y() * b.x());
    if (twice_area_m2 > 0.0) {
      tightest_m =
          std::min(tightest_m, a.norm() * b.norm() * (a - b).norm() / (2.0 * twice_area_m2));
    }
  }
  return tightest_m;
}

}  // namespace headland

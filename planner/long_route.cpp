#include "planner/long_route.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/connection.h"
#include "planner/disc_cells.h"
#include "planner/turns.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr double kMostCells = 256.0 * 256.0;
constexpr double kLeastCell_m = 0.5;
constexpr double kApart = 2.5;       // places on the way, in turning radii
constexpr std::size_t kAhead = 6;    // places that a turn is looked for to, the furthest first
constexpr int kHeadingsTried = 24;   // at a place
constexpr int kNodesBetween = 2000;  // of a search between two places

// Poses along the way that fit, headed along it as nearly as they can.
std::vector<Pose> places_on(const std::vector<Vector2d>& way, const FreeSpace& space,
                            const RouteOptions& options) {
  std::vector<Pose> places;
  const double apart_m = kApart * options.radius_m;
  double since_m = 0.0;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    since_m += (way[i] - way[i - 1]).norm();
    if (since_m < apart_m) continue;
    const std::size_t before = i >= 3 ? i - 3 : 0;
    const std::size_t after = std::min(i + 3, way.size() - 1);
    const Vector2d along = way[after] - way[before];
    const double heading_rad = std::atan2(along.y(), along.x());
    for (int k = 0; k < kHeadingsTried / 2; ++k) {
      const int steps_off = (k + 1) / 2;
      const double off_rad =
          (k % 2 == 0 ? 1.0 : -1.0) * steps_off * 2.0 * std::numbers::pi / kHeadingsTried;
      const Pose place{way[i], wrap_angle(heading_rad + off_rad)};
      if (!fits(space, place, options.clearance_m)) continue;
      places.push_back(place);
      since_m = 0.0;
      break;
    }
  }
  return places;
}

std::optional<std::vector<Arc>> turn_between(const FreeSpace& space, const Pose& from,
                                             const Pose& to, const RouteOptions& options) {
  for (Turn& turn : turns(from, to, options.radius_m, space.hull.gears)) {
    if (has_odd_run(turn.arcs, false)) continue;
    if (fits_along(space, from, turn.arcs, options.clearance_m)) return std::move(turn.arcs);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Arc>> find_long_route(const FreeSpace& space, const Pose& from,
                                                const Pose& to, const RouteOptions& options,
                                                int* expanded) {
  const double half_m = space.hull.half_width_m;
  const Vector2d size = space.cell_m * Vector2d(space.columns, space.rows);
  const double cell_m = std::max(kLeastCell_m, std::sqrt(size.prod() / kMostCells));
  std::vector<Vector2d> way;
  for (const double share : {1.0, 0.4, 0.0}) {
    const double disc_m = half_m + options.clearance_m + share * (space.reach_m - half_m);
    way = disc_way(disc_cells(space, disc_m, cell_m), from.p_W, to.p_W);
    if (!way.empty()) break;
  }
  if (way.empty()) return std::nullopt;
  std::vector<Pose> places = places_on(way, space, options);
  places.insert(places.begin(), from);
  places.push_back(to);
  std::vector<Arc> arcs;
  Pose at = from;
  int left = options.max_nodes;
  for (std::size_t i = 0; i + 1 < places.size();) {
    stop_if(options.cancelled);
    std::size_t next = std::min(i + kAhead, places.size() - 1);
    std::optional<std::vector<Arc>> piece;
    for (; next > i; --next) {
      piece = turn_between(space, at, places[next], options);
      if (piece) break;
    }
    for (next = piece ? next : i + 1; !piece && next < std::min(i + 4, places.size()); ++next) {
      RouteOptions between = options;
      between.max_nodes = std::min(left, kNodesBetween);
      int nodes = 0;
      piece = find_route(space, at, places[next], between, &nodes);
      left -= nodes;
      if (piece) break;
    }
    if (!piece) {
      if (expanded != nullptr) *expanded = options.max_nodes - left;
      return std::nullopt;
    }
    at = end_of(at, *piece);
    arcs.insert(arcs.end(), piece->begin(), piece->end());
    i = next;
  }
  if (expanded != nullptr) *expanded = options.max_nodes - left;
  return shortened_route(space, from, std::move(arcs), options);
}

}  // namespace headland

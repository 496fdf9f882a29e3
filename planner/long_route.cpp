#include "planner/long_route.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "planner/connection.h"
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

// Square cells over the field in which a disc may be.
struct DiscWays {
  const FreeSpace& space;
  double disc_m = 0.0;
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<char> known{};  // 0: not looked at, 1: free, 2: blocked

  DiscWays(const FreeSpace& in, double radius_m) : space(in), disc_m(radius_m) {
    const Vector2d size = space.cell_m * Vector2d(space.columns, space.rows);
    cell_m = std::max(kLeastCell_m, std::sqrt(size.prod() / kMostCells));
    columns = static_cast<int>(size.x() / cell_m) + 1;
    rows = static_cast<int>(size.y() / cell_m) + 1;
    known.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  }
  int cell_of(const Vector2d& p_W) const {
    const Vector2d cell = (p_W - space.origin_W) / cell_m;
    const int column = std::clamp(static_cast<int>(std::floor(cell.x())), 0, columns - 1);
    const int row = std::clamp(static_cast<int>(std::floor(cell.y())), 0, rows - 1);
    return row * columns + column;
  }
  Vector2d centre_W(int cell) const {
    return space.origin_W + cell_m * Vector2d(cell % columns + 0.5, cell / columns + 0.5);
  }
  bool free(int cell) {
    char& state = known[static_cast<std::size_t>(cell)];
    if (state == 0) state = disc_fits(space, centre_W(cell), disc_m) ? 1 : 2;
    return state == 1;
  }
};

// Centres of the cells on the shortest way; empty when there is none. Both ends count as free.
std::vector<Vector2d> disc_way(DiscWays& ways, const Vector2d& from_W, const Vector2d& to_W) {
  const int start = ways.cell_of(from_W);
  const int goal = ways.cell_of(to_W);
  ways.known[static_cast<std::size_t>(start)] = 1;
  ways.known[static_cast<std::size_t>(goal)] = 1;
  std::vector<float> cost_m(ways.known.size(), std::numeric_limits<float>::max());
  std::vector<int> parent(ways.known.size(), -1);
  using Best = std::pair<double, int>;
  std::priority_queue<Best, std::vector<Best>, std::greater<>> open;
  const auto to_go_m = [&](int cell) { return (ways.centre_W(cell) - ways.centre_W(goal)).norm(); };
  cost_m[static_cast<std::size_t>(start)] = 0.0F;
  open.emplace(to_go_m(start), start);
  while (!open.empty()) {
    const auto [total, cell] = open.top();
    open.pop();
    const double here_m = cost_m[static_cast<std::size_t>(cell)];
    if (total > here_m + to_go_m(cell) + 1e-3) continue;
    if (cell == goal) break;
    const int column = cell % ways.columns;
    const int row = cell / ways.columns;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int c = column + dx;
        const int r = row + dy;
        if (c < 0 || r < 0 || c >= ways.columns || r >= ways.rows) continue;
        const int next = r * ways.columns + c;
        const auto there_m = static_cast<float>(here_m + ways.cell_m * std::hypot(dx, dy));
        if (there_m >= cost_m[static_cast<std::size_t>(next)] || !ways.free(next)) continue;
        cost_m[static_cast<std::size_t>(next)] = there_m;
        parent[static_cast<std::size_t>(next)] = cell;
        open.emplace(there_m + to_go_m(next), next);
      }
    }
  }
  std::vector<Vector2d> way;
  if (parent[static_cast<std::size_t>(goal)] < 0) return way;
  for (int cell = goal; cell >= 0; cell = parent[static_cast<std::size_t>(cell)]) {
    way.push_back(ways.centre_W(cell));
  }
  std::ranges::reverse(way);
  return way;
}

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
      const double off_rad =
          (k % 2 == 0 ? 1.0 : -1.0) * ((k + 1) / 2) * 2.0 * std::numbers::pi / kHeadingsTried;
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
  std::vector<Vector2d> way;
  for (const double share : {1.0, 0.4, 0.0}) {
    DiscWays ways(space, half_m + options.clearance_m + share * (space.reach_m - half_m));
    way = disc_way(ways, from.p_W, to.p_W);
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

#include "planner/swaths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "planner/segment.h"
#include "planner/swath_bands.h"

namespace headland {
namespace {

using std::numbers::pi;

// Two costs that differ by less are the same [part of the cost].
constexpr double kSameCost = 1e-9;
// Edge directions nearer to each other than this are tried once.
constexpr double kSameDirection_rad = 0.1 * pi / 180.0;

bool inside(const Intervals& section, double from_m, double to_m) {
  return std::any_of(section.begin(), section.end(), [&](const Interval& interval) {
    return interval.from_m <= from_m && to_m <= interval.to_m;
  });
}

// Around the lines of a grid.
Bands bands_of(const SwathGrid& grid, double height_m) {
  return {grid.first_line_m - 0.5 * height_m, grid.spacing_m, height_m, grid.lines};
}

// As far as the ground in each line's band reaches; joined where the gap may be driven on.
void append_swaths(const std::vector<Intervals>& extents, const BandEdges& drivable,
                   double bridge_m, SwathGrid& grid) {
  const std::vector<Intervals> open =
      cross_sections(drivable, grid.first_line_m, grid.spacing_m, grid.lines);
  for (int line = 0; line < grid.lines; ++line) {
    const auto k = static_cast<std::size_t>(line);
    const std::size_t first = grid.swaths.size();
    for (const Interval& extent : extents[k]) {
      if (grid.swaths.size() > first && extent.from_m - grid.swaths.back().to_m <= bridge_m &&
          inside(open[k], grid.swaths.back().to_m, extent.from_m)) {
        grid.swaths.back().to_m = extent.to_m;
      } else {
        grid.swaths.push_back({line, extent.from_m, extent.to_m});
      }
    }
  }
}

// Whether the outermost strips begin with the outermost ground.
struct Flush {
  bool low = false;
  bool high = false;
};

// Along how many metres of a line's swaths ground is `taken`.
double beyond_m(const SwathGrid& grid, const Intervals& taken, int line) {
  double sum_m = 0.0;
  for (const Swath& swath : grid.swaths) {
    if (swath.line != line) continue;
    for (const Interval& off : taken) {
      sum_m += std::max(0.0, std::min(off.to_m, swath.to_m) - std::max(off.from_m, swath.from_m));
    }
  }
  return sum_m;
}

Intervals extents_between(const BandEdges& edges, double lowest_m, double highest_m) {
  const double height_m = highest_m - lowest_m;
  return extents_in_bands(edges, {lowest_m, height_m, height_m, 1}).front();
}

Flush sides_to_be_flush(const SwathGrid& grid, const BandEdges& beyond, double width_m) {
  const auto over_m = [&](int line, double below_m, double above_m) {
    const double line_m = grid.first_line_m + line * grid.spacing_m;
    return beyond_m(grid, extents_between(beyond, line_m - below_m, line_m + above_m), line);
  };
  const double spaced_m = 0.5 * grid.spacing_m;
  const double wide_m = 0.5 * width_m;
  const int last = grid.lines - 1;
  return {over_m(0, wide_m, spaced_m) > over_m(0, spaced_m, spaced_m),
          over_m(last, spaced_m, wide_m) > over_m(last, spaced_m, spaced_m)};
}

void spread_flush(const BandEdges& inner, const Flush& flush, double width_m, SwathGrid& grid) {
  const double across_m = inner.highest_m - inner.lowest_m;
  if (grid.lines == 1) {
    const double low_m = inner.lowest_m + 0.5 * width_m;
    const double high_m = inner.highest_m - 0.5 * width_m;
    grid.first_line_m = flush.low && flush.high ? 0.5 * (low_m + high_m)
                        : flush.low             ? low_m
                                                : high_m;
    return;
  }
  const int sides = (flush.low ? 1 : 0) + (flush.high ? 1 : 0);
  grid.spacing_m = (across_m - 0.5 * width_m * sides) / (grid.lines - 0.5 * sides);
  grid.first_line_m = inner.lowest_m + 0.5 * (flush.low ? width_m : grid.spacing_m);
}

// In bands of the spacing, of which the first and the last reach out to the outermost ground: a
// strip laid flush there works half a width beyond its line.
std::vector<Intervals> extents_out_to_all(const BandEdges& inner, const SwathGrid& grid) {
  std::vector<Intervals> extents = extents_in_bands(inner, bands_of(grid, grid.spacing_m));
  const double above_first_m = grid.first_line_m + 0.5 * grid.spacing_m;
  const double below_last_m = grid.first_line_m + (grid.lines - 1.5) * grid.spacing_m;
  const bool one = grid.lines == 1;
  extents.back() = extents_between(inner, one ? inner.lowest_m : below_last_m, inner.highest_m);
  if (!one) extents.front() = extents_between(inner, inner.lowest_m, above_first_m);
  return extents;
}

std::vector<double> directions_to_try(const Field& field) {
  std::vector<std::pair<double, double>> edges;  // length, direction
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d edge = ring[(i + 1) % ring.size()] - ring[i];
      edges.emplace_back(edge.norm(), line_direction_rad(edge));
    }
  };
  add(field.boundary);
  for (const Ring& hole : field.holes) add(hole);
  std::stable_sort(edges.begin(), edges.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> directions;
  std::vector<bool> tried(static_cast<std::size_t>(std::ceil(pi / kSameDirection_rad)) + 1, false);
  const double longest_rad = edges.front().second;
  for (const auto& [edge_m, direction_rad] : edges) {
    const double turned_rad = std::fmod(direction_rad - longest_rad + pi, pi);
    const auto bin = static_cast<std::size_t>(std::lround(turned_rad / kSameDirection_rad));
    if (!tried[bin]) directions.push_back(direction_rad);
    tried[bin] = true;
  }
  for (int step = 1; step * kDirectionGrid_deg < 180.0; ++step) {
    directions.push_back(std::fmod(longest_rad + step * kDirectionGrid_deg * pi / 180.0, pi));
  }
  return directions;
}

}  // namespace

Eigen::Vector2d point_on_line(const SwathGrid& grid, int line, double along_m) {
  const Eigen::Vector2d along(std::cos(grid.direction_rad), std::sin(grid.direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  return along_m * along + (grid.first_line_m + line * grid.spacing_m) * across;
}

double length_m(const SwathGrid& grid) {
  double sum_m = 0.0;
  for (const Swath& swath : grid.swaths) sum_m += swath.to_m - swath.from_m;
  return sum_m;
}

double turn_length_m(double width_m, double turning_radius_m) {
  return width_m >= 2.0 * turning_radius_m ? width_m + (pi - 2.0) * turning_radius_m
                                           : (pi + 2.0) * turning_radius_m - width_m;
}

SwathGrid lay_swaths(const SwathGround& ground, double direction_rad, double width_m,
                     double bridge_m, std::optional<double> through_m) {
  SwathGrid grid;
  grid.direction_rad = direction_rad;
  grid.spacing_m = width_m;
  if (ground.inner.parts.empty()) return grid;
  const BandEdges edges = edges_along(ground.inner, direction_rad);
  double lowest_m = edges.lowest_m;
  if (through_m) {
    const double edge_m = *through_m - width_m / 2.0;
    lowest_m = edge_m - width_m * std::ceil((edge_m - lowest_m - kBandEdge_m) / width_m);
  }
  const double across_m = edges.highest_m - lowest_m;
  const double lines = std::max(1.0, std::ceil((across_m - kBandEdge_m) / width_m));
  if (!(lines <= kMaxSwathLines)) {
    throw PlanInfeasible(
        fmt::format("a working width of {} m needs {:.0f} swaths across the field's {:.0f} m; at "
                    "most {} are planned",
                    width_m, lines, across_m, kMaxSwathLines));
  }
  grid.lines = static_cast<int>(lines);
  grid.spacing_m = through_m ? width_m : across_m / lines;
  grid.first_line_m = lowest_m + grid.spacing_m / 2.0;
  const BandEdges open = edges_along(ground.drivable, direction_rad);
  append_swaths(extents_in_bands(edges, {lowest_m, grid.spacing_m, grid.spacing_m, grid.lines}),
                open, bridge_m, grid);
  if (through_m || ground.beyond.parts.empty()) return grid;
  const Flush flush = sides_to_be_flush(grid, edges_along(ground.beyond, direction_rad), width_m);
  if (!flush.low && !flush.high) return grid;
  spread_flush(edges, flush, width_m, grid);
  grid.swaths.clear();
  append_swaths(extents_out_to_all(edges, grid), open, bridge_m, grid);
  return grid;
}

SwathGrid kept_within(const SwathGrid& grid, const SwathGround& ground, double width_m) {
  if (grid.swaths.empty()) return grid;
  SwathGrid kept = grid;
  kept.swaths.clear();
  const std::vector<Intervals> open =
      cross_sections(edges_along(ground.drivable, grid.direction_rad), grid.first_line_m,
                     grid.spacing_m, grid.lines);
  const std::vector<Intervals> taken =
      extents_in_bands(edges_along(ground.beyond, grid.direction_rad), bands_of(grid, width_m));
  for (const Swath& swath : grid.swaths) {
    const auto k = static_cast<std::size_t>(swath.line);
    for (const Interval& interval : open[k]) {
      double from_m = std::max(swath.from_m, interval.from_m);
      const double to_m = std::min(swath.to_m, interval.to_m);
      const auto keep_to = [&](double end_m) {
        if (end_m - from_m >= kLeastKept_m) kept.swaths.push_back({swath.line, from_m, end_m});
      };
      for (const Interval& off : taken[k]) {
        if (off.to_m <= from_m || off.from_m >= to_m) continue;
        keep_to(off.from_m);
        from_m = off.to_m;
      }
      keep_to(to_m);
    }
  }
  return kept;
}

SwathGrid best_swaths(const Field& field, const SwathGround& ground, double width_m,
                      double bridge_m, const SwathGridCost& cost, const CancelAsked& cancelled) {
  SwathGrid best;
  double least_cost = std::numeric_limits<double>::infinity();
  for (const double direction_rad : directions_to_try(field)) {
    stop_if(cancelled);
    SwathGrid grid = lay_swaths(ground, direction_rad, width_m, bridge_m);
    const double grid_cost = cost(grid);
    if (grid_cost < least_cost * (1.0 - kSameCost) || best.lines == 0) {
      least_cost = grid_cost;
      best = std::move(grid);
    }
  }
  return best;
}

}  // namespace headland

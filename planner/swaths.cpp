#include "planner/swaths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "planner/segment.h"

namespace headland {
namespace {

using std::numbers::pi;

// Lengths that differ by rounding only [m].
constexpr double kSame_m = 1e-6;
// Ground that reaches less than this into a strip is not worth a swath of its own [m].
constexpr double kBandEdge_m = 1e-3;
// Two costs that differ by less are the same [part of the cost].
constexpr double kSameCost = 1e-9;
// Edge directions nearer to each other than this are tried once.
constexpr double kSameDirection_rad = 0.1 * pi / 180.0;

struct Interval {
  double from_m;
  double to_m;
};
using Intervals = std::vector<Interval>;

// Edge in the frame of the swaths: x along, y across, going up.
struct Edge {
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  double along_at(double across_m) const {
    const double height_m = high.y() - low.y();
    if (!(height_m > 0.0)) return low.x();
    return low.x() + (high.x() - low.x()) * (across_m - low.y()) / height_m;
  }
};

struct Edges {
  std::vector<Edge> edges;
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -std::numeric_limits<double>::infinity();
};

Edges edges_along(const PolygonSet& set, double direction_rad) {
  Eigen::Matrix2d to_swaths;
  to_swaths << std::cos(direction_rad), std::sin(direction_rad), -std::sin(direction_rad),
      std::cos(direction_rad);
  Edges result;
  const auto add = [&](const Ring& ring) {
    Eigen::Vector2d before = to_swaths * ring.back();
    for (const Eigen::Vector2d& p_W : ring) {
      const Eigen::Vector2d p = to_swaths * p_W;
      result.edges.push_back(p.y() < before.y() ? Edge{p, before} : Edge{before, p});
      result.lowest_m = std::min(result.lowest_m, p.y());
      result.highest_m = std::max(result.highest_m, p.y());
      before = p;
    }
  };
  for (const PolygonPart& part : set.parts) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return result;
}

// Levels first_m + k spacing_m, k = 0 .. count - 1, that an edge reaches; the upper end does not
// count, so that two edges meeting on a level cross it once.
template <typename Visit>
void visit_levels(const Edge& edge, double first_m, double spacing_m, int count, Visit visit) {
  int k = std::max(0, static_cast<int>(std::ceil((edge.low.y() - first_m) / spacing_m)) - 1);
  for (; k < count; ++k) {
    const double level_m = first_m + k * spacing_m;
    if (level_m >= edge.high.y()) break;
    if (level_m >= edge.low.y()) visit(static_cast<std::size_t>(k), edge.along_at(level_m));
  }
}

std::vector<Intervals> cross_sections(const Edges& edges, double first_m, double spacing_m,
                                      int count) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(count));
  for (const Edge& edge : edges.edges) {
    visit_levels(edge, first_m, spacing_m, count,
                 [&](std::size_t k, double along_m) { crossings[k].push_back(along_m); });
  }
  std::vector<Intervals> sections(crossings.size());
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    std::sort(crossings[k].begin(), crossings[k].end());
    for (std::size_t i = 0; i + 1 < crossings[k].size(); i += 2) {
      sections[k].push_back({crossings[k][i], crossings[k][i + 1]});
    }
  }
  return sections;
}

void merge(Intervals& intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
    return std::pair(a.from_m, a.to_m) < std::pair(b.from_m, b.to_m);
  });
  Intervals merged;
  for (const Interval& next : intervals) {
    if (!merged.empty() && next.from_m <= merged.back().to_m + kSame_m) {
      merged.back().to_m = std::max(merged.back().to_m, next.to_m);
    } else {
      merged.push_back(next);
    }
  }
  intervals = std::move(merged);
}

// Extent along the swaths of each piece of ground inside each band. Such a piece is bounded by
// edges cut to the band and by cross-sections at its two sides, and so is its extent.
// The first band begins at `lowest_m`.
std::vector<Intervals> extents_in_bands(const Edges& edges, double lowest_m, double spacing_m,
                                        int bands) {
  const double first_bottom_m = lowest_m + kBandEdge_m;
  const double first_top_m = lowest_m + spacing_m - kBandEdge_m;
  std::vector<Intervals> extents = cross_sections(edges, first_bottom_m, spacing_m, bands);
  const std::vector<Intervals> tops = cross_sections(edges, first_top_m, spacing_m, bands);
  for (std::size_t k = 0; k < extents.size(); ++k) {
    extents[k].insert(extents[k].end(), tops[k].begin(), tops[k].end());
  }
  for (const Edge& edge : edges.edges) {
    const int nearest = static_cast<int>(std::floor((edge.low.y() - lowest_m) / spacing_m)) - 1;
    for (int k = std::max(0, nearest); k < bands; ++k) {
      const double bottom_m = std::max(first_bottom_m + k * spacing_m, edge.low.y());
      const double top_m = std::min(first_top_m + k * spacing_m, edge.high.y());
      if (first_bottom_m + k * spacing_m > edge.high.y()) break;
      if (bottom_m > top_m) continue;
      const double a_m = edge.along_at(bottom_m);
      const double b_m = edge.high.y() > edge.low.y() ? edge.along_at(top_m) : edge.high.x();
      extents[static_cast<std::size_t>(k)].push_back({std::min(a_m, b_m), std::max(a_m, b_m)});
    }
  }
  for (Intervals& band : extents) merge(band);
  return extents;
}

bool inside(const Intervals& section, double from_m, double to_m) {
  return std::any_of(section.begin(), section.end(), [&](const Interval& interval) {
    return interval.from_m <= from_m && to_m <= interval.to_m;
  });
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

SwathGrid lay_swaths(const PolygonSet& inner, const PolygonSet& drivable, double direction_rad,
                     double width_m, double bridge_m, std::optional<double> through_m) {
  SwathGrid grid;
  grid.direction_rad = direction_rad;
  grid.spacing_m = width_m;
  if (inner.parts.empty()) return grid;
  const Edges edges = edges_along(inner, direction_rad);
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
  const std::vector<Intervals> extents =
      extents_in_bands(edges, lowest_m, grid.spacing_m, grid.lines);
  const std::vector<Intervals> open = cross_sections(edges_along(drivable, direction_rad),
                                                     grid.first_line_m, grid.spacing_m, grid.lines);
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
  return grid;
}

SwathGrid kept_within(const SwathGrid& grid, const PolygonSet& drivable) {
  if (grid.swaths.empty()) return grid;
  SwathGrid kept = grid;
  kept.swaths.clear();
  const std::vector<Intervals> open = cross_sections(edges_along(drivable, grid.direction_rad),
                                                     grid.first_line_m, grid.spacing_m, grid.lines);
  for (const Swath& swath : grid.swaths) {
    for (const Interval& interval : open[static_cast<std::size_t>(swath.line)]) {
      const double from_m = std::max(swath.from_m, interval.from_m);
      const double to_m = std::min(swath.to_m, interval.to_m);
      if (to_m - from_m >= kLeastKept_m) kept.swaths.push_back({swath.line, from_m, to_m});
    }
  }
  return kept;
}

SwathGrid best_swaths(const Field& field, const PolygonSet& inner, const PolygonSet& drivable,
                      double width_m, double bridge_m, const SwathGridCost& cost,
                      const CancelAsked& cancelled) {
  SwathGrid best;
  double least_cost = std::numeric_limits<double>::infinity();
  for (const double direction_rad : directions_to_try(field)) {
    stop_if(cancelled);
    SwathGrid grid = lay_swaths(inner, drivable, direction_rad, width_m, bridge_m);
    const double grid_cost = cost(grid);
    if (grid_cost < least_cost * (1.0 - kSameCost) || best.lines == 0) {
      least_cost = grid_cost;
      best = std::move(grid);
    }
  }
  return best;
}

}  // namespace headland

#include "planner/swath_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace headland {
namespace {

// Lengths that differ by rounding only [m].
constexpr double kSame_m = 1e-6;

// Levels first_m + k spacing_m, k = 0 .. count - 1, that an edge reaches; the upper end does not
// count, so that two edges meeting on a level cross it once.
template <typename Visit>
void visit_levels(const BandEdge& edge, double first_m, double spacing_m, int count, Visit visit) {
  int k = std::max(0, static_cast<int>(std::ceil((edge.low.y() - first_m) / spacing_m)) - 1);
  for (; k < count; ++k) {
    const double level_m = first_m + k * spacing_m;
    if (level_m >= edge.high.y()) break;
    if (level_m >= edge.low.y()) visit(static_cast<std::size_t>(k), edge.along_at(level_m));
  }
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

}  // namespace

double BandEdge::along_at(double across_m) const {
  const double height_m = high.y() - low.y();
  if (!(height_m > 0.0)) return low.x();
  return low.x() + (high.x() - low.x()) * (across_m - low.y()) / height_m;
}

BandEdges edges_along(const PolygonSet& set, double direction_rad) {
  Eigen::Matrix2d to_swaths;
  to_swaths << std::cos(direction_rad), std::sin(direction_rad), -std::sin(direction_rad),
      std::cos(direction_rad);
  BandEdges result;
  result.lowest_m = std::numeric_limits<double>::infinity();
  result.highest_m = -result.lowest_m;
  const auto add = [&](const Ring& ring) {
    Eigen::Vector2d before = to_swaths * ring.back();
    for (const Eigen::Vector2d& p_W : ring) {
      const Eigen::Vector2d p = to_swaths * p_W;
      result.edges.push_back(p.y() < before.y() ? BandEdge{p, before} : BandEdge{before, p});
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

std::vector<Intervals> cross_sections(const BandEdges& edges, double first_m, double spacing_m,
                                      int count) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(count));
  for (const BandEdge& edge : edges.edges) {
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

std::vector<Intervals> extents_in_bands(const BandEdges& edges, const Bands& bands) {
  const double spacing_m = bands.spacing_m;
  const double first_bottom_m = bands.lowest_m + kBandEdge_m;
  const double first_top_m = bands.lowest_m + bands.height_m - kBandEdge_m;
  // An edge may reach into so many bands below the one that it begins in.
  const int overlapping = static_cast<int>(std::ceil(bands.height_m / spacing_m));
  std::vector<Intervals> extents = cross_sections(edges, first_bottom_m, spacing_m, bands.count);
  const std::vector<Intervals> tops = cross_sections(edges, first_top_m, spacing_m, bands.count);
  for (std::size_t k = 0; k < extents.size(); ++k) {
    extents[k].insert(extents[k].end(), tops[k].begin(), tops[k].end());
  }
  for (const BandEdge& edge : edges.edges) {
    const double begins = std::floor((edge.low.y() - bands.lowest_m) / spacing_m);
    const int first = static_cast<int>(std::clamp(begins, 0.0, 1.0 * bands.count)) - overlapping;
    for (int k = std::max(0, first); k < bands.count; ++k) {
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

}  // namespace headland

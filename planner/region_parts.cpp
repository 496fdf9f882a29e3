#include "planner/region_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "planner/decomposition.h"
#include "planner/indexed.h"
#include "planner/part_sweep.h"
#include "planner/segment.h"

namespace headland {
namespace {

using Place = std::pair<double, double>;

Place place_of(const Eigen::Vector2d& p_W) { return {p_W.x(), p_W.y()}; }

// Parts while they are merged: those that were are empty. Neighbours with the length [m] of the
// common edges.
struct MergedParts {
  std::vector<RegionPart> parts;
  std::vector<std::map<int, double>> neighbours;
};

MergedParts begun_merging(std::vector<RegionPart> parts) {
  MergedParts merged{std::move(parts), {}};
  merged.neighbours.resize(merged.parts.size());
  std::map<std::pair<Place, Place>, int> sides;
  for (int part = 0; part < static_cast<int>(merged.parts.size()); ++part) {
    const Ring& ring = at(merged.parts, part).outline_W;
    Eigen::Vector2d a_W = ring.back();
    for (const Eigen::Vector2d& b_W : ring) {
      // The other part goes along the same edge the other way.
      const auto other = sides.find({place_of(b_W), place_of(a_W)});
      if (other != sides.end()) {
        at(merged.neighbours, part)[other->second] += (b_W - a_W).norm();
        at(merged.neighbours, other->second)[part] += (b_W - a_W).norm();
      }
      sides[{place_of(a_W), place_of(b_W)}] = part;
      a_W = b_W;
    }
  }
  return merged;
}

// The outline around both; none where they enclose ground of others or touch in single points.
std::optional<Ring> outline_of_both(const Ring& one, const Ring& other) {
  std::map<Place, Eigen::Vector2d> next;
  std::set<std::pair<Place, Place>> sides;
  const auto each_side = [](const Ring& ring, const auto& visit) {
    Eigen::Vector2d a_W = ring.back();
    for (const Eigen::Vector2d& b_W : ring) {
      visit(a_W, b_W);
      a_W = b_W;
    }
  };
  for (const Ring* ring : {&one, &other}) {
    each_side(*ring, [&](const auto& a_W, const auto& b_W) {
      sides.insert({place_of(a_W), place_of(b_W)});
    });
  }
  bool simple = true;
  for (const Ring* ring : {&one, &other}) {
    each_side(*ring, [&](const auto& a_W, const auto& b_W) {
      if (sides.contains({place_of(b_W), place_of(a_W)})) return;
      simple = next.insert({place_of(a_W), b_W}).second && simple;
    });
  }
  if (!simple || next.empty()) return std::nullopt;
  Ring ring;
  const Place begin = next.begin()->first;
  Place now = begin;
  do {
    const auto found = next.find(now);
    if (found == next.end()) return std::nullopt;
    ring.push_back(found->second);
    now = place_of(found->second);
  } while (now != begin && ring.size() <= next.size());
  if (ring.size() != next.size()) return std::nullopt;
  return ring;
}

void merge_into(MergedParts& merged, int kept, int gone, RegionPart whole) {
  at(merged.parts, kept) = std::move(whole);
  at(merged.parts, gone) = {};
  for (const auto& [neighbour, edge_m] : at(merged.neighbours, gone)) {
    at(merged.neighbours, neighbour).erase(gone);
    if (neighbour == kept) continue;
    at(merged.neighbours, neighbour)[kept] += edge_m;
    at(merged.neighbours, kept)[neighbour] += edge_m;
  }
  at(merged.neighbours, gone).clear();
}

std::vector<RegionPart> left_of_merging(MergedParts merged) {
  std::erase_if(merged.parts, [](const RegionPart& part) { return part.outline_W.empty(); });
  return std::move(merged.parts);
}

// The direction of those given in which the outline is swept whole with the fewest lines.
std::optional<double> best_sweep_rad(const Ring& outline, const std::vector<double>& directions_rad,
                                     double width_m) {
  std::optional<double> best_rad;
  int fewest = 0;
  for (const double direction_rad : directions_rad) {
    if (!is_swept_whole(outline, direction_rad)) continue;
    const int lines = sweep_line_count(outline, direction_rad, width_m);
    if (best_rad && lines >= fewest) continue;
    best_rad = direction_rad;
    fewest = lines;
  }
  return best_rad;
}

// How two parts merge, if one direction of sweep serves both.
struct Merger {
  RegionPart whole;
  int lines_saved = 0;
};

std::optional<Merger> merger_of(const RegionPart& one, const RegionPart& other, double width_m) {
  auto outline = outline_of_both(one.outline_W, other.outline_W);
  if (!outline) return std::nullopt;
  const auto best_rad = best_sweep_rad(*outline, {one.sweep_rad, other.sweep_rad}, width_m);
  if (!best_rad) return std::nullopt;
  const auto lines = [&](const Ring& ring, double rad) {
    return sweep_line_count(ring, rad, width_m);
  };
  const int saved = lines(one.outline_W, one.sweep_rad) + lines(other.outline_W, other.sweep_rad) -
                    lines(*outline, *best_rad);
  if (saved < 0) return std::nullopt;
  return Merger{{std::move(*outline), *best_rad}, saved};
}

std::vector<double> edge_directions_rad(const Ring& outline) {
  const Ring corners = corners_of(outline);
  std::vector<double> directions_rad;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    directions_rad.push_back(line_direction_rad(corners[(i + 1) % corners.size()] - corners[i]));
  }
  return directions_rad;
}

// The part made one with its neighbour; none where no direction sweeps both whole.
std::optional<RegionPart> absorbed(const RegionPart& neighbour, const RegionPart& small,
                                   double width_m) {
  auto outline = outline_of_both(neighbour.outline_W, small.outline_W);
  if (!outline) return std::nullopt;
  if (is_swept_whole(*outline, neighbour.sweep_rad)) {
    return RegionPart{std::move(*outline), neighbour.sweep_rad};
  }
  const auto best_rad = best_sweep_rad(*outline, edge_directions_rad(*outline), width_m);
  if (!best_rad) return std::nullopt;
  return RegionPart{std::move(*outline), *best_rad};
}

// Gives the part to the neighbour it fits; whether there is one.
bool give_to_neighbour(MergedParts& merged, int small, double width_m) {
  std::vector<std::pair<double, int>> by_edge;
  for (const auto& [neighbour, edge_m] : at(merged.neighbours, small)) {
    by_edge.emplace_back(-edge_m, neighbour);
  }
  std::ranges::sort(by_edge);
  for (const auto& [edge_m, neighbour] : by_edge) {
    auto whole = absorbed(at(merged.parts, neighbour), at(merged.parts, small), width_m);
    if (!whole) continue;
    merge_into(merged, neighbour, small, std::move(*whole));
    return true;
  }
  return false;
}

double outline_sum_m2(double sum_m2, const Ring& ring) { return sum_m2 + signed_area_m2(ring); }

}  // namespace

double area_m2(const RegionParts& parts) {
  return std::accumulate(
      parts.parts.begin(), parts.parts.end(), 0.0,
      [](double sum_m2, const RegionPart& part) { return outline_sum_m2(sum_m2, part.outline_W); });
}

double dropped_m2(const RegionParts& parts) {
  return std::accumulate(parts.dropped_W.begin(), parts.dropped_W.end(), 0.0, outline_sum_m2);
}

std::string_view decomposition_name(Decomposition decomposition) {
  switch (decomposition) {
    case Decomposition::kConvex:
      return "convex";
    case Decomposition::kTrapezoidal:
      return "trapezoidal";
    case Decomposition::kBoustrophedon:
      break;
  }
  return "boustrophedon";
}

RegionParts region_parts(const PolygonSet& ground, const PartsOptions& options,
                         const CancelAsked& cancelled) {
  RegionParts parts;
  for (const PolygonPart& piece : ground.parts) {
    stop_if(cancelled);
    const double slice_rad =
        options.slice_rad < 0.0 ? least_width_direction_rad(piece) : options.slice_rad;
    const bool boustrophedon = options.decomposition == Decomposition::kBoustrophedon;
    const std::vector<Ring> outlines = boustrophedon ? boustrophedon_cells(piece, slice_rad)
                                       : options.decomposition == Decomposition::kTrapezoidal
                                           ? trapezoids(piece, slice_rad)
                                           : convex_pieces(piece);
    for (const Ring& outline : outlines) {
      parts.parts.push_back({outline, boustrophedon ? slice_rad : longest_edge_rad(outline)});
    }
  }
  if (options.small == SmallParts::kMerge) {
    merge_small_parts(parts, options.least_m2, options.width_m, cancelled);
  } else {
    drop_small_parts(parts, options.least_m2);
  }
  if (options.merge) merge_parts(parts, options.width_m, cancelled);
  return parts;
}

void drop_small_parts(RegionParts& parts, double least_m2) {
  const auto is_large = [&](const RegionPart& part) {
    return signed_area_m2(part.outline_W) >= least_m2;
  };
  const auto small = std::stable_partition(parts.parts.begin(), parts.parts.end(), is_large);
  for (auto part = small; part != parts.parts.end(); ++part) {
    parts.dropped_W.push_back(std::move(part->outline_W));
  }
  parts.parts.erase(small, parts.parts.end());
}

void merge_small_parts(RegionParts& parts, double least_m2, double width_m,
                       const CancelAsked& cancelled) {
  MergedParts merged = begun_merging(std::move(parts.parts));
  std::set<std::pair<double, int>> small;
  for (int part = 0; part < static_cast<int>(merged.parts.size()); ++part) {
    const double own_m2 = signed_area_m2(at(merged.parts, part).outline_W);
    if (own_m2 < least_m2) small.insert({own_m2, part});
  }
  for (const auto& [own_m2, part] : small) {
    stop_if(cancelled);
    // It may have grown since.
    if (signed_area_m2(at(merged.parts, part).outline_W) >= least_m2) continue;
    give_to_neighbour(merged, part, width_m);
  }
  parts.parts = left_of_merging(std::move(merged));
}

void merge_parts(RegionParts& parts, double width_m, const CancelAsked& cancelled) {
  MergedParts merged = begun_merging(std::move(parts.parts));
  std::map<std::pair<int, int>, Merger> mergers;
  const auto look_at = [&](int one, int other) {
    const std::pair<int, int> pair = std::minmax(one, other);
    mergers.erase(pair);
    auto merger = merger_of(at(merged.parts, pair.first), at(merged.parts, pair.second), width_m);
    if (merger) mergers.insert({pair, std::move(*merger)});
  };
  for (int part = 0; part < static_cast<int>(merged.parts.size()); ++part) {
    stop_if(cancelled);
    for (const auto& [other, edge_m] : at(merged.neighbours, part)) {
      if (part < other) look_at(part, other);
    }
  }
  while (!mergers.empty()) {
    stop_if(cancelled);
    const auto worth = [&](const auto& entry) {
      const auto& [pair, merger] = entry;
      return std::tuple(merger.lines_saved, at(merged.neighbours, pair.first).at(pair.second));
    };
    const auto best = std::ranges::max_element(mergers, {}, worth);
    const auto [kept, gone] = best->first;
    merge_into(merged, kept, gone, std::move(best->second.whole));
    std::erase_if(mergers, [&, gone = gone](const auto& entry) {
      return entry.first.first == gone || entry.first.second == gone;
    });
    for (const auto& [other, edge_m] : at(merged.neighbours, kept)) look_at(kept, other);
  }
  parts.parts = left_of_merging(std::move(merged));
}

}  // namespace headland

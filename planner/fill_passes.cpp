#include "planner/fill_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "planner/segment.h"

namespace headland {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double kStep_m = 0.25;  // between poses looked at
constexpr double kSameDirection_rad = pi / 180.0;
constexpr std::size_t kMostEdgeDirections = 6;  // of edges near a patch, those next to most of it
constexpr int kSamples = 48;                    // cells of a patch that its edges are looked for at
constexpr double kShortestFill_m = 0.5;         // pass
// Patches of this that no line beside anything works are looked at in this many directions of the
// half circle, too, line by line.
constexpr double kLargePatch_m2 = 1.0;
constexpr int kEveryDirection = 18;
constexpr double kLineStep_m = 0.25;
constexpr double kMostLines = 100.0;  // across a patch
// Lines further in, where what is beside the patch is in the way [part of the working width].
constexpr std::array kShifts = {0.0, 0.1, 0.25, 0.5};

struct Patch {
  std::vector<std::size_t> cells;
  bool operator<(const Patch& other) const {
    return cells.size() != other.cells.size() ? cells.size() < other.cells.size()
                                              : cells.front() > other.cells.front();
  }
};

// Connected cells to work among `from`, each once; `taken` marks what was seen.
void append_patches(const WorkedGround& ground, const std::vector<std::size_t>& from,
                    std::size_t least_cells, std::vector<char>& taken,
                    std::priority_queue<Patch>& patches) {
  const auto columns = static_cast<std::size_t>(ground.columns);
  std::vector<std::size_t> seen;
  for (const std::size_t seed : from) {
    if (taken[seed] != 0 || ground.cells[seed] != GroundState::kToWork) continue;
    Patch patch;
    const auto take = [&](std::size_t cell) {
      if (taken[cell] != 0 || ground.cells[cell] != GroundState::kToWork) return;
      taken[cell] = 1;
      patch.cells.push_back(cell);
    };
    take(seed);
    // The raster has a rim of cells outside the field.
    for (std::size_t next = 0; next < patch.cells.size(); ++next) {
      const std::size_t cell = patch.cells[next];
      take(cell + 1);
      take(cell - 1);
      take(cell + columns);
      take(cell - columns);
    }
    seen.insert(seen.end(), patch.cells.begin(), patch.cells.end());
    if (patch.cells.size() >= least_cells) patches.push(std::move(patch));
  }
  for (const std::size_t cell : seen) taken[cell] = 0;
}

struct Filling {
  const FreeSpace& space;
  const FillOptions& options;
  WorkedGround& ground;

  Vector2d centre_W(std::size_t cell) const {
    const auto columns = static_cast<std::size_t>(ground.columns);
    return ground.centre_W(static_cast<int>(cell % columns), static_cast<int>(cell / columns));
  }
};

// A direction of the half circle and how much of a patch speaks for it.
struct Direction {
  double angle_rad = 0.0;
  double weight = 0.0;
};

// What lies beside a patch: directions, and places on lines that run beside edges as near as the
// implement or the hull may, in the edges' own directions.
struct Surroundings {
  std::vector<Direction> directions;
  std::vector<Pose> lines;
};

void add_direction(double angle_rad, double weight, std::vector<Direction>& directions) {
  const double folded_rad = angle_rad - pi * std::floor(angle_rad / pi);
  for (Direction& known : directions) {
    const double apart_rad = std::abs(known.angle_rad - folded_rad);
    if (std::min(apart_rad, pi - apart_rad) > kSameDirection_rad) continue;
    known.weight += weight;
    return;
  }
  directions.push_back({folded_rad, weight});
}

// Beside an edge a hull wider than the implement stays further away.
double beside_m(const Filling& filling) {
  return std::max(0.5 * filling.options.working_width_m,
                  filling.space.hull.half_width_m + filling.options.clearance_m);
}

// Of edges and obstacles near some of the patch's cells.
Surroundings surroundings_of(const Filling& filling, const Patch& patch) {
  const double near_m = filling.options.working_width_m + reach_with_bar_m(filling.space.hull);
  Surroundings around;
  std::vector<Direction>& directions = around.directions;
  std::vector<char> near_edge(filling.space.edges.size(), 0);
  const std::size_t step = std::max<std::size_t>(1, patch.cells.size() / kSamples);
  for (std::size_t i = 0; i < patch.cells.size(); i += step) {
    const Vector2d p_W = filling.centre_W(patch.cells[i]);
    for (std::size_t k = 0; k < near_edge.size(); ++k) {
      const FreeSpace::Edge& edge = filling.space.edges[k];
      const double away_m = distance_to_segment(p_W, edge.a_W, edge.b_W);
      if (away_m > near_m) continue;
      const Vector2d along = edge.b_W - edge.a_W;
      const double along_rad = std::atan2(along.y(), along.x());
      add_direction(along_rad, 1.0 / (1.0 + away_m), directions);
      if (near_edge[k] != 0 || away_m > beside_m(filling)) continue;
      near_edge[k] = 1;
      around.lines.push_back({edge.a_W + beside_m(filling) * left_of(along_rad), along_rad});
    }
    for (const Obstacle& obstacle : filling.space.obstacles) {
      if (obstacle_gap_m(obstacle, p_W) > near_m) continue;
      const Vector2d across = nearest_of(obstacle, p_W) - p_W;
      add_direction(std::atan2(across.x(), -across.y()), 0.1, directions);
    }
  }
  std::ranges::stable_sort(directions, std::ranges::greater{}, &Direction::weight);
  if (directions.size() > kMostEdgeDirections) directions.resize(kMostEdgeDirections);
  return around;
}

// The way the patch is longest.
double long_axis_rad(const Filling& filling, const Patch& patch) {
  Vector2d middle = Vector2d::Zero();
  for (const std::size_t cell : patch.cells) middle += filling.centre_W(cell);
  middle /= static_cast<double>(patch.cells.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const std::size_t cell : patch.cells) {
    const Vector2d p = filling.centre_W(cell) - middle;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
  }
  return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

std::vector<double> headings_for(const Filling& filling, const Patch& patch,
                                 const Surroundings& around) {
  std::vector<Direction> directions;
  for (const Direction& beside : around.directions) {
    add_direction(beside.angle_rad, 1.0, directions);
    add_direction(beside.angle_rad + 0.5 * pi, 1.0, directions);
  }
  const double axis_rad = long_axis_rad(filling, patch);
  add_direction(axis_rad, 1.0, directions);
  add_direction(axis_rad + 0.5 * pi, 1.0, directions);
  for (const double angle_rad : filling.options.directions_rad) {
    add_direction(angle_rad, 1.0, directions);
  }
  std::vector<double> headings_rad;
  for (const Direction& direction : directions) {
    headings_rad.push_back(direction.angle_rad);
    headings_rad.push_back(direction.angle_rad + pi);
  }
  return headings_rad;
}

std::vector<double> every_heading() {
  std::vector<double> headings_rad;
  headings_rad.reserve(2 * kEveryDirection);
  for (int i = 0; i < 2 * kEveryDirection; ++i) headings_rad.push_back(pi * i / kEveryDirection);
  return headings_rad;
}

// A line of the implement's middle in direction `heading_rad`, `across_m` to the left of the
// origin of W, from one place along it to another.
struct Line {
  double heading_rad = 0.0;
  double across_m = 0.0;
  double from_m = 0.0;
  double to_m = 0.0;
  double gain_m2 = 0.0;

  Vector2d at_W(double along_m) const {
    return along_m * direction_of(heading_rad) + across_m * left_of(heading_rad);
  }
};

bool fits_at(const Filling& filling, const Line& line, double along_m) {
  const Pose pose{line.at_W(along_m - filling.space.hull.bar_x_m), line.heading_rad};
  return fits(filling.space, pose, filling.options.clearance_m) &&
         works_inside(filling.space, pose, filling.options.overhang_m);
}

// A patch in the frame of a heading: its cells along it and across, sorted by the latter.
struct Turned {
  std::vector<std::pair<double, double>> across_along_m;
  double low_m = 0.0;
  double high_m = 0.0;
};

Turned turned(const Filling& filling, const Patch& patch, double heading_rad) {
  const Vector2d ahead = direction_of(heading_rad);
  const Vector2d left = left_of(heading_rad);
  Turned result;
  result.across_along_m.reserve(patch.cells.size());
  for (const std::size_t cell : patch.cells) {
    const Vector2d p_W = filling.centre_W(cell);
    result.across_along_m.emplace_back(left.dot(p_W), ahead.dot(p_W));
  }
  const auto [low, high] = std::ranges::minmax_element(result.across_along_m);
  result.low_m = low->first;
  result.high_m = high->first;
  return result;
}

// The stretch of the line along which the hull fits that works most of the patch.
void find_stretch(const Filling& filling, const Turned& patch, Line& line) {
  const double half_m = 0.5 * filling.options.working_width_m;
  const double cell_m2 = filling.ground.cell_m * filling.ground.cell_m;
  double first_m = std::numeric_limits<double>::infinity();
  double last_m = -first_m;
  for (const auto& [across_m, along_m] : patch.across_along_m) {
    if (std::abs(across_m - line.across_m) > half_m) continue;
    first_m = std::min(first_m, along_m);
    last_m = std::max(last_m, along_m);
  }
  line.gain_m2 = 0.0;
  if (last_m < first_m) return;
  const auto bins = static_cast<std::size_t>((last_m - first_m) / kStep_m) + 1;
  std::vector<double> gain_m2(bins, 0.0);
  for (const auto& [across_m, along_m] : patch.across_along_m) {
    if (std::abs(across_m - line.across_m) > half_m) continue;
    gain_m2[static_cast<std::size_t>((along_m - first_m) / kStep_m)] += cell_m2;
  }
  // Bin k lies between the places k and k + 1, at both of which the hull must fit.
  const auto place_m = [&](std::size_t k) { return first_m + kStep_m * static_cast<double>(k); };
  double sum_m2 = 0.0;
  std::size_t begin = 0;
  bool before = fits_at(filling, line, place_m(0));
  for (std::size_t k = 0; k < bins; ++k) {
    const bool after = fits_at(filling, line, place_m(k + 1));
    if (before && after) {
      if (sum_m2 == 0.0) begin = k;  // nothing worked yet: the stretch need not begin so early
      sum_m2 += gain_m2[k];
      if (sum_m2 > line.gain_m2) {
        line.gain_m2 = sum_m2;
        line.from_m = place_m(begin);
        line.to_m = place_m(k + 1);
      }
    } else {
      sum_m2 = 0.0;
    }
    before = after;
  }
}

Line best_line(const Filling& filling, const Patch& patch) {
  const FillOptions& options = filling.options;
  const double turn_m = 2.0 * pi * options.turning_radius_m;
  const Surroundings around = surroundings_of(filling, patch);
  Line best;
  double best_score = 0.0;
  const auto try_line = [&](const Turned& in_frame, double heading_rad, double across_m) {
    Line line{heading_rad, across_m};
    find_stretch(filling, in_frame, line);
    const double score = line.gain_m2 / (line.to_m - line.from_m + turn_m);
    if (score <= best_score) return;
    best_score = score;
    best = line;
  };
  const std::vector<double> beside_rad = headings_for(filling, patch, around);
  const auto try_headings = [&](const std::vector<double>& headings_rad, auto try_lines) {
    for (const double heading_rad : headings_rad) {
      stop_if(options.cancelled);
      const Turned in_frame = turned(filling, patch, heading_rad);
      try_lines(in_frame, heading_rad);
    }
  };
  try_headings(beside_rad, [&](const Turned& in_frame, double heading_rad) {
    try_line(in_frame, heading_rad, 0.5 * (in_frame.low_m + in_frame.high_m));
    for (const double shift : kShifts) {
      const double in_m = beside_m(filling) + shift * options.working_width_m;
      try_line(in_frame, heading_rad, in_frame.low_m + in_m);
      try_line(in_frame, heading_rad, in_frame.high_m - in_m);
    }
  });
  for (const Pose& beside : around.lines) {
    stop_if(options.cancelled);
    for (const double heading_rad : {beside.heading_rad, beside.heading_rad + pi}) {
      try_line(turned(filling, patch, heading_rad), heading_rad,
               left_of(heading_rad).dot(beside.p_W));
    }
  }
  const double cell_m2 = filling.ground.cell_m * filling.ground.cell_m;
  const bool large = static_cast<double>(patch.cells.size()) * cell_m2 >= kLargePatch_m2;
  if (!large || best.gain_m2 >= options.least_patch_m2) return best;
  // In a tip the implement reaches back over worked ground.
  const auto across_patch = [&](const Turned& in_frame, double heading_rad) {
    const double low_m = in_frame.low_m - 0.5 * options.working_width_m;
    const double high_m = in_frame.high_m + 0.5 * options.working_width_m;
    const double step_m = std::max(kLineStep_m, (high_m - low_m) / kMostLines);
    for (double across_m = low_m + step_m; across_m < high_m; across_m += step_m) {
      try_line(in_frame, heading_rad, across_m);
    }
  };
  try_headings(beside_rad, across_patch);
  try_headings(every_heading(), across_patch);
  return best;
}

// Lets a line run on while that works more ground of other patches, and is long enough to drive.
void extend(const Filling& filling, Line& line) {
  constexpr double kPiece_m = 1.0;
  const double half_m = 0.5 * filling.options.working_width_m;
  const double least_m2 = 0.25 * filling.options.working_width_m * kPiece_m;
  const Vector2d half_bar = half_m * left_of(line.heading_rad);
  for (const double sign : {1.0, -1.0}) {
    double& end_m = sign > 0.0 ? line.to_m : line.from_m;
    for (;;) {
      const bool too_short = line.to_m - line.from_m < kShortestFill_m;
      double next_m = end_m;
      while (std::abs(next_m - end_m) < kPiece_m &&
             fits_at(filling, line, next_m + sign * kStep_m)) {
        next_m += sign * kStep_m;
      }
      if (next_m == end_m) break;
      const double more_m2 = to_work_m2(
          filling.ground, between_bars(line.at_W(end_m), line.at_W(next_m), half_bar, half_bar));
      if (more_m2 < least_m2 && !too_short) break;
      end_m = next_m;
    }
  }
}

}  // namespace

std::vector<Pass> fill_passes(const FreeSpace& space, const FillOptions& options,
                              WorkedGround& ground) {
  const Filling filling{space, options, ground};
  const double cell_m2 = ground.cell_m * ground.cell_m;
  const auto least_cells = static_cast<std::size_t>(std::ceil(options.least_patch_m2 / cell_m2));
  std::vector<std::size_t> all;
  for (std::size_t cell = 0; cell < ground.cells.size(); ++cell) {
    if (ground.cells[cell] == GroundState::kToWork) all.push_back(cell);
  }
  std::vector<char> taken(ground.cells.size(), 0);
  std::priority_queue<Patch> patches;
  append_patches(ground, all, least_cells, taken, patches);
  std::vector<Pass> passes;
  while (!patches.empty()) {
    stop_if(options.cancelled);
    const Patch patch = patches.top();
    patches.pop();
    const auto worked = [&](std::size_t cell) {
      return ground.cells[cell] != GroundState::kToWork;
    };
    // A pass of another patch led over it: what it left is smaller and may be in pieces.
    if (std::ranges::any_of(patch.cells, worked)) {
      append_patches(ground, patch.cells, least_cells, taken, patches);
      continue;
    }
    Line line = best_line(filling, patch);
    if (line.gain_m2 < options.least_patch_m2) continue;
    extend(filling, line);
    if (line.to_m - line.from_m < kShortestFill_m) continue;
    const Vector2d half_bar = 0.5 * options.working_width_m * left_of(line.heading_rad);
    const Vector2d from_W = line.at_W(line.from_m);
    const Vector2d to_W = line.at_W(line.to_m);
    const Quadrangle strip = between_bars(from_W, to_W, half_bar, half_bar);
    if (to_work_m2(ground, strip) < options.least_patch_m2) continue;
    work(ground, strip);
    passes.push_back({PassKind::kSwath, {from_W, to_W}, true});
    append_patches(ground, patch.cells, least_cells, taken, patches);
  }
  return passes;
}

}  // namespace headland

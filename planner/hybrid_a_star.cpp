#include "planner/hybrid_a_star.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>

#include "planner/connection.h"
#include "planner/disc_cells.h"
#include "planner/tight_pose.h"
#include "planner/turns.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr int kHeadings = 72;  // bins of 5 degrees
// Each step turns by three bins, so headings stay on the bins and a step leaves its cell.
constexpr double kStepAngle_rad = 3.0 * 2.0 * std::numbers::pi / kHeadings;
constexpr double kCellsPerStep = 2.0;
// Straightens the route: what changing the steering costs, in turning radii.
constexpr double kSteeringChangeCost = 0.1;
// Reeds-Shepp lengths only tell more than the grid near the goal; within so many radii.
constexpr double kNearGoal = 8.0;
// A closing curve is tried at every node near the goal and at every so-manieth elsewhere.
constexpr int kTryEvery = 20;
constexpr int kAskEvery = 100;  // nodes, milliseconds, between looks at whether to go on
// Weighs the way still to go: routes may cost up to this factor more than the best, and are found
// in a fraction of the nodes.
constexpr double kGreed = 1.5;
constexpr double kGuideCellsAlong = 256.0;
constexpr double kMinGuideCell_m = 0.5;

// Shortest ways to the goal for a disc of the hull's half width.
struct Guide {
  DiscCells cells;
  std::vector<float> length_m;

  double to_go_m(const Vector2d& p_W) const {
    return length_m[static_cast<std::size_t>(cells.at(p_W))];
  }
};

struct Reached {
  double cost;
  int index;
  bool operator>(const Reached& other) const {
    return cost != other.cost ? cost > other.cost : index > other.index;
  }
};
using Queue = std::priority_queue<Reached, std::vector<Reached>, std::greater<>>;

// Gates of the goal are as far from it as they are; those of the start need not be found free.
Guide guide_to(const FreeSpace& space, const Pose& from, const Pose& to,
               const std::vector<Gate>& gates) {
  const double longer_m = space.cell_m * std::max(space.columns, space.rows);
  Guide guide{disc_cells(space, space.hull.half_width_m,
                         std::max(kMinGuideCell_m, longer_m / kGuideCellsAlong)),
              {}};
  guide.cells.free[static_cast<std::size_t>(guide.cells.at(from.p_W))] = 1;
  std::vector<WayBegin> begins{{guide.cells.at(to.p_W), 0.0}};
  for (const Gate& gate : gates) begins.push_back({guide.cells.at(gate.pose.p_W), gate.length_m});
  guide.length_m = disc_way_lengths(guide.cells, begins);
  return guide;
}

struct Node {
  Pose pose;
  Arc arrival;  // the step that led here
  int parent = -1;
  double cost_m = 0.0;
  bool closed = false;
};

struct Search {
  const FreeSpace& space;
  const Pose& to;
  const RouteOptions& options;
  std::vector<Gate> gates;  // of the goal
  Guide guide;
  double step_m;
  std::vector<Node> nodes;
  std::unordered_map<std::uint64_t, int> at_cell;
  Queue open;
};

std::uint64_t key_of(const Search& search, const Node& node) {
  const Vector2d cell =
      (node.pose.p_W - search.guide.cells.origin_W) / search.step_m * kCellsPerStep;
  const double turn = wrap_angle(node.pose.heading_rad) / (2.0 * std::numbers::pi);
  const int heading = static_cast<int>(std::lround((turn + 1.0) * kHeadings)) % kHeadings;
  const auto column = static_cast<std::uint32_t>(static_cast<int>(std::floor(cell.x())) + 0x8000);
  const auto row = static_cast<std::uint32_t>(static_cast<int>(std::floor(cell.y())) + 0x8000);
  const std::uint64_t gear = node.arrival.gear == Gear::kForward ? 0 : 1;
  return (static_cast<std::uint64_t>(column) << 40U) | (static_cast<std::uint64_t>(row) << 16U) |
         (static_cast<std::uint64_t>(heading) << 1U) | gear;
}

double to_go_m(const Search& search, const Pose& pose) {
  const double around_m = search.guide.to_go_m(pose.p_W);
  if (around_m > kNearGoal * search.options.radius_m) return around_m;
  const double radius_m = search.options.radius_m;
  return std::max(around_m, search.space.hull.gears == Gears::kForwardOnly
                                ? forward_length_m(pose, search.to, radius_m)
                                : reeds_shepp_length_m(pose, search.to, radius_m));
}

// The shortest curve to there, whatever is in the way.
std::optional<Turn> curve_to(const Search& search, const Pose& pose, const Pose& to) {
  if (search.space.hull.gears == Gears::kBoth) {
    return reeds_shepp(pose, to, search.options.radius_m);
  }
  std::vector<Turn> found = turns(pose, to, search.options.radius_m, Gears::kForwardOnly);
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

// The shortest curve to the goal that fits, or the cheapest one to a gate and in from there, for
// less than `most_m`.
std::optional<Turn> closing_curve(const Search& search, const Pose& pose, double most_m) {
  const double clearance_m = search.options.clearance_m;
  const auto fitting = [&](const std::optional<Turn>& turn) {
    return turn && turn->cost_m < most_m && !has_odd_run(turn->arcs, false) &&
           fits_along(search.space, pose, turn->arcs, clearance_m);
  };
  std::optional<Turn> best = curve_to(search, pose, search.to);
  if (!fitting(best)) best.reset();
  for (const Gate& gate : search.gates) {
    const bool forward_only = search.space.hull.gears == Gears::kForwardOnly;
    if (gate.ahead && forward_only) continue;
    auto turn = curve_to(search, pose, gate.pose);
    if (!turn) continue;
    turn->arcs.push_back({gate.length_m, 0.0, gate.ahead ? Gear::kReverse : Gear::kForward});
    turn->cost_m = cost_m(turn->arcs);
    if (best && turn->cost_m >= best->cost_m) continue;
    if (fitting(turn)) best = std::move(turn);
  }
  return best;
}

void reach(Search& search, const Node& node) {
  const double to_go = to_go_m(search, node.pose);
  if (to_go >= kNoDiscWay_m) return;
  const double total_m = node.cost_m + kGreed * to_go;
  const auto [entry, is_new] = search.at_cell.try_emplace(key_of(search, node), 0);
  if (!is_new) {
    const Node& known = search.nodes[static_cast<std::size_t>(entry->second)];
    if (known.closed || known.cost_m <= node.cost_m) return;
  }
  entry->second = static_cast<int>(search.nodes.size());
  search.nodes.push_back(node);
  search.open.push({total_m, entry->second});
}

void expand(Search& search, int index) {
  const Node node = search.nodes[static_cast<std::size_t>(index)];
  const double curvature = 1.0 / search.options.radius_m;
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    if (gear == Gear::kReverse && search.space.hull.gears == Gears::kForwardOnly) continue;
    for (const double bend : {0.0, curvature, -curvature}) {
      Node next;
      next.arrival = {search.step_m, bend, gear};
      next.pose = pose_along(node.pose, next.arrival, search.step_m);
      next.parent = index;
      next.cost_m = node.cost_m + cost_m(std::vector<Arc>{next.arrival});
      if (node.parent >= 0) {
        if (gear != node.arrival.gear) next.cost_m += kCuspCost_m;
        if (bend != node.arrival.curvature_per_m) {
          next.cost_m += kSteeringChangeCost * search.options.radius_m;
        }
      }
      if (!fits_along(search.space, node.pose, {next.arrival}, search.options.clearance_m)) {
        continue;
      }
      reach(search, next);
    }
  }
}

// The start, and the gates that lead out of it: where walls are near, the first steps are straight.
void begin_at(Search& search, const Pose& from) {
  search.nodes.push_back({from, {}, -1, 0.0, false});
  const double to_go = to_go_m(search, from);
  if (to_go < kNoDiscWay_m) {
    search.at_cell[key_of(search, search.nodes.front())] = 0;
    search.open.push({kGreed * to_go, 0});
  }
  for (const Gate& gate : gates_of(search.space, from, search.options.clearance_m)) {
    if (!gate.ahead && search.space.hull.gears == Gears::kForwardOnly) continue;
    const Arc way{gate.length_m, 0.0, gate.ahead ? Gear::kForward : Gear::kReverse};
    reach(search, {gate.pose, way, 0, cost_m(std::vector<Arc>{way}), false});
  }
}

std::vector<Arc> arcs_to(const Search& search, int index) {
  std::vector<Arc> arcs;
  for (int i = index; search.nodes[static_cast<std::size_t>(i)].parent >= 0;) {
    const Node& node = search.nodes[static_cast<std::size_t>(i)];
    arcs.push_back(node.arrival);
    i = node.parent;
  }
  std::reverse(arcs.begin(), arcs.end());
  return arcs;
}

// Replaces stretches by closed-form turns that fit and cost less: from each pose to the furthest,
// then half as far, and so on.
std::vector<Arc> shortened(const FreeSpace& space, const Pose& from, const std::vector<Arc>& arcs,
                           const RouteOptions& options) {
  std::vector<Arc> result;
  Pose pose = from;
  for (std::size_t i = 0; i < arcs.size();) {
    std::size_t taken = 1;
    std::vector<Arc> piece = {arcs[i]};
    for (std::size_t count = arcs.size() - i; count >= 2; count /= 2) {
      const auto begin = arcs.begin() + static_cast<std::ptrdiff_t>(i);
      const std::vector<Arc> old(begin, begin + static_cast<std::ptrdiff_t>(count));
      const auto all = turns(pose, end_of(pose, old), options.radius_m, space.hull.gears);
      if (all.empty() || all.front().cost_m >= cost_m(old)) continue;
      if (has_odd_run(all.front().arcs, false)) continue;
      if (!fits_along(space, pose, all.front().arcs, options.clearance_m)) continue;
      piece = all.front().arcs;
      taken = count;
      break;
    }
    result.insert(result.end(), piece.begin(), piece.end());
    pose = end_of(pose, piece);
    i += taken;
  }
  return result;
}

// Neighbouring arcs of the same bend and gear become one.
std::vector<Arc> merged(const std::vector<Arc>& arcs) {
  std::vector<Arc> result;
  for (const Arc& arc : arcs) {
    if (!result.empty() && result.back().gear == arc.gear &&
        result.back().curvature_per_m == arc.curvature_per_m) {
      result.back().length_m += arc.length_m;
    } else {
      result.push_back(arc);
    }
  }
  return result;
}

}  // namespace

std::optional<std::vector<Arc>> find_route(const FreeSpace& space, const Pose& from, const Pose& to,
                                           const RouteOptions& options, int* expanded) {
  const std::vector<Gate> gates = gates_of(space, to, options.clearance_m);
  Search search{space,
                to,
                options,
                gates,
                guide_to(space, from, to, gates),
                options.radius_m * kStepAngle_rad,
                {},
                {},
                {}};
  begin_at(search, from);
  std::vector<Arc> best;
  double best_m = std::numeric_limits<double>::max();
  int count = 0;
  while (!search.open.empty() && count < options.max_nodes) {
    const Reached reached = search.open.top();
    search.open.pop();
    if (reached.cost >= best_m) break;
    Node& node = search.nodes[static_cast<std::size_t>(reached.index)];
    if (node.closed || search.at_cell[key_of(search, node)] != reached.index) continue;
    node.closed = true;
    if (++count % kAskEvery == 0) stop_if(options.cancelled);
    const bool near = reached.cost - node.cost_m < kGreed * kNearGoal * options.radius_m;
    if (near || count % kTryEvery == 1) {
      const auto closing = closing_curve(search, node.pose, best_m - node.cost_m);
      if (closing) {
        best_m = node.cost_m + closing->cost_m;
        best = arcs_to(search, reached.index);
        best.insert(best.end(), closing->arcs.begin(), closing->arcs.end());
      }
    }
    expand(search, reached.index);
  }
  if (expanded != nullptr) *expanded = count;
  if (best.empty()) return std::nullopt;
  return shortened_route(space, from, std::move(best), options);
}

std::vector<Arc> shortened_route(const FreeSpace& space, const Pose& from, std::vector<Arc> arcs,
                                 const RouteOptions& options) {
  for (std::size_t before = arcs.size() + 1; arcs.size() < before;) {
    before = arcs.size();
    std::vector<Arc> shorter = merged(shortened(space, from, arcs, options));
    if (has_odd_run(shorter, false) && !has_odd_run(arcs, false)) break;
    arcs = std::move(shorter);
  }
  return arcs;
}

}  // namespace headland

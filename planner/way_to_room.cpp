#include "planner/way_to_room.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>

#include "planner/connection.h"
#include "planner/turns.h"

namespace headland {
namespace {

constexpr double kStep = 0.3;          // of a search step, in turning radii
constexpr double kRoom = 0.4;          // that must be free each way, in turning radii
constexpr double kCell_m = 0.1;        // poses nearer than this ...
constexpr double kHeading_rad = 0.04;  // ... and this are one

struct Node {
  Pose pose;
  Arc arrival;
  int parent = -1;
  double cost_m = 0.0;
};

bool has_room(const FreeSpace& space, const Pose& pose, double radius_m, double clearance_m) {
  for (const double curvature : {1.0 / radius_m, -1.0 / radius_m}) {
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      if (gear == Gear::kReverse && space.hull.gears == Gears::kForwardOnly) continue;
      if (!fits_along(space, pose, {{kRoom * radius_m, curvature, gear}}, clearance_m)) {
        return false;
      }
    }
  }
  return true;
}

std::uint64_t key_of(const Pose& pose, const Pose& origin) {
  const Eigen::Vector2d cell = (pose.p_W - origin.p_W) / kCell_m;
  const auto whole = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::lround(value)) + 0x80000);
  };
  return (whole(cell.x()) << 40U) | (whole(cell.y()) << 20U) |
         whole(wrap_angle(pose.heading_rad) / kHeading_rad);
}

}  // namespace

std::optional<std::vector<Arc>> way_to_room(const FreeSpace& space, const Pose& from,
                                            double radius_m, double clearance_m) {
  std::vector<Node> nodes{{from, {}, -1, 0.0}};
  using Best = std::pair<double, int>;
  std::priority_queue<Best, std::vector<Best>, std::greater<>> open;
  open.emplace(0.0, 0);
  std::unordered_set<std::uint64_t> closed;
  for (int looked_at = 0; !open.empty() && looked_at < kMostRoomNodes;) {
    const int index = open.top().second;
    open.pop();
    const Node node = nodes[static_cast<std::size_t>(index)];
    if (!closed.insert(key_of(node.pose, from)).second) continue;
    ++looked_at;
    if (has_room(space, node.pose, radius_m, clearance_m)) {
      std::vector<Arc> arcs;
      for (int i = index; nodes[static_cast<std::size_t>(i)].parent >= 0;) {
        const Node& step = nodes[static_cast<std::size_t>(i)];
        const bool goes_on = !arcs.empty() && arcs.back().gear == step.arrival.gear &&
                             arcs.back().curvature_per_m == step.arrival.curvature_per_m;
        if (goes_on) {
          arcs.back().length_m += step.arrival.length_m;
        } else {
          arcs.push_back(step.arrival);
        }
        i = step.parent;
      }
      std::ranges::reverse(arcs);
      return arcs;
    }
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      if (gear == Gear::kReverse && space.hull.gears == Gears::kForwardOnly) continue;
      for (const double bend : {0.0, 1.0 / kGentleRadius, -1.0 / kGentleRadius, 1.0, -1.0}) {
        const Arc step{kStep * radius_m, bend / radius_m, gear};
        if (!fits_along(space, node.pose, {step}, clearance_m)) continue;
        Node next{pose_along(node.pose, step, step.length_m), step, index, node.cost_m};
        next.cost_m += cost_m(std::vector<Arc>{step});
        if (node.parent >= 0 && node.arrival.gear != gear) next.cost_m += kCuspCost_m;
        if (closed.contains(key_of(next.pose, from))) continue;
        nodes.push_back(next);
        open.emplace(next.cost_m, static_cast<int>(nodes.size()) - 1);
      }
    }
  }
  return std::nullopt;
}

}  // namespace headland

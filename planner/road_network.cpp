#include "planner/road_network.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "planner/segment.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// A straight piece of a road and the nodes on it.
struct Stretch {
  Vector2d a_W;
  Vector2d b_W;
  std::vector<std::pair<double, int>> nodes;  // fraction of the way from a to b, node
};

// One node for all points that are as good as the same.
int node_at(RoadNetwork& network, const Vector2d& p_W) {
  for (std::size_t i = 0; i < network.nodes_W.size(); ++i) {
    if ((network.nodes_W[i] - p_W).norm() <= kRoadJoint_m) return static_cast<int>(i);
  }
  network.nodes_W.push_back(p_W);
  network.edges.emplace_back();
  return static_cast<int>(network.nodes_W.size()) - 1;
}

double fraction_along(const Stretch& stretch, const Vector2d& p_W) {
  const Vector2d along = stretch.b_W - stretch.a_W;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? std::clamp((p_W - stretch.a_W).dot(along) / squared, 0.0, 1.0) : 0.0;
}

Vector2d point_at(const Stretch& stretch, double t) {
  return stretch.a_W + t * (stretch.b_W - stretch.a_W);
}

// Where they cross, as a fraction of `one`.
std::optional<double> crossing(const Stretch& one, const Stretch& other) {
  const Vector2d a = one.b_W - one.a_W;
  const Vector2d b = other.b_W - other.a_W;
  const double across = cross(a, b);
  if (across == 0.0) return std::nullopt;
  const double t = cross(other.a_W - one.a_W, b) / across;
  const double u = cross(other.a_W - one.a_W, a) / across;
  if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) return std::nullopt;
  return t;
}

void join(RoadNetwork& network, Stretch& one, Stretch& other) {
  const Vector2d reach = Vector2d::Constant(kRoadJoint_m);
  const Vector2d low = one.a_W.cwiseMin(one.b_W) - reach;
  const Vector2d high = one.a_W.cwiseMax(one.b_W) + reach;
  if ((other.a_W.cwiseMax(other.b_W).array() < low.array()).any() ||
      (other.a_W.cwiseMin(other.b_W).array() > high.array()).any()) {
    return;
  }
  if (const auto t = crossing(one, other)) {
    const Vector2d p_W = point_at(one, *t);
    const int node = node_at(network, p_W);
    one.nodes.emplace_back(*t, node);
    other.nodes.emplace_back(fraction_along(other, p_W), node);
    return;
  }
  const auto touch = [&](Stretch& passed, const Vector2d& end_W) {
    const double t = fraction_along(passed, end_W);
    if ((point_at(passed, t) - end_W).norm() > kRoadJoint_m) return;
    const int node = node_at(network, end_W);
    passed.nodes.emplace_back(t, node);
    // The road that is passed stays straight.
    if (t > 0.0 && t < 1.0) network.nodes_W[static_cast<std::size_t>(node)] = point_at(passed, t);
  };
  for (const Vector2d& end_W : {other.a_W, other.b_W}) touch(one, end_W);
  for (const Vector2d& end_W : {one.a_W, one.b_W}) touch(other, end_W);
}

void add_edge(RoadNetwork& network, int a, int b) {
  if (a == b) return;
  const auto from = static_cast<std::size_t>(a);
  const auto to = static_cast<std::size_t>(b);
  const double length_m = (network.nodes_W[to] - network.nodes_W[from]).norm();
  network.edges[from].push_back({b, length_m});
  network.edges[to].push_back({a, length_m});
}

std::vector<Stretch> stretches_of(const std::vector<Polyline>& roads, RoadNetwork& network) {
  std::vector<Stretch> stretches;
  for (const Polyline& road : roads) {
    for (std::size_t i = 1; i < road.size(); ++i) {
      stretches.push_back(
          {road[i - 1],
           road[i],
           {{0.0, node_at(network, road[i - 1])}, {1.0, node_at(network, road[i])}}});
    }
  }
  return stretches;
}

// The place as a node of its own on a line to the nearest road.
int joined_place(RoadNetwork& network, std::vector<Stretch>& stretches, const Vector2d& p_W,
                 double reach_m) {
  Stretch* nearest = nullptr;
  double nearest_m = reach_m;
  for (Stretch& stretch : stretches) {
    const double distance_m = distance_to_segment(p_W, stretch.a_W, stretch.b_W);
    if (distance_m > nearest_m || (nearest != nullptr && distance_m == nearest_m)) continue;
    nearest = &stretch;
    nearest_m = distance_m;
  }
  if (nearest == nullptr) return -1;
  const double t = fraction_along(*nearest, p_W);
  const int on_road = node_at(network, point_at(*nearest, t));
  nearest->nodes.emplace_back(t, on_road);
  network.nodes_W.push_back(p_W);
  network.edges.emplace_back();
  const int node = static_cast<int>(network.nodes_W.size()) - 1;
  add_edge(network, node, on_road);
  return node;
}

}  // namespace

RoadNetwork road_network(const std::vector<Polyline>& roads, const std::vector<Vector2d>& places_W,
                         double reach_m) {
  RoadNetwork network;
  std::vector<Stretch> stretches = stretches_of(roads, network);
  if (stretches.empty()) {
    network.nodes_W = places_W;
    network.edges.resize(places_W.size());
    for (std::size_t i = 0; i < places_W.size(); ++i) {
      network.node_of_place.push_back(static_cast<int>(i));
      for (std::size_t j = 0; j < i; ++j) {
        add_edge(network, static_cast<int>(i), static_cast<int>(j));
      }
    }
    return network;
  }
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) join(network, stretches[i], stretches[j]);
  }
  for (const Vector2d& p_W : places_W) {
    network.node_of_place.push_back(joined_place(network, stretches, p_W, reach_m));
  }
  for (Stretch& stretch : stretches) {
    std::ranges::stable_sort(stretch.nodes, {}, &std::pair<double, int>::first);
    for (std::size_t i = 1; i < stretch.nodes.size(); ++i) {
      add_edge(network, stretch.nodes[i - 1].second, stretch.nodes[i].second);
    }
  }
  return network;
}

std::optional<Polyline> shortest_way(const RoadNetwork& network, std::size_t from, std::size_t to) {
  const int begin = network.node_of_place[from];
  const int goal = network.node_of_place[to];
  if (begin < 0 || goal < 0) return std::nullopt;
  std::vector<double> length_m(network.nodes_W.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(network.nodes_W.size(), -1);
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  length_m[static_cast<std::size_t>(begin)] = 0.0;
  open.emplace(0.0, begin);
  while (!open.empty()) {
    const auto [so_far_m, node] = open.top();
    open.pop();
    if (node == goal) break;
    if (so_far_m > length_m[static_cast<std::size_t>(node)]) continue;
    for (const RoadNetwork::Edge& edge : network.edges[static_cast<std::size_t>(node)]) {
      double& known_m = length_m[static_cast<std::size_t>(edge.to)];
      if (so_far_m + edge.length_m >= known_m) continue;
      known_m = so_far_m + edge.length_m;
      before[static_cast<std::size_t>(edge.to)] = node;
      open.emplace(known_m, edge.to);
    }
  }
  if (begin != goal && before[static_cast<std::size_t>(goal)] < 0) return std::nullopt;
  Polyline way;
  for (int node = goal; node >= 0; node = before[static_cast<std::size_t>(node)]) {
    const Vector2d& p_W = network.nodes_W[static_cast<std::size_t>(node)];
    // A place on a road is a node of its own beside the road's.
    if (way.empty() || way.back() != p_W) way.push_back(p_W);
  }
  std::ranges::reverse(way);
  return way;
}

}  // namespace headland

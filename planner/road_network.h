// Roads between fields and the shortest way along them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "planner/polygon.h"

namespace headland {

struct RoadNetwork {
  struct Edge {
    int to = 0;
    double length_m = 0.0;
  };
  std::vector<Eigen::Vector2d> nodes_W;
  std::vector<std::vector<Edge>> edges;  // by node, both ways
  std::vector<int> node_of_place;        // -1: no road comes near enough
};

// Roads meet where they cross and where one ends within kRoadJoint_m of another. A place (a gate, a
// yard) is joined by a straight line to the nearest road within `reach_m` of it. Without any road
// straight lines join all places.
RoadNetwork road_network(const std::vector<Polyline>& roads,
                         const std::vector<Eigen::Vector2d>& places_W, double reach_m);

// From place to place, the first and last point theirs; none where no road leads there. A place
// reaches itself by its one point; no point is repeated.
std::optional<Polyline> shortest_way(const RoadNetwork& network, std::size_t from, std::size_t to);

inline constexpr double kRoadJoint_m = 1.0;

}  // namespace headland

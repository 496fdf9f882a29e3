#include "planner/road_network.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "tests/terrains/random_ring.h"

namespace headland {
namespace {

constexpr double kReach_m = 30.0;

// Two crossing roads and a lane that ends beside one of them.
const std::vector<Polyline> kRoads = {
    {{0, 0}, {100, 0}, {200, 0}}, {{50, -80}, {50, 80}}, {{150, 0.6}, {150, 60}}};

double way_m(const RoadNetwork& network, std::size_t from, std::size_t to) {
  const auto way = shortest_way(network, from, to);
  return way ? length_m(*way) : std::numeric_limits<double>::infinity();
}

TEST(RoadNetwork, RoadsMeetWhereTheyCrossAndWhereTheyEnd) {
  const RoadNetwork network =
      road_network(kRoads, {{50, 85}, {150, 60}, {200, 10}, {-20, 20}}, kReach_m);
  // Up the crossing road and along: 5 + 80 + 150, then 10 to the side.
  EXPECT_NEAR(way_m(network, 0, 2), 85.0 + 150.0 + 10.0, 1e-9);
  // The lane begins 0.6 m beside the road.
  EXPECT_NEAR(way_m(network, 0, 1), 85.0 + 100.0 + 60.0, 1e-9);
  // The end of a road is nearest.
  EXPECT_NEAR(way_m(network, 3, 2), std::hypot(20.0, 20.0) + 200.0 + 10.0, 1e-9);
  const auto way = shortest_way(network, 0, 2);
  EXPECT_EQ(way->front(), Eigen::Vector2d(50, 85));
  EXPECT_EQ(way->back(), Eigen::Vector2d(200, 10));
  EXPECT_EQ(shortest_way(network, 1, 1)->size(), 1U);
}

TEST(RoadNetwork, WhatIsOutOfReachIsNotJoined) {
  const RoadNetwork network = road_network(kRoads, {{0, 0}, {0, 31}, {300, 300}}, kReach_m);
  EXPECT_EQ(network.node_of_place[1], -1);
  EXPECT_FALSE(shortest_way(network, 0, 1));
  EXPECT_FALSE(shortest_way(network, 2, 1));
  // Roads that do not meet.
  const RoadNetwork apart =
      road_network({{{0, 0}, {10, 0}}, {{0, 50}, {10, 50}}}, {{0, 0}, {0, 50}}, kReach_m);
  EXPECT_FALSE(shortest_way(apart, 0, 1));
}

TEST(RoadNetwork, StraightLinesWhereThereAreNoRoads) {
  const RoadNetwork network = road_network({}, {{0, 0}, {30, 40}, {1000, 0}}, kReach_m);
  EXPECT_NEAR(way_m(network, 0, 1), 50.0, 1e-12);
  EXPECT_EQ(shortest_way(network, 0, 1)->size(), 2U);
}

// A way is never shorter than the straight line, the same length both ways, and no detour over a
// third place is shorter.
TEST(RoadNetwork, WaysAreShortest) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Polyline> roads;
    const int count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) {
      Polyline road;
      const int points = *rc::gen::inRange(2, 6);
      for (int k = 0; k < points; ++k) {
        road.emplace_back(any_number(0.0, 300.0), any_number(0.0, 300.0));
      }
      roads.push_back(road);
    }
    std::vector<Eigen::Vector2d> places;
    for (const Polyline& road : roads) places.push_back(0.5 * (road[0] + road[1]));
    const RoadNetwork network = road_network(roads, places, kReach_m);
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (std::size_t b = 0; b < places.size(); ++b) {
        const double direct_m = way_m(network, a, b);
        RC_ASSERT(direct_m >= (places[a] - places[b]).norm() - 1e-9);
        RC_ASSERT(direct_m == way_m(network, b, a) ||
                  std::abs(direct_m - way_m(network, b, a)) < 1e-9);
        for (std::size_t c = 0; c < places.size(); ++c) {
          RC_ASSERT(direct_m <= way_m(network, a, c) + way_m(network, c, b) + 1e-9);
        }
      }
    }
  }));
}

}  // namespace
}  // namespace headland

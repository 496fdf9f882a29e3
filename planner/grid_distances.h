// Shortest ways between free cells of a grid map, around what is blocked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "planner/cancel.h"
#include "planner/grid_graph.h"

namespace headland {

// Steps from every node to every other. The matrix D of Wang et al. 2025
// (10.20944/preprints202504.0101.v1), Eq (6), computed by breadth-first searches, which give the
// same as their Floyd algorithm (Eq 3) in a fraction of the time.
struct DistanceTable {
  int nodes = 0;
  std::vector<std::uint16_t> steps;  // row by row; empty: of near nodes only
  std::vector<std::uint8_t> near;    // by node and column and row away; see local_distances
  const GridGraph* graph = nullptr;  // of `near`; not owned

  int operator()(int from, int to) const {
    if (steps.empty()) return near_or_free(from, to);
    return steps[static_cast<std::size_t>(from) * static_cast<std::size_t>(nodes) +
                 static_cast<std::size_t>(to)];
  }

  int near_or_free(int from, int to) const;
};

// The table takes 2 bytes for each pair: 0.8 GB for as many nodes.
inline constexpr int kMaxTableNodes = 20000;

// For maps of any size, 81 bytes a node: nodes at most so many steps apart have their distance, all
// others the one that they would have if nothing were blocked, which may be too little.
inline constexpr int kNearTableSteps = 4;
DistanceTable local_distances(const GridGraph& graph, const CancelAsked& cancelled = {});

// Throws InputError above kMaxTableNodes, which names planners that need no table; Cancelled.
DistanceTable distance_table(const GridGraph& graph, const std::string& source,
                             const CancelAsked& cancelled = {});

// Appends the nodes after `from` up to `to` on a shortest way. It is the same way back, depends on
// nothing but the two, and goes on straight while that is shortest, else to the first direction
// that is. Nodes whose distance the table does not have are joined by a search of the graph.
void append_way(const GridGraph& graph, const DistanceTable& table, int from, int to,
                std::vector<int>& path);

// By node, the others that are at most so many steps away, nearest first.
std::vector<std::vector<int>> nodes_within(const GridGraph& graph, int steps);

// Searches without a table, for maps of any size; what it keeps is reused by the next search.
struct BreadthFirst {
  explicit BreadthFirst(const GridGraph& searched)
      : graph(&searched), reached_in(searched.cells.size(), 0), from(searched.cells.size(), -1) {}

  const GridGraph* graph;  // not owned
  std::vector<int> reached_in;
  std::vector<int> from;
  std::vector<int> queue;
  int search = 0;
};

// Directions in the order in which ways of equal length are preferred.
using DirectionOrder = std::array<int, kDirections>;

// The nodes after `start` up to the nearest one that is wanted, on a shortest way; empty when
// `start` is, or none is.
template <typename Wanted>  // bool(int node)
std::vector<int> way_to(BreadthFirst& first, int start, const DirectionOrder& order,
                        Wanted wanted) {
  ++first.search;
  first.queue.assign(1, start);
  at(first.reached_in, start) = first.search;
  at(first.from, start) = -1;
  for (std::size_t i = 0; i < first.queue.size(); ++i) {
    const int node = first.queue[i];
    if (wanted(node)) {
      std::vector<int> way;
      for (int back = node; back != start; back = at(first.from, back)) way.push_back(back);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const int direction : order) {
      const int next = at(at(first.graph->beside, node), direction);
      if (next < 0 || at(first.reached_in, next) == first.search) continue;
      at(first.reached_in, next) = first.search;
      at(first.from, next) = node;
      first.queue.push_back(next);
    }
  }
  return {};
}

}  // namespace headland

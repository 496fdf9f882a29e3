#include "planner/grid_distances.h"

#include <fmt/format.h>

#include <limits>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::uint16_t kUnreached = std::numeric_limits<std::uint16_t>::max();

constexpr std::size_t kNearSide = 2 * kNearTableSteps + 1;
constexpr std::uint8_t kNotNear = 255;
constexpr int kNodesPerCheck = 1024;  // between questions whether to go on

// Of two nodes at most kNearTableSteps columns and rows apart.
std::size_t near_entry(const GridGraph& graph, int from, int to) {
  const GridCell one = at(graph.cells, from);
  const GridCell other = at(graph.cells, to);
  const auto column = static_cast<std::size_t>(other.column - one.column + kNearTableSteps);
  const auto row = static_cast<std::size_t>(other.row - one.row + kNearTableSteps);
  return (static_cast<std::size_t>(from) * kNearSide + row) * kNearSide + column;
}

void fill_row(const GridGraph& graph, int start, std::vector<int>& queue, std::uint16_t* row) {
  int reached = 0;
  at(queue, reached++) = start;
  row[start] = 0;
  for (int i = 0; i < reached; ++i) {
    const int node = at(queue, i);
    const auto steps = static_cast<std::uint16_t>(row[node] + 1);
    for (const int next : at(graph.beside, node)) {
      if (next < 0 || row[next] != kUnreached) continue;
      row[next] = steps;
      at(queue, reached++) = next;
    }
  }
}

// Appends the way from the node with the lower number to the other.
void append_upward(const GridGraph& graph, const DistanceTable& table, int low, int high,
                   std::vector<int>& path) {
  int direction = 0;
  for (int node = low; node != high;) {
    const int left = table(high, node);
    const auto nearer = [&](int k) {
      const int next = at(at(graph.beside, node), k);
      return next >= 0 && table(high, next) < left;
    };
    if (node == low || !nearer(direction)) {
      for (direction = 0; !nearer(direction);) ++direction;
    }
    node = at(at(graph.beside, node), direction);
    path.push_back(node);
  }
}

}  // namespace

DistanceTable distance_table(const GridGraph& graph, const std::string& source,
                             const CancelAsked& cancelled) {
  if (graph.size() > kMaxTableNodes) {
    throw InputError(source, "map", fmt::format("{} free cells", graph.size()),
                     fmt::format("at most {} for this planner, which needs the distances between "
                                 "all of them; grid_boustrophedon and grid_local_search take "
                                 "more",
                                 kMaxTableNodes));
  }
  DistanceTable table;
  table.nodes = graph.size();
  const std::size_t nodes = graph.cells.size();
  table.steps.reserve(nodes * nodes);
  std::vector<int> queue(nodes);
  for (int node = 0; node < table.nodes; ++node) {
    stop_if(cancelled);
    // Row by row: to make all of a large table takes seconds in which nobody is asked.
    table.steps.resize(table.steps.size() + nodes, kUnreached);
    fill_row(graph, node, queue, table.steps.data() + static_cast<std::size_t>(node) * nodes);
  }
  return table;
}

int DistanceTable::near_or_free(int from, int to) const {
  const int free = steps_without_obstacles(*graph, from, to);
  if (free > kNearTableSteps) return free;
  const int known = near[near_entry(*graph, from, to)];
  return known == kNotNear ? std::max(free, kNearTableSteps + 1) : known;
}

DistanceTable local_distances(const GridGraph& graph, const CancelAsked& cancelled) {
  DistanceTable table;
  table.nodes = graph.size();
  table.graph = &graph;
  table.near.assign(graph.cells.size() * kNearSide * kNearSide, kNotNear);
  std::vector<int> reached;
  for (int node = 0; node < graph.size(); ++node) {
    if (node % kNodesPerCheck == 0) stop_if(cancelled);
    reached.assign(1, node);
    table.near[near_entry(graph, node, node)] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const int steps = table.near[near_entry(graph, node, reached[i])];
      for (const int next : at(graph.beside, reached[i])) {
        if (next < 0 || steps == kNearTableSteps) continue;
        std::uint8_t& known = table.near[near_entry(graph, node, next)];
        if (known != kNotNear) continue;
        known = static_cast<std::uint8_t>(steps + 1);
        reached.push_back(next);
      }
    }
  }
  return table;
}

std::vector<std::vector<int>> nodes_within(const GridGraph& graph, int steps) {
  std::vector<std::vector<int>> near(graph.cells.size());
  for (int node = 0; node < graph.size(); ++node) {
    std::vector<int> reached = {node};
    std::size_t ring_begin = 0;
    for (int step = 0; step < steps; ++step) {
      const std::size_t ring_end = reached.size();
      for (; ring_begin < ring_end; ++ring_begin) {
        for (const int next : at(graph.beside, reached[ring_begin])) {
          if (next >= 0 && std::ranges::find(reached, next) == reached.end()) {
            reached.push_back(next);
          }
        }
      }
    }
    at(near, node).assign(reached.begin() + 1, reached.end());
  }
  return near;
}

void append_way(const GridGraph& graph, const DistanceTable& table, int from, int to,
                std::vector<int>& path) {
  if (table.steps.empty() && table(from, to) > kNearTableSteps) {
    BreadthFirst first(graph);
    const std::vector<int> way =
        way_to(first, from, {0, 1, 2, 3}, [to](int node) { return node == to; });
    path.insert(path.end(), way.begin(), way.end());
    return;
  }
  if (from < to) return append_upward(graph, table, from, to, path);
  if (from == to) return;
  const std::size_t begin = path.size();
  append_upward(graph, table, to, from, path);
  // What was appended ends at `from`; turned round it lacks its own beginning.
  path.pop_back();
  std::reverse(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end());
  path.push_back(to);
}

}  // namespace headland

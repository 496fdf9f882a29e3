#include "planner/grid_bound.h"

#include <algorithm>
#include <vector>

namespace headland {
namespace {

constexpr int kUnmatched = -1;
constexpr int kNoLayer = -1;
// Copy c of node n is 2 n + c: each time that the node is entered or left.
constexpr int kCopies = 2;
constexpr int kEdges = kDirections * kCopies;

struct Matching {
  const GridGraph& graph;
  std::vector<char> exists;  // by copy
  std::vector<int> partner;  // by copy
  std::vector<int> layer;    // of copies of light nodes, from one without partner
  std::vector<int> next_edge;
};

bool is_light(const GridGraph& graph, int node) {
  const GridCell cell = at(graph.cells, node);
  return (cell.column + cell.row) % 2 == 0;
}

// The copy at the other end of an edge of `copy`; -1: none.
int across(const Matching& matching, int copy, int edge) {
  const int node = at(at(matching.graph.beside, copy / kCopies), edge / kCopies);
  if (node < 0) return -1;
  const int other = node * kCopies + edge % kCopies;
  return at(matching.exists, other) != 0 ? other : -1;
}

void match(Matching& matching, int light, int dark) {
  at(matching.partner, light) = dark;
  at(matching.partner, dark) = light;
}

// Layers of alternating paths from light copies without a partner; whether one ends in a dark one
// without.
bool lay_out(Matching& matching, const std::vector<int>& light) {
  std::vector<int> queue;
  for (const int copy : light) {
    const bool free = at(matching.partner, copy) == kUnmatched;
    at(matching.layer, copy) = free ? 0 : kNoLayer;
    at(matching.next_edge, copy) = 0;
    if (free) queue.push_back(copy);
  }
  bool ends = false;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (int edge = 0; edge < kEdges; ++edge) {
      const int dark = across(matching, queue[i], edge);
      if (dark < 0) continue;
      const int next = at(matching.partner, dark);
      if (next == kUnmatched) {
        ends = true;
      } else if (at(matching.layer, next) == kNoLayer) {
        at(matching.layer, next) = at(matching.layer, queue[i]) + 1;
        queue.push_back(next);
      }
    }
  }
  return ends;
}

// Matches along a shortest alternating path that begins in `start`, if there is one.
bool augment(Matching& matching, int start) {
  std::vector<int> path = {start};  // light copies
  std::vector<int> through;         // dark ones between them
  while (!path.empty()) {
    const int light = path.back();
    int& edge = at(matching.next_edge, light);
    if (edge == kEdges) {
      path.pop_back();
      if (!through.empty()) through.pop_back();
      continue;
    }
    const int dark = across(matching, light, edge++);
    if (dark < 0) continue;
    const int next = at(matching.partner, dark);
    if (next == kUnmatched) {
      through.push_back(dark);
      for (std::size_t i = 0; i < path.size(); ++i) match(matching, path[i], through[i]);
      return true;
    }
    if (at(matching.layer, next) != at(matching.layer, light) + 1) continue;
    through.push_back(dark);
    path.push_back(next);
  }
  return false;
}

// Of pairs in a largest matching of the copies that exist.
int matched_pairs(Matching& matching, const CancelAsked& cancelled) {
  std::vector<int> light;
  int pairs = 0;
  for (int copy = 0; copy < static_cast<int>(matching.exists.size()); ++copy) {
    if (at(matching.exists, copy) != 0 && is_light(matching.graph, copy / kCopies)) {
      light.push_back(copy);
    }
  }
  while (lay_out(matching, light)) {
    stop_if(cancelled);
    for (const int copy : light) {
      if (at(matching.layer, copy) == 0 && augment(matching, copy)) ++pairs;
    }
  }
  return pairs;
}

}  // namespace

int least_steps(const GridProblem& problem, const CancelAsked& cancelled) {
  const GridGraph& graph = problem.graph;
  if (graph.size() == 1) return 0;
  const std::size_t copies = graph.cells.size() * kCopies;
  Matching matching{graph, std::vector<char>(copies, 1), std::vector<int>(copies, kUnmatched),
                    std::vector<int>(copies, kNoLayer), std::vector<int>(copies, 0)};
  int free_ends = problem.closed ? 0 : 2;
  int existing = static_cast<int>(copies);
  if (!problem.closed) {
    for (const int end : {problem.start, problem.end}) {
      if (end < 0) continue;
      at(matching.exists, end * kCopies) = 0;
      --existing;
      --free_ends;
    }
  }
  // Each free end takes one from the weight of a cell that may be in the set.
  const int by_cover = existing - matched_pairs(matching, cancelled) - free_ends;
  const int least = std::max(by_cover, graph.size() - (problem.closed ? 0 : 1));
  if (free_ends > 0) return least;
  const bool odd = is_light(graph, problem.start) != is_light(graph, problem.end);
  return least + ((least % 2 != 0) == odd ? 0 : 1);
}

}  // namespace headland

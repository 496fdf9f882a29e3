#include "planner/algorithms/grid_boustrophedon.h"

#include <algorithm>

namespace headland {
namespace {

// Up, left, right, down.
constexpr DirectionOrder kPreferred = {1, 0, 2, 3};

struct RowByRow {
  const GridMap& map;
  const GridGraph& graph;
  const CancelAsked& cancelled;
  BreadthFirst first;
  std::vector<char> covered;
  std::vector<int> path;
};

void visit(RowByRow& state, int node) {
  state.path.push_back(node);
  at(state.covered, node) = 1;
}

template <typename Wanted>  // bool(int node)
void go_to_nearest(RowByRow& state, Wanted wanted) {
  for (const int node : way_to(state.first, state.path.back(), kPreferred, wanted)) {
    visit(state, node);
  }
}

void go_to(RowByRow& state, int goal) {
  stop_if(state.cancelled);
  if (direction_between(state.graph, state.path.back(), goal) >= 0) return visit(state, goal);
  go_to_nearest(state, [goal](int node) { return node == goal; });
}

bool is_open(const RowByRow& state, GridCell cell) {
  return is_free(state.map, cell) &&
         at(state.covered, state.graph.node_of[index_of(state.map, cell)]) == 0;
}

GridCell cell_of(const RowByRow& state) { return at(state.graph.cells, state.path.back()); }

int node_of(const RowByRow& state, GridCell cell) {
  return state.graph.node_of[index_of(state.map, cell)];
}

void cover_row(RowByRow& state, int row, int heading) {
  for (int column = cell_of(state).column; column >= 0 && column < state.map.columns;
       column += heading) {
    const GridCell cell{column, row};
    if (is_open(state, cell)) go_to(state, node_of(state, cell));
    const GridCell below{column, row - 1};
    if (is_free(state.map, cell) && is_open(state, below)) go_to(state, node_of(state, below));
  }
}

// From the end of `row`, if that is where the path stands.
void step_up(RowByRow& state, int row, int heading) {
  const GridCell at = cell_of(state);
  if (at.row != row) return;
  int column = at.column;
  while (column >= 0 && column < state.map.columns && !is_free(state.map, {column, row + 1})) {
    column -= heading;
  }
  if (column < 0 || column >= state.map.columns) return;
  while (cell_of(state).column != column) {
    const GridCell back{cell_of(state).column - heading, row};
    if (!is_free(state.map, back)) break;
    visit(state, node_of(state, back));
  }
  go_to(state, node_of(state, {column, row + 1}));
}

// Every cell that is not covered, the nearest first.
void cover_rest(RowByRow& state) {
  auto left = std::ranges::count(state.covered, 0);
  while (left > 0) {
    stop_if(state.cancelled);
    go_to_nearest(state, [&](int node) { return at(state.covered, node) == 0; });
    --left;
  }
}

}  // namespace

GridPlan plan_grid_boustrophedon(const GridPlanRequest& request) {
  const GridProblem problem = grid_problem(request);
  RowByRow state{request.map,
                 problem.graph,
                 request.cancelled,
                 BreadthFirst(problem.graph),
                 std::vector<char>(problem.graph.cells.size(), 0),
                 {}};
  visit(state, std::max(problem.start, 0));
  if (state.path.back() != 0) go_to(state, 0);  // node 0 is the leftmost of the lowest row
  int heading = 1;
  for (int row = problem.graph.cells.front().row; row < request.map.rows; ++row) {
    cover_row(state, row, heading);
    if (row + 1 < request.map.rows) step_up(state, row, heading);
    heading = -heading;
  }
  cover_rest(state);
  if (problem.end >= 0 && state.path.back() != problem.end) go_to(state, problem.end);
  PlanSearch search = begun_search(request);
  search.evaluations = 1;
  search.stopped_by = StopReason::kNothingBetter;
  const GridCounts counts = count_path(problem.graph, state.path);
  note_cost(search, cost_of(request.cost, counts, problem.graph.cell_m));
  return finished_plan(request, problem, "grid_boustrophedon", state.path, search);
}

}  // namespace headland

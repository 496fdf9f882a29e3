#include "planner/grid_runs.h"

#include <algorithm>
#include <cstdint>

#include "planner/arcs.h"

namespace headland {
namespace {

constexpr int kAlone = 2;  // direction of a cell without steps

// Cells of the plan from one turn to the next, both included.
struct StraightPiece {
  std::size_t first = 0;  // index into the plan's cells
  std::size_t last = 0;
  int direction = kAlone;

  std::size_t cells() const { return last - first + 1; }
};

// Of the step between two cells; -1 when they are not neighbours.
int step_direction(const GridCell& from, const GridCell& to) {
  const GridCell step{to.column - from.column, to.row - from.row};
  const auto found = std::ranges::find(kStep, step);
  return found == kStep.end() ? -1 : static_cast<int>(found - kStep.begin());
}

std::vector<StraightPiece> straight_pieces(const std::vector<GridCell>& cells) {
  std::vector<StraightPiece> pieces;
  const auto direction_at = [&](std::size_t i) {
    return i + 1 < cells.size() ? step_direction(cells[i], cells[i + 1]) : -1;
  };
  for (std::size_t i = 0; i < cells.size();) {
    const int direction = direction_at(i);
    std::size_t last = i;
    while (direction >= 0 && direction_at(last) == direction) ++last;
    pieces.push_back({i, last, direction >= 0 ? direction : kAlone});
    // The cell of a turn begins the next piece, too.
    i = direction_at(last) >= 0 ? last : last + 1;
  }
  return pieces;
}

void add_span(std::vector<WorkedSpan>& spans, WorkedSpan added) {
  for (auto span = spans.begin(); span != spans.end();) {
    if (span->begin > added.end || span->end < added.begin) {
      ++span;
      continue;
    }
    added = {std::min(span->begin, added.begin), std::max(span->end, added.end)};
    span = spans.erase(span);
  }
  spans.insert(std::ranges::upper_bound(spans, added.begin, {}, &WorkedSpan::begin), added);
}

double unworked_part(const std::vector<WorkedSpan>& spans) {
  double part = 1.0;
  for (const WorkedSpan& span : spans) part -= span.end - span.begin;
  return std::max(0.0, part);
}

std::size_t axis_of(int direction) { return direction % 2 == 0 ? 0 : 1; }

// Whether the direction runs against x or y.
bool runs_back(int direction) { return direction == 0 || direction == 3; }

WorkedSpan turned(const WorkedSpan& span, int direction) {
  return runs_back(direction) ? WorkedSpan{1.0 - span.end, 1.0 - span.begin} : span;
}

}  // namespace

std::vector<GridRun> work_runs(const GridMap& map, const std::vector<GridCell>& cells) {
  const std::vector<StraightPiece> pieces = straight_pieces(cells);
  std::vector<int> worked_by(map.blocked.size(), -1);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (std::size_t i = pieces[p].first; i <= pieces[p].last; ++i) {
      int& by = worked_by[index_of(map, cells[i])];
      if (by < 0 || pieces[static_cast<std::size_t>(by)].cells() < pieces[p].cells()) {
        by = static_cast<int>(p);
      }
    }
  }
  std::vector<GridRun> runs;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    bool goes_on = false;
    for (std::size_t i = pieces[p].first; i <= pieces[p].last; ++i) {
      const bool works = worked_by[index_of(map, cells[i])] == static_cast<int>(p);
      if (works && !goes_on) runs.push_back({cells[i], pieces[p].direction, 0, 0.0, 0.0});
      if (works) ++runs.back().cells;
      goes_on = works;
    }
  }
  for (GridRun& run : runs) run.end_m = run.cells * map.cell_m;
  return runs;
}

Pass pass_of(const GridMap& map, const GridRun& run) {
  const GridCell& step = kStep[static_cast<std::size_t>(run.direction)];
  const Eigen::Vector2d east_W = direction_of(map.direction_rad);
  const Eigen::Vector2d along_W = step.column * east_W + step.row * left_of(map.direction_rad);
  const Eigen::Vector2d edge_W = centre_W(map, run.first) - 0.5 * map.cell_m * along_W;
  return {PassKind::kSwath, {edge_W + run.begin_m * along_W, edge_W + run.end_m * along_W}};
}

void add_worked(const GridMap& map, const GridRun& run, std::vector<WorkedCell>& worked) {
  for (int k = 0; k < run.cells; ++k) {
    const WorkedSpan span{std::clamp(run.begin_m / map.cell_m - k, 0.0, 1.0),
                          std::clamp(run.end_m / map.cell_m - k, 0.0, 1.0)};
    if (span.begin >= span.end) continue;
    add_span(worked[index_of(map, cell_of(run, k))].along[axis_of(run.direction)],
             turned(span, run.direction));
  }
}

double unworked_share(const WorkedCell& cell) {
  return unworked_part(cell.along[0]) * unworked_part(cell.along[1]);
}

WorkedSpan missing_along(const WorkedCell& cell, int direction) {
  if (!(unworked_part(cell.along[1 - axis_of(direction)]) > 0.0)) return {};
  const std::vector<WorkedSpan>& spans = cell.along[axis_of(direction)];
  WorkedSpan missing{0.0, 1.0};
  if (!spans.empty() && spans.front().begin <= 0.0) missing.begin = spans.front().end;
  if (!spans.empty() && spans.back().end >= 1.0) missing.end = spans.back().begin;
  return turned(missing, direction);
}

}  // namespace headland

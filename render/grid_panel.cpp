#include "render/grid_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

// Below these sizes of a cell [px] lines would hide what they are drawn on.
constexpr double kGridLinesFrom_px = 6.0;
constexpr double kPathFrom_px = 3.0;
constexpr double kArrowsFrom_px = 9.0;

// From one cell to the next in pixels' directions (y down); zero where they are no neighbours.
Point2 step_between(const GridCell& from, const GridCell& to) {
  const Point2 step(to.column - from.column, from.row - to.row);
  return step.cwiseAbs().sum() == 1.0 ? step : Point2::Zero();
}

Point2 right_of(const Point2& step) { return {-step.y(), step.x()}; }

std::vector<int> visits_of(const GridMap& map, const std::vector<GridCell>& path) {
  std::vector<int> visits(map.blocked.size(), 0);
  for (const GridCell& cell : path) ++visits[index_of(map, cell)];
  return visits;
}

// Cells of one row that look alike are one box. Blocked ones are left out, or nothing else drawn.
void fill_cells(Sheet& sheet, const GridPanel& panel, const std::vector<int>& visits,
                bool blocked) {
  const GridMap& map = panel.map;
  const auto colour = [&](const GridCell& cell) {
    if (!is_free(map, cell)) return colours::kBlockedCell;
    const int times = visits[index_of(map, cell)];
    return times > 2 ? colours::kCellOften : times == 2 ? colours::kCellTwice : colours::kFreeCell;
  };
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns;) {
      const Rgba own = colour({column, row});
      int end = column + 1;
      while (end < map.columns && colour({end, row}) == own) ++end;
      if ((own == colours::kBlockedCell) == blocked) {
        fill_box(sheet, cell_box(panel, {column, row}, end - column), own);
      }
      column = end;
    }
  }
}

void draw_grid_lines(Sheet& sheet, const GridPanel& panel) {
  const Box all{panel.corner_px.x(), panel.corner_px.y(), panel.map.columns * panel.cell_px,
                panel.map.rows * panel.cell_px};
  if (panel.cell_px >= kGridLinesFrom_px) {
    for (int column = 1; column < panel.map.columns; ++column) {
      fill_box(sheet, {all.x + column * panel.cell_px - 0.5, all.y, 1.0, all.height},
               colours::kCellLine);
    }
    for (int row = 1; row < panel.map.rows; ++row) {
      fill_box(sheet, {all.x, all.y + row * panel.cell_px - 0.5, all.width, 1.0},
               colours::kCellLine);
    }
  }
  frame_box(sheet, {all.x - 2.0, all.y - 2.0, all.width + 4.0, all.height + 4.0}, 2.0,
            colours::kBlockedCell);
}

// Steps between two cells that the path takes more than once, whichever way.
using Step = std::pair<GridCell, GridCell>;
std::map<Step, int> times_taken(const std::vector<GridCell>& path) {
  std::map<Step, int> times;
  for (std::size_t i = 1; i < path.size(); ++i) ++times[std::minmax(path[i - 1], path[i])];
  return times;
}

// The step into path[i]: its direction in pixels (y down; zero at the path's beginning and for
// jumps), and how far to its right it is drawn.
struct DrawnStep {
  Point2 ahead = Point2::Zero();
  Point2 lane_px = Point2::Zero();
};

// Steps that are taken more than once lie beside each other, each on its right.
std::vector<DrawnStep> drawn_steps(const GridPanel& panel, const std::vector<GridCell>& path) {
  constexpr double kLane = 0.17;  // cells
  const std::map<Step, int> times = times_taken(path);
  std::vector<DrawnStep> steps(path.size());
  for (std::size_t i = 1; i < path.size(); ++i) {
    steps[i].ahead = step_between(path[i - 1], path[i]);
    const bool again = times.at(std::minmax(path[i - 1], path[i])) > 1;
    if (again) steps[i].lane_px = kLane * panel.cell_px * right_of(steps[i].ahead);
  }
  return steps;
}

// Where the line goes in the cell between two steps: around a corner in one point, from lane to
// lane straight across.
std::vector<Point2> points_between(const Point2& centre, const DrawnStep& in,
                                   const DrawnStep& out) {
  if (in.ahead.isZero()) return {centre + out.lane_px};
  if (out.ahead.isZero()) return {centre + in.lane_px};
  if (in.ahead.dot(out.ahead) == 0.0) return {centre + in.lane_px + out.lane_px};
  if (in.lane_px == out.lane_px) return {centre + in.lane_px};
  return {centre + in.lane_px, centre + out.lane_px};
}

void draw_arrow(Sheet& sheet, const Point2& from, const Point2& to, double cell_px) {
  const Point2 along = to - from;
  if (along.norm() < 0.2 * cell_px) return;
  const Point2 ahead = along.normalized();
  const Point2 middle = 0.5 * (from + to);
  constexpr double kHalfLength = 0.17;  // cells
  constexpr double kHalfWidth = 0.14;
  const Point2 back = middle - kHalfLength * cell_px * ahead;
  const Point2 side = kHalfWidth * cell_px * right_of(ahead);
  fill_convex(sheet,
              std::array{Point2(middle + kHalfLength * cell_px * ahead), Point2(back + side),
                         Point2(back - side)},
              colours::kGridPath);
}

void draw_path(Sheet& sheet, const GridPanel& panel, const std::vector<GridCell>& path) {
  if (panel.cell_px < kPathFrom_px) return;
  const double width_px = std::max(1.0, 0.075 * panel.cell_px);
  constexpr int kArrowEvery = 3;  // steps straight on
  std::vector<DrawnStep> steps = drawn_steps(panel, path);
  steps.emplace_back();  // out of the last cell
  std::vector<Point2> line;
  Sheet arrows;
  int straight_on = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const DrawnStep& in = steps[i];
    const std::vector<Point2> here =
        points_between(cell_centre_px(panel, path[i]), in, steps[i + 1]);
    if (i > 0 && in.ahead.isZero()) {
      stroke(sheet, line, width_px, colours::kGridPath);
      stroke(sheet, std::array{line.back(), here.front()}, std::max(1.0, 0.4 * width_px),
             colours::kGridJump);
      line.clear();
    } else if (i > 0 && panel.cell_px >= kArrowsFrom_px) {
      straight_on = in.ahead == steps[i - 1].ahead ? straight_on + 1 : 0;
      if (straight_on % kArrowEvery == 0) {
        draw_arrow(arrows, line.back(), here.front(), panel.cell_px);
      }
    }
    line.insert(line.end(), here.begin(), here.end());
  }
  stroke(sheet, line, width_px, colours::kGridPath);
  sheet.vertices.insert(sheet.vertices.end(), arrows.vertices.begin(), arrows.vertices.end());
}

}  // namespace

Box cell_box(const GridPanel& panel, const GridCell& cell, int cells) {
  return {panel.corner_px.x() + cell.column * panel.cell_px,
          panel.corner_px.y() + (panel.map.rows - 1 - cell.row) * panel.cell_px,
          cells * panel.cell_px, panel.cell_px};
}

Eigen::Vector2d cell_centre_px(const GridPanel& panel, const GridCell& cell) {
  const Box around = cell_box(panel, cell);
  return {around.x + 0.5 * panel.cell_px, around.y + 0.5 * panel.cell_px};
}

void draw_grid_panel(Sheet& sheet, const GridPanel& panel, const std::vector<GridCell>& path) {
  const std::vector<int> visits = visits_of(panel.map, path);
  fill_cells(sheet, panel, visits, false);
  if (!path.empty()) {
    fill_box(sheet, cell_box(panel, path.back()), colours::kLastCell);
    fill_box(sheet, cell_box(panel, path.front()), colours::kFirstCell);
  }
  draw_grid_lines(sheet, panel);
  fill_cells(sheet, panel, visits, true);
  if (!path.empty()) draw_path(sheet, panel, path);
}

}  // namespace headland

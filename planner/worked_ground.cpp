#include "planner/worked_ground.h"

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// In the scanline's units, where cell centres are whole numbers.
Vector2d in_cells(const WorkedGround& ground, const Vector2d& p_W) {
  return (p_W - ground.origin_W) / ground.cell_m - Vector2d::Constant(0.5);
}

template <typename Points>
void add_loop(WorkedGround& ground, const Points& loop_W) {
  Vector2d before = in_cells(ground, loop_W.back());
  for (const Vector2d& p_W : loop_W) {
    const Vector2d p = in_cells(ground, p_W);
    add_edge(ground.scratch, before, p);
    before = p;
  }
}

template <typename Visit>  // void(std::size_t index)
void visit_inside(WorkedGround& ground, Visit visit) {
  fill(ground.scratch, [&](int row, int begin, int end) {
    for (int column = begin; column < end; ++column) visit(ground.index(column, row));
  });
}

void take_out(WorkedGround& ground, const Obstacle& obstacle) {
  const Vector2d end_W = obstacle.p_W + obstacle.run_W;
  const Vector2d margin = Vector2d::Constant(obstacle.radius_m);
  const Vector2d low = in_cells(ground, obstacle.p_W.cwiseMin(end_W) - margin);
  const Vector2d high = in_cells(ground, obstacle.p_W.cwiseMax(end_W) + margin);
  for (int row = first_cell(low.y(), ground.rows); row < first_cell(high.y(), ground.rows); ++row) {
    for (int column = first_cell(low.x(), ground.columns);
         column < first_cell(high.x(), ground.columns); ++column) {
      if (obstacle_gap_m(obstacle, ground.centre_W(column, row)) > 0.0) continue;
      ground.cells[ground.index(column, row)] = GroundState::kOutside;
    }
  }
}

}  // namespace

WorkedGround ground_to_work(const Field& field) {
  Vector2d low = field.boundary.front();
  Vector2d high = low;
  for (const Vector2d& p_W : field.boundary) {
    low = low.cwiseMin(p_W);
    high = high.cwiseMax(p_W);
  }
  WorkedGround ground;
  const double box_m2 = (high - low).prod();
  const double few_m =
      std::clamp(std::sqrt(box_m2 / kFewGroundCells), kFineGroundCell_m, kGroundCell_m);
  ground.cell_m = std::max(few_m, std::sqrt(box_m2 / kMostGroundCells));
  ground.origin_W = low - Vector2d::Constant(ground.cell_m);
  ground.columns = static_cast<int>(std::ceil((high.x() - low.x()) / ground.cell_m)) + 2;
  ground.rows = static_cast<int>(std::ceil((high.y() - low.y()) / ground.cell_m)) + 2;
  ground.cells.assign(ground.index(0, ground.rows), GroundState::kOutside);
  ground.scratch = make_scanline(ground.columns, ground.rows);
  add_loop(ground, field.boundary);
  for (const Ring& hole : field.holes) add_loop(ground, hole);
  visit_inside(ground, [&](std::size_t cell) { ground.cells[cell] = GroundState::kToWork; });
  for (const Obstacle& obstacle : field.obstacles) take_out(ground, obstacle);
  return ground;
}

GroundState state_at(const WorkedGround& ground, const Vector2d& p_W) {
  const Vector2d cell = (p_W - ground.origin_W) / ground.cell_m;
  const int column = static_cast<int>(std::floor(cell.x()));
  const int row = static_cast<int>(std::floor(cell.y()));
  if (column < 0 || row < 0 || column >= ground.columns || row >= ground.rows) {
    return GroundState::kOutside;
  }
  return ground.cells[ground.index(column, row)];
}

Quadrangle between_bars(const Vector2d& from_W, const Vector2d& to_W, const Vector2d& half_bar_from,
                        const Vector2d& half_bar_to) {
  return {from_W + half_bar_from, from_W - half_bar_from, to_W - half_bar_to, to_W + half_bar_to};
}

double work(WorkedGround& ground, const Quadrangle& quadrangle, std::vector<std::size_t>* newly) {
  add_loop(ground, quadrangle);
  std::size_t count = 0;
  visit_inside(ground, [&](std::size_t cell) {
    if (ground.cells[cell] != GroundState::kToWork) return;
    ground.cells[cell] = GroundState::kWorked;
    ++count;
    if (newly != nullptr) newly->push_back(cell);
  });
  return static_cast<double>(count) * ground.cell_m * ground.cell_m;
}

double to_work_m2(WorkedGround& ground, const Quadrangle& quadrangle) {
  add_loop(ground, quadrangle);
  std::size_t count = 0;
  visit_inside(ground, [&](std::size_t cell) {
    count += ground.cells[cell] == GroundState::kToWork ? 1 : 0;
  });
  return static_cast<double>(count) * ground.cell_m * ground.cell_m;
}

double to_work_m2(const WorkedGround& ground) {
  const auto count = std::ranges::count(ground.cells, GroundState::kToWork);
  return static_cast<double>(count) * ground.cell_m * ground.cell_m;
}

double work_along(WorkedGround& ground, const std::vector<Vector2d>& line_W, double width_m) {
  double sum_m2 = 0.0;
  const auto half_bar_at = [&](std::size_t i) {
    const Vector2d& before = line_W[i == 0 ? 0 : i - 1];
    const Vector2d& after = line_W[std::min(i + 1, line_W.size() - 1)];
    const Vector2d along = (after - before).normalized();
    return Vector2d(0.5 * width_m * Vector2d(-along.y(), along.x()));
  };
  for (std::size_t i = 1; i < line_W.size(); ++i) {
    sum_m2 +=
        work(ground, between_bars(line_W[i - 1], line_W[i], half_bar_at(i - 1), half_bar_at(i)));
  }
  return sum_m2;
}

void work_swaths(WorkedGround& ground, const SwathGrid& grid, double width_m) {
  for (const Swath& swath : grid.swaths) {
    const Vector2d from_W = point_on_line(grid, swath.line, swath.from_m);
    work_along(ground, {from_W, point_on_line(grid, swath.line, swath.to_m)}, width_m);
  }
}

void unwork(WorkedGround& ground, const std::vector<std::size_t>& cells) {
  for (const std::size_t cell : cells) ground.cells[cell] = GroundState::kToWork;
}

void leave_to_work(WorkedGround& ground, const PolygonSet& set) {
  std::vector<char> kept(ground.cells.size(), 0);
  for (const PolygonPart& part : set.parts) {
    add_loop(ground, part.outer);
    for (const Ring& hole : part.holes) add_loop(ground, hole);
    fill(ground.scratch, [&](int row, int begin, int end) {
      for (int column = begin; column < end; ++column) kept[ground.index(column, row)] = 1;
    });
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == 0 && ground.cells[i] == GroundState::kToWork) {
      ground.cells[i] = GroundState::kWorked;
    }
  }
}

double work_driven(WorkedGround& ground, const std::vector<PathPoint>& points, double bar_x_m,
                   double width_m) {
  const auto middle_W = [&](const PathPoint& point) -> Vector2d {
    return point.p_W + bar_x_m * direction_of(point.heading_rad);
  };
  const auto half_bar = [&](const PathPoint& point) -> Vector2d {
    return 0.5 * width_m * left_of(point.heading_rad);
  };
  double sum_m2 = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum_m2 += work(ground, between_bars(middle_W(points[i - 1]), middle_W(points[i]),
                                        half_bar(points[i - 1]), half_bar(points[i])));
  }
  return sum_m2;
}

}  // namespace headland

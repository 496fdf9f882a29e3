// What of a field is worked so far, cell by cell.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "planner/path.h"
#include "planner/polygon.h"
#include "planner/scanline.h"
#include "planner/swaths.h"
#include "terrains/field.h"

namespace headland {

enum class GroundState : std::uint8_t { kOutside, kToWork, kWorked };

// Cell (i, j) has its centre at origin_W + cell_m * (i + 0.5, j + 0.5) and is all what its centre
// is; around the field lies at least one cell outside it.
struct WorkedGround {
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  double cell_m = 0.25;
  int columns = 0;
  int rows = 0;
  std::vector<GroundState> cells;  // row by row

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  Eigen::Vector2d centre_W(int column, int row) const {
    return origin_W + cell_m * Eigen::Vector2d(column + 0.5, row + 0.5);
  }
  Scanline scratch;  // of the functions below
};

// Nothing worked yet; holes and obstacles are outside. Cells of kGroundCell_m; finer where the
// field's bounding box takes few, as slivers tell on small fields, larger where it would take more
// than kMostGroundCells.
WorkedGround ground_to_work(const Field& field);
inline constexpr double kGroundCell_m = 0.2;
inline constexpr double kFineGroundCell_m = 0.1;
inline constexpr double kFewGroundCells = 1e6;
inline constexpr double kMostGroundCells = 3e7;

GroundState state_at(const WorkedGround& ground, const Eigen::Vector2d& p_W);

// Corners of the ground that a bar covers between two places, in order around it.
using Quadrangle = std::array<Eigen::Vector2d, 4>;
Quadrangle between_bars(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W,
                        const Eigen::Vector2d& half_bar_from, const Eigen::Vector2d& half_bar_to);

// Works the cells in it; the area [m2] that was still to be worked. What sticks out of the raster
// is left out. Cells that were still to be worked are added to `newly`, if given.
double work(WorkedGround& ground, const Quadrangle& quadrangle,
            std::vector<std::size_t>* newly = nullptr);
// That area alone.
double to_work_m2(WorkedGround& ground, const Quadrangle& quadrangle);

// All that is left to work [m2].
double to_work_m2(const WorkedGround& ground);

// What a bar of `width_m` covers when its middle is pulled along `line_W`, square to it.
double work_along(WorkedGround& ground, const std::vector<Eigen::Vector2d>& line_W, double width_m);

// Likewise along all swaths of a grid.
void work_swaths(WorkedGround& ground, const SwathGrid& grid, double width_m);

// These cells are to be worked again.
void unwork(WorkedGround& ground, const std::vector<std::size_t>& cells);

// Takes all ground outside the set for worked.
void leave_to_work(WorkedGround& ground, const PolygonSet& set);

// What a bar covers that is fixed square to a vehicle, its middle `bar_x_m` ahead of B's origin:
// behind an axle that turns it swings out, by 0.26 m at 1.5 m on a radius of 4.4 m.
double work_driven(WorkedGround& ground, const std::vector<PathPoint>& points, double bar_x_m,
                   double width_m);

}  // namespace headland

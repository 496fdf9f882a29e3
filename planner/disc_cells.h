// Where a disc may be in a field, and how far it is from there to elsewhere, over square cells.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/free_space.h"

namespace headland {

// Row by row; a cell is free where a disc fits with its middle in the cell's.
struct DiscCells {
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<char> free;

  // The nearest one for places beyond the cells.
  int at(const Eigen::Vector2d& p_W) const;
  Eigen::Vector2d centre_W(int cell) const;
  bool is_free(int cell) const { return free[static_cast<std::size_t>(cell)] != 0; }
};

// Over the whole field.
DiscCells disc_cells(const FreeSpace& space, double radius_m, double cell_m);

// The free cell nearest to a place; the cell of the place itself where none is free.
int nearest_free(const DiscCells& cells, const Eigen::Vector2d& p_W);

// The number of the component that each cell is in, counted from 0; -1 for cells that are not free.
// Cells are joined with the eight around them.
std::vector<int> disc_components(const DiscCells& cells);

// The same with the free cells that have none in the component that is reached from them in the
// fewest steps, -1 where there is none.
std::vector<int> grown_components(const DiscCells& cells, std::vector<int> component);

// A cell, and how far it is from there to the goal.
struct WayBegin {
  int cell = 0;
  double length_m = 0.0;
};

// From every free cell the shortest way [m] to one of the begins and from there to the goal, from
// cell to cell straight and diagonally (Dijkstra 1959; at most 8 % longer than in the plane).
// kNoDiscWay_m where there is none. Begins need not be free.
std::vector<float> disc_way_lengths(const DiscCells& cells, const std::vector<WayBegin>& begins);
inline constexpr float kNoDiscWay_m = 1e30F;

// Centres of the cells on the shortest way, both ends' included; empty where there is none. Both
// ends' cells count as free.
std::vector<Eigen::Vector2d> disc_way(DiscCells cells, const Eigen::Vector2d& from_W,
                                      const Eigen::Vector2d& to_W);

}  // namespace headland

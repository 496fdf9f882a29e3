#include "planner/swath_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

SwathGrid with_holes(const std::vector<Ring>& holes) {
  Field field = field_of("f", rectangle_ring(0, 0, 200, 100));
  for (const Ring& hole : holes) field.holes.push_back(reversed(hole));
  const PolygonSet inner = from_field(field);
  return lay_swaths({inner, inner}, 0.0, 5.0, 0.0);
}

TEST(SwathCells, OneHoleMakesFourCellsAndTwoMakeSeven) {
  EXPECT_EQ(cells_of(with_holes({})).size(), 1U);
  EXPECT_EQ(cells_of(with_holes({rectangle_ring(90, 40, 110, 60)})).size(), 4U);
  EXPECT_EQ(cells_of(with_holes({rectangle_ring(50, 20, 70, 40), rectangle_ring(130, 60, 150, 80)}))
                .size(),
            7U);
}

TEST(SwathCells, EverySwathIsInOneCell) {
  const SwathGrid grid =
      with_holes({rectangle_ring(50, 20, 70, 65), rectangle_ring(130, 60, 150, 80)});
  std::multiset<std::size_t> seen;
  for (const SwathCell& cell : cells_of(grid)) seen.insert(cell.begin(), cell.end());
  ASSERT_EQ(seen.size(), grid.swaths.size());
  for (std::size_t i = 0; i < grid.swaths.size(); ++i) EXPECT_EQ(seen.count(i), 1U);
}

TEST(SwathCells, CellIsDrivenUpAndDownFromTheCornerAskedFor) {
  const SwathGrid grid = with_holes({});
  const std::vector<SwathCell> cells = cells_of(grid);
  const std::vector<Pass> passes = passes_of(grid, cells[0], {0, true, true});
  ASSERT_EQ(passes.size(), 20U);
  EXPECT_TRUE(passes[0].points_W[0].isApprox(Eigen::Vector2d(200, 97.5)));
  for (std::size_t i = 1; i < passes.size(); ++i) {
    EXPECT_NEAR((passes[i].points_W[0] - passes[i - 1].points_W[1]).norm(), 5.0, 1e-9);
  }
}

// Straight distances to the first cell and from each to the next.
double transit_m(const SwathGrid& grid, const std::vector<SwathCell>& cells,
                 const std::vector<CellVisit>& order, Eigen::Vector2d at_W) {
  double sum_m = 0.0;
  for (const CellVisit& visit : order) {
    const std::vector<Pass> passes = passes_of(grid, cells[visit.cell], visit);
    sum_m += (passes.front().points_W.front() - at_W).norm();
    at_W = passes.back().points_W.back();
  }
  return sum_m;
}

std::vector<SwathCell> single_cells(const SwathGrid& grid) {
  std::vector<SwathCell> cells;
  for (std::size_t i = 0; i < grid.swaths.size(); ++i) cells.push_back({i});
  return cells;
}

SwathGrid scattered(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  SwathGrid grid;
  grid.spacing_m = 10.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double from_m = static_cast<double>(engine() % 1000) / 5.0;
    grid.swaths.push_back({static_cast<int>(engine() % 20), from_m, from_m + 20.0});
  }
  std::ranges::sort(grid.swaths, {}, &Swath::line);
  grid.lines = 20;
  return grid;
}

TEST(SwathCells, OrderOfFewCellsIsTheBestOfAll) {
  const SwathGrid grid = scattered(5, 3);
  const std::vector<SwathCell> cells = single_cells(grid);
  const Eigen::Vector2d start_W(0, 0);
  double best_m = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    for (unsigned ends = 0; ends < 32; ++ends) {
      std::vector<CellVisit> visits;
      for (const std::size_t cell : order)
        visits.push_back({cell, false, (ends >> cell & 1U) != 0});
      best_m = std::min(best_m, transit_m(grid, cells, visits, start_W));
    }
  } while (std::ranges::next_permutation(order).found);
  EXPECT_NEAR(transit_m(grid, cells, order_cells(grid, cells, start_W), start_W), best_m, 1e-9);
}

TEST(SwathCells, OrderOfManyCellsFindsAKnownOptimum) {
  // A row of 40 lines, 10 m apart: from one to the next is the only way without detour.
  SwathGrid grid;
  grid.spacing_m = 10.0;
  grid.lines = 40;
  for (int line = 0; line < 40; ++line) grid.swaths.push_back({line, 0.0, 100.0});
  const std::vector<SwathCell> cells = single_cells(grid);
  const Eigen::Vector2d start_W(0, 0);
  const std::vector<CellVisit> order = order_cells(grid, cells, start_W);
  EXPECT_NEAR(transit_m(grid, cells, order, start_W), 39 * 10.0, 1e-9);
}

TEST(SwathCells, OrderVisitsEveryCellOnceHoweverMany) {
  for (const std::size_t count : {0U, 1U, 8U, 60U}) {
    const SwathGrid grid = scattered(count, count);
    const std::vector<SwathCell> cells = single_cells(grid);
    std::set<std::size_t> visited;
    for (const CellVisit& visit : order_cells(grid, cells, std::nullopt))
      visited.insert(visit.cell);
    EXPECT_EQ(visited.size(), count);
  }
}

}  // namespace
}  // namespace headland

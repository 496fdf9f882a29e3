#include "terrains/grid_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>

#include "refusal.h"
#include "scratch_folder.h"
#include "terrains/grid_map_file.h"
#include "terrains/grid_map_generator.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kGridRounding_m = 1e-12;  // of coordinates of a few metres

GridMap grid_picture(const std::string& text) { return parse_grid_map(text, 2.0, "map.txt"); }

TEST(GridMap, TextHasNorthOnTop) {
  const GridMap map = grid_picture("..#\n...\n");
  EXPECT_EQ(map.columns, 3);
  EXPECT_EQ(map.rows, 2);
  EXPECT_FALSE(is_free(map, {2, 1}));
  EXPECT_TRUE(is_free(map, {2, 0}));
  EXPECT_FALSE(is_free(map, {3, 0})) << "outside the map nothing is free";
  EXPECT_EQ(free_cell_count(map), 5);
  EXPECT_EQ(grid_map_text(map), "..#\n...\n");
}

TEST(GridMap, TextWithMarkAndCarriageReturns) {
  EXPECT_EQ(grid_map_text(grid_picture("\xEF\xBB\xBF.#\r\n..\r\n\r\n")), ".#\n..\n");
}

TEST(GridMap, CentresAreTurnedAboutTheOrigin) {
  GridMap map = grid_picture("...\n...\n");
  map.origin_W = {10.0, 20.0};
  EXPECT_LT((centre_W(map, {2, 1}) - Eigen::Vector2d(15.0, 23.0)).norm(), kGridRounding_m);
  map.direction_rad = std::numbers::pi / 2.0;
  EXPECT_LT((centre_W(map, {2, 1}) - Eigen::Vector2d(7.0, 25.0)).norm(), kGridRounding_m);
}

TEST(GridMap, AreasAreCountedBySteps) {
  const GridAreas one = areas_of(grid_picture("..\n..\n"));
  ASSERT_EQ(one.areas.size(), 1u);
  EXPECT_EQ(one.areas[0].cells, 4);
  // Cells that touch at a corner only are apart.
  const GridMap map = grid_picture(".#.\n#..\n");
  const GridAreas two = areas_of(map);
  ASSERT_EQ(two.areas.size(), 2u);
  EXPECT_EQ(two.areas[0].first, (GridCell{1, 0}));
  EXPECT_EQ(two.areas[0].cells, 3);
  EXPECT_EQ(two.areas[1].cells, 1);
  EXPECT_EQ(two.area_of[index_of(map, {0, 0})], -1);
}

TEST(GridMap, HeightsAreThoseOfTheSurface) {
  GridMap map = grid_picture("...\n...\n");
  Heightfield slope{2, 2, 10.0, {0.0, 0.0}, {0.0, 10.0, 20.0, 30.0}};
  set_heights(map, slope);  // z = x + 2 y
  EXPECT_NEAR(map.height_m[index_of(map, {2, 1})], 5.0 + 6.0, kGridRounding_m);
}

TEST(GridMap, RefusesPicturesThatAreNone) {
  EXPECT_EQ(refusal([] { grid_picture("..\n.x\n"); }),
            "map.txt: line 2, column 2: 'x': '.' for a free cell or '#' for a blocked one");
  EXPECT_EQ(refusal([] { grid_picture("...\n..\n"); }),
            "map.txt: line 2: '2 cells': 3 cells, as on line 1");
  EXPECT_EQ(refusal([] { grid_picture("##\n##\n"); }), "map.txt: map: there is no free cell");
  EXPECT_EQ(refusal([] { grid_picture(""); }), "map.txt: is empty");
  EXPECT_EQ(refusal([] { grid_picture(std::string(1001, '.') + "\n"); }),
            "map.txt: map: '1001 x 1 cells': 1 to 1000 columns and rows");
  EXPECT_EQ(refusal([] { parse_grid_map(".", 0.0, "map.txt"); }),
            "map.txt: cell_m: '0': a number from 0.05 to 1000");
  EXPECT_EQ(refusal([] { parse_grid_map(".", std::nan(""), "map.txt"); }),
            "map.txt: cell_m: 'nan': a number from 0.05 to 1000");
}

TEST(GridMap, RefusesHeightsThatDoNotFit) {
  GridMap map = grid_picture("..\n");
  map.height_m = {1.0};
  EXPECT_EQ(refusal([&] { check_grid_map(map, "map"); }),
            "map: heights: '1': 2 values, one for each of 2 x 1 cells");
  map.height_m = {1.0, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(refusal([&] { check_grid_map(map, "map"); }),
            "map: heights: 'inf': heights from -100000 to 100000");
  map.height_m = {1.0, 2.0};
  EXPECT_EQ(refusal([&] { check_grid_map(map, "map"); }), "accepted");
}

using GridMapFile = ScratchFolder;

TEST_F(GridMapFile, CellsAreListedByColumnAndRow) {
  const GridMap map =
      read_cell_list(written("a.txt", "# free\n0 0\n1 0 # twice\n1 0\n\n1 1\n"), 3.0);
  EXPECT_EQ(grid_map_text(map), "#.\n..\n");
  EXPECT_EQ(map.cell_m, 3.0);
}

TEST_F(GridMapFile, RefusesListsThatAreNone) {
  const auto said = [&](const char* text) {
    const auto file = written("a.txt", text);
    return refusal([&] { read_cell_list(file, 1.0); });
  };
  EXPECT_THAT(said("0 0\n1\n"), HasSubstr("a.txt: line 2: '1': column and row of a free cell"));
  EXPECT_THAT(said("0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(said("0 -1\n"), HasSubstr("two whole numbers from 0 to 999"));
  EXPECT_THAT(said("1000 0\n"), HasSubstr("line 1: '1000 0'"));
  EXPECT_THAT(said("0.5 0\n"), HasSubstr("line 1: '0.5 0'"));
  EXPECT_THAT(said("# nothing\n"), HasSubstr("there is no free cell"));
  EXPECT_THAT(refusal([&] { read_cell_list(path("none.txt"), 1.0); }), HasSubstr("no such file"));
}

TEST_F(GridMapFile, HeightsAreAMatrixWithNorthOnTop) {
  GridMap map = grid_picture("..#\n...\n");
  read_cell_heights(written("h.txt", "1 2 3 # metres\n4.5 -5 6e0\n"), map);
  EXPECT_EQ(map.height_m[index_of(map, {0, 1})], 1.0);
  EXPECT_EQ(map.height_m[index_of(map, {1, 0})], -5.0);
}

TEST_F(GridMapFile, RefusesHeightsOfAnotherSize) {
  GridMap map = grid_picture("..\n..\n");
  const auto said = [&](const char* text) {
    const auto file = written("h.txt", text);
    return refusal([&] { read_cell_heights(file, map); });
  };
  EXPECT_THAT(said("1 2\n3\n"), HasSubstr("line 2: '1 heights': 2 heights"));
  EXPECT_THAT(said("1 2\n"), HasSubstr("'1 rows': 2 rows"));
  EXPECT_THAT(said("1 2\n3 4\n5 6\n"), HasSubstr("'3 rows': 2 rows"));
  EXPECT_THAT(said("1 2\n3 nan\n"), HasSubstr("line 2: 'nan': a finite height"));
  EXPECT_THAT(said("1 2\n3 4x\n"), HasSubstr("line 2: '4x': a finite height"));
}

// Obstacles counted as cells that touch at sides or corners.
int obstacles_on(const GridMap& map) {
  std::vector<int> seen(map.blocked.size(), 0);
  int count = 0;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      if (is_free(map, {column, row}) || seen[index_of(map, {column, row})] != 0) continue;
      ++count;
      std::vector<GridCell> reached = {{column, row}};
      seen[index_of(map, {column, row})] = 1;
      while (!reached.empty()) {
        const GridCell cell = reached.back();
        reached.pop_back();
        for (int k = 0; k < 9; ++k) {
          const GridCell next{cell.column + k % 3 - 1, cell.row + k / 3 - 1};
          if (!on_map(map, next) || is_free(map, next) || seen[index_of(map, next)] != 0) continue;
          seen[index_of(map, next)] = 1;
          reached.push_back(next);
        }
      }
    }
  }
  return count;
}

TEST(MadeUpGridMap, HasTheNumbersAskedFor) {
  // Size, blocked cells and obstacles of the four environments of Wang et al. 2025, Table 7.
  using Row = std::tuple<int, int, int>;
  for (const auto& [side, blocked, obstacles] :
       {Row{20, 42, 3}, Row{30, 90, 7}, Row{36, 162, 11}, Row{40, 295, 29}}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const double share = static_cast<double>(blocked) / (side * side);
      const GridMap map = made_up_grid_map({side, side, share, obstacles, seed}, "recipe");
      EXPECT_EQ(free_cell_count(map), side * side - blocked);
      EXPECT_EQ(obstacles_on(map), obstacles);
      EXPECT_EQ(areas_of(map).areas.size(), 1u);
      EXPECT_TRUE(is_free(map, {0, side - 1}) && is_free(map, {side - 1, 0}));
    }
  }
}

TEST(MadeUpGridMap, FollowsFromItsSeed) {
  const auto text = [](std::uint64_t seed) {
    return grid_map_text(made_up_grid_map({30, 20, 0.15, 6, seed}, "recipe"));
  };
  EXPECT_EQ(text(4), text(4));
  EXPECT_NE(text(4), text(5));
}

TEST(MadeUpGridMap, RefusesWhatCannotBe) {
  const auto said = [](const GridMapRecipe& recipe) {
    return refusal([&] { made_up_grid_map(recipe, "recipe"); });
  };
  EXPECT_EQ(said({0, 5, 0.1, 1, 1}), "recipe: map: '0 x 5 cells': 1 to 1000 columns and rows");
  EXPECT_THAT(said({1001, 5, 0.1, 1, 1}), HasSubstr("1 to 1000 columns and rows"));
  EXPECT_EQ(said({10, 10, 0.6, 1, 1}), "recipe: blocked_share: '0.6': a number from 0 to 0.5");
  EXPECT_EQ(said({10, 10, 0.1, 11, 1}),
            "recipe: obstacles: '11': a number from 1 to 10, the number of blocked cells");
  EXPECT_THAT(said({10, 10, 0.1, 0, 1}), HasSubstr("a number from 1 to 10"));
  EXPECT_THAT(said({10, 10, 0.5, 50, 1}), HasSubstr("found no place for them"));
  EXPECT_EQ(said({10, 10, 0.0, 0, 1}), "accepted");
}

}  // namespace
}  // namespace headland

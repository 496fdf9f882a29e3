#include "terrains/grid_map_from_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>

#include "refusal.h"
#include "terrains/grid_map_file.h"

namespace headland {
namespace {

// Areas of a thousand square metres and more carry rounding of 1e-12 of them.
constexpr double kGridArea_m2 = 1e-8;

Field field_with(Ring boundary) {
  Field field;
  field.boundary = std::move(boundary);
  return field;
}

Ring box_ring(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(GridOfField, ARectangleOfWholeCellsIsAllFree) {
  const FieldGrid grid = grid_of_field(field_with(box_ring(3, 5, 43, 29)), 2.0, 0.0, "field");
  EXPECT_EQ(grid.map.columns, 20);
  EXPECT_EQ(grid.map.rows, 12);
  EXPECT_EQ(free_cell_count(grid.map), 240);
  EXPECT_TRUE(grid.pockets.empty());
  EXPECT_NEAR(grid.left_out_m2, 0.0, kGridArea_m2);
  EXPECT_EQ(grid.map.origin_W, Eigen::Vector2d(3.0, 5.0));
}

TEST(GridOfField, CellsThatReachOverTheBoundaryAreBlocked) {
  // 41 m are 20 cells of 2 m and a half one.
  const FieldGrid grid = grid_of_field(field_with(box_ring(0, 0, 41, 24)), 2.0, 0.0, "field");
  EXPECT_EQ(grid.map.columns, 21);
  EXPECT_EQ(free_cell_count(grid.map), 240);
  EXPECT_NEAR(grid.left_out_m2, 24.0, kGridArea_m2);
}

TEST(GridOfField, ATriangleLosesTheCellsOnItsSlope) {
  const FieldGrid grid = grid_of_field(field_with({{0, 0}, {8, 0}, {0, 8}}), 2.0, 0.0, "field");
  EXPECT_EQ(grid_map_text(grid.map), "####\n.###\n..##\n...#\n");
}

TEST(GridOfField, HolesAndObstaclesBlockWhatTheyTouch) {
  Field field = field_with(box_ring(0, 0, 12, 12));
  field.holes = {{{5, 5}, {5, 7}, {7, 7}, {7, 5}}};
  Obstacle tree;
  tree.p_W = {1.0, 11.0};
  tree.radius_m = 0.5;
  Obstacle wall;
  wall.kind = ObstacleKind::kWall;
  wall.p_W = {9.0, 1.0};
  wall.run_W = {2.0, 0.0};
  wall.radius_m = 0.1;
  field.obstacles = {tree, wall};
  const FieldGrid grid = grid_of_field(field, 2.0, 0.0, "field");
  EXPECT_EQ(grid_map_text(grid.map), "#.....\n......\n..##..\n..##..\n......\n....##\n");
}

TEST(GridOfField, AWallThroughACellWithoutEndingInItBlocksIt) {
  Field field = field_with(box_ring(0, 0, 6, 6));
  Obstacle wall;
  wall.kind = ObstacleKind::kWall;
  wall.p_W = {1.0, 3.3};
  wall.run_W = {4.0, -0.6};
  wall.radius_m = 0.05;
  field.obstacles = {wall};
  const FieldGrid grid = grid_of_field(field, 2.0, 0.0, "field");
  // All of the middle row: it ends in the outer cells, and runs through the one between.
  EXPECT_FALSE(is_free(grid.map, {1, 1}));
  EXPECT_EQ(free_cell_count(grid.map), 3);
  ASSERT_EQ(grid.pockets.size(), 1u);
  EXPECT_EQ(grid.pockets[0].cells, 3);
}

TEST(GridOfField, PocketsAreFilledAndReported) {
  // A field of 10 x 5 m that a hole of a width of 2 m cuts into 6 x 5 and 2 x 5.
  Field field = field_with(box_ring(0, 0, 10, 5));
  field.holes = {{{6.2, 0.1}, {6.2, 4.9}, {7.8, 4.9}, {7.8, 0.1}}};
  const FieldGrid grid = grid_of_field(field, 1.0, 0.0, "field");
  EXPECT_EQ(free_cell_count(grid.map), 30);
  ASSERT_EQ(grid.pockets.size(), 1u);
  EXPECT_EQ(grid.pockets[0].cells, 10);
  EXPECT_EQ(grid.pockets[0].first, (GridCell{8, 0}));
  EXPECT_EQ(areas_of(grid.map).areas.size(), 1u);
  field.entry_W = Eigen::Vector2d(9.5, 2.0);
  EXPECT_EQ(free_cell_count(grid_of_field(field, 1.0, 0.0, "field").map), 10)
      << "the area at the entry is kept, also when it is the smaller one";
}

TEST(GridOfField, TurnsWithTheField) {
  const double angle_rad = 0.4;
  const Eigen::Rotation2Dd turn(angle_rad);
  Ring ring = box_ring(3, 5, 43, 29);
  for (Eigen::Vector2d& p : ring) p = turn * p;
  const FieldGrid grid = grid_of_field(field_with(ring), 2.0, angle_rad, "field");
  EXPECT_EQ(free_cell_count(grid.map), 240);
  for (const GridCell cell : {GridCell{0, 0}, GridCell{19, 11}}) {
    EXPECT_TRUE(inside_field(field_with(ring), centre_W(grid.map, cell)));
  }
  // Along the wrong axes cells are lost, but none is outside.
  const FieldGrid askew = grid_of_field(field_with(ring), 2.0, 0.0, "field");
  EXPECT_LT(free_cell_count(askew.map), 240);
  for (int row = 0; row < askew.map.rows; ++row) {
    for (int column = 0; column < askew.map.columns; ++column) {
      if (!is_free(askew.map, {column, row})) continue;
      for (int k = 0; k < 4; ++k) {
        // A millimetre inside the corners: the outline runs exactly through none of them.
        const Eigen::Vector2d corner(k % 2 == 0 ? -0.999 : 0.999, k / 2 == 0 ? -0.999 : 0.999);
        EXPECT_TRUE(inside_field(field_with(ring), centre_W(askew.map, {column, row}) + corner));
      }
    }
  }
}

TEST(GridOfField, RefusesWidthsThatGiveNoMap) {
  const Field field = field_with(box_ring(0, 0, 40, 24));
  const auto said = [&](double cell_m) {
    return refusal([&] { grid_of_field(field, cell_m, 0.0, "field.yaml"); });
  };
  EXPECT_EQ(said(0.0), "field.yaml: cell_m: '0': a number from 0.05 to 1000");
  EXPECT_EQ(said(30.0),
            "field.yaml: cell_m: '30': less: no cell of this width lies wholly inside the field");
  Field wide = field_with(box_ring(0, 0, 500, 24));
  EXPECT_EQ(refusal([&] { grid_of_field(wide, 0.25, 0.0, "f"); }),
            "f: cell_m: '0.25': at least 0.5: a map has at most 1000 columns and rows");
}

}  // namespace
}  // namespace headland

#include "terrains/grid_field.h"

#include <gtest/gtest.h>

#include <numbers>

#include "refusal.h"
#include "terrains/field_source.h"
#include "terrains/grid_map_file.h"

namespace headland {
namespace {

constexpr double kRingRounding_m2 = 1e-9;  // sums of a few hundred products

GridMap two_metre_map(const std::string& text) { return parse_grid_map(text, 2.0, "drawn"); }

double sum_of_areas_m2(const std::vector<Ring>& rings) {
  double sum_m2 = 0.0;
  for (const Ring& ring : rings) sum_m2 += signed_area_m2(ring);
  return sum_m2;
}

TEST(GridField, IsTheFreeCellsWithoutAMargin) {
  const GridMap map = two_metre_map("#...\n....\n.#..\n....\n");
  Field field = field_of_grid(map, 0.0, "map");
  EXPECT_NEAR(field_area_m2(field), 4.0 * free_cell_count(map), kRingRounding_m2);
  EXPECT_EQ(field.boundary.size(), 6U);
  ASSERT_EQ(field.holes.size(), 1U);
  EXPECT_EQ(field.holes[0].size(), 4U);
  EXPECT_FALSE(inside_field(field, centre_W(map, {0, 3})));
  EXPECT_FALSE(inside_field(field, centre_W(map, {1, 1})));
  EXPECT_TRUE(inside_field(field, centre_W(map, {2, 1})));
  EXPECT_NO_THROW(check_field(field, "map"));
}

TEST(GridField, LiesInItsMargin) {
  const GridMap map = two_metre_map("#...\n....\n.#..\n....\n");
  Field field = field_of_grid(map, 3.0, "map");
  EXPECT_EQ(field.boundary.size(), 4U);
  EXPECT_EQ(field.holes.size(), 2U);
  EXPECT_NEAR(field_area_m2(field), 14.0 * 14.0 - 2.0 * 4.0, kRingRounding_m2);
  EXPECT_TRUE(inside_field(field, {-2.9, 5.0}));
  EXPECT_NEAR(sum_of_areas_m2(field.to_work), 4.0 * free_cell_count(map), kRingRounding_m2);
  EXPECT_NO_THROW(check_field(field, "map"));
}

TEST(GridField, LeavesOutTheMarginBehindABlockedEdge) {
  const GridMap map = two_metre_map("####\n#..#\n####\n");
  const Field field = field_of_grid(map, 5.0, "map");
  EXPECT_NEAR(field_area_m2(field), 2.0 * 4.0, kRingRounding_m2);
}

// Rings that touch at a corner are refused as fields.
TEST(GridField, KeepsRingsApartWhereCellsTouchAtACorner) {
  const GridMap map = two_metre_map(".....\n.#...\n..#..\n#....\n.....\n");
  for (const double margin_m : {0.0, 4.0}) {
    Field field = field_of_grid(map, margin_m, "map");
    EXPECT_NO_THROW(check_field(field, "map"));
    const double given_m2 = 4.0 * free_cell_count(map) + (margin_m > 0.0 ? 18.0 * 18.0 - 100.0 : 0);
    EXPECT_NEAR(field_area_m2(field), given_m2, 8 * kCornerGap_m * 2.0);
  }
}

TEST(GridField, TurnsWithItsMap) {
  GridMap map = two_metre_map("...\n.#.\n...\n");
  const Field straight = field_of_grid(map, 1.0, "map");
  map.direction_rad = std::numbers::pi / 2.0;
  map.origin_W = {10.0, -4.0};
  const Field turned = field_of_grid(map, 1.0, "map");
  ASSERT_EQ(turned.boundary.size(), straight.boundary.size());
  for (std::size_t i = 0; i < straight.boundary.size(); ++i) {
    const Eigen::Vector2d& p = straight.boundary[i];
    const Eigen::Vector2d expected(10.0 - p.y(), -4.0 + p.x());
    EXPECT_LT((turned.boundary[i] - expected).norm(), 1e-12);
  }
}

TEST(GridField, RefusesAMarginOutOfRange) {
  const GridMap map = two_metre_map("..\n..\n");
  for (const double margin_m : {-1.0, 1e4}) {
    const std::string text = refusal([&] { field_of_grid(map, margin_m, "maps.yaml"); });
    EXPECT_NE(text.find("maps.yaml"), std::string::npos) << text;
    EXPECT_NE(text.find("margin_m"), std::string::npos) << text;
    EXPECT_NE(text.find("from 0 to 1000"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace headland

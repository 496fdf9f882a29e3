#include "terrains/field_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace headland {
namespace {

TEST(FieldGenerator, FieldsAreWhatTheirRecipesSay) {
  int holes = 0;
  int trees = 0;
  int asked_holes = 0;
  int asked_trees = 0;
  for (const FieldRecipe& recipe : field_suite(60)) {
    const Field field = made_up_field(recipe);
    EXPECT_NEAR(signed_area_m2(field.boundary), recipe.area_m2, 1e-6 * recipe.area_m2);
    EXPECT_LE(std::ssize(field.holes), recipe.holes);
    EXPECT_LE(std::ssize(field.obstacles), recipe.trees);
    for (const Ring& hole : field.holes) EXPECT_LT(signed_area_m2(hole), 0.0);
    holes += static_cast<int>(field.holes.size());
    trees += static_cast<int>(field.obstacles.size());
    asked_holes += recipe.holes;
    asked_trees += recipe.trees;
  }
  // There is no room for some in small and thin fields.
  EXPECT_GE(holes, 0.8 * asked_holes) << asked_holes;
  EXPECT_GE(trees, 0.9 * asked_trees) << asked_trees;
}

TEST(FieldGenerator, ASuiteHasEveryShapeAllSizesAndUpToEightHoles) {
  const std::vector<FieldRecipe> suite = field_suite(200);
  std::set<FieldShape> shapes;
  std::set<int> holes;
  for (const FieldRecipe& recipe : suite) {
    shapes.insert(recipe.shape);
    holes.insert(recipe.holes);
    EXPECT_GE(recipe.area_m2, 1e3);
    EXPECT_LE(recipe.area_m2, 1e6);
  }
  EXPECT_EQ(shapes.size(), kEveryFieldShape.size());
  EXPECT_EQ(holes.size(), 9U);
  const auto [least, most] = std::ranges::minmax(suite, {}, &FieldRecipe::area_m2);
  EXPECT_LT(least.area_m2, 2e3);
  EXPECT_GT(most.area_m2, 5e5);
}

TEST(FieldGenerator, SameRecipeSameFieldAndFirstOnesStay) {
  const FieldRecipe recipe = field_suite(7).back();
  const FieldRecipe same = field_suite(50)[6];
  EXPECT_EQ(made_up_field(recipe).boundary, made_up_field(same).boundary);
  FieldRecipe other = recipe;
  ++other.seed;
  EXPECT_NE(made_up_field(recipe).boundary, made_up_field(other).boundary);
}

// Length of the boundary over that of a circle of the same area: what makes fields hard.
TEST(FieldGenerator, ThinAndSpiralFieldsAreFarFromRound) {
  const auto roundness = [](FieldShape shape) {
    const Field field = made_up_field({shape, 1e4, 0, 0, 5});
    double length_m = 0.0;
    for (std::size_t i = 0; i < field.boundary.size(); ++i) {
      length_m += (field.boundary[(i + 1) % field.boundary.size()] - field.boundary[i]).norm();
    }
    return length_m / (2.0 * std::sqrt(1e4 * 3.14159265));
  };
  EXPECT_LT(roundness(FieldShape::kConvex), 1.5);
  EXPECT_GT(roundness(FieldShape::kThin), 1.7);
  EXPECT_GT(roundness(FieldShape::kSpiral), 2.5);
}

}  // namespace
}  // namespace headland

// Made-up fields of the shapes that farms have.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "terrains/field.h"

namespace headland {

enum class FieldShape {
  kConvex,   // 3 to 12 corners on an ellipse
  kConcave,  // 4 to 14 corners, with bays up to near the middle
  kThin,     // 8 to 30 times as long as wide
  kL,        // two arms at a right angle
  kSpiral,   // a band wound up one and a half to two and a half times
};
inline constexpr std::array kEveryFieldShape = {FieldShape::kConvex, FieldShape::kConcave,
                                                FieldShape::kThin, FieldShape::kL,
                                                FieldShape::kSpiral};
std::string_view field_shape_name(FieldShape shape);

struct FieldRecipe {
  FieldShape shape = FieldShape::kConvex;
  double area_m2 = 1e4;  // inside the boundary
  int holes = 0;         // of 3 to 9 corners and up to 20 m radius; fewer where there is no room
  int trees = 0;
  std::uint64_t seed = 1;
};

// The field of a recipe, turned at random, around the origin of W; checked by check_field.
// Boundary, holes and trees keep 0.5 m from one another, trees among themselves nothing.
Field made_up_field(const FieldRecipe& recipe);

// `count` recipes, the shapes in turn: 0.1 to 100 ha (log-uniform), 0 to 8 holes, in two of five
// fields up to 6 trees. The first ones are the same for any count.
std::vector<FieldRecipe> field_suite(int count, std::uint64_t seed = 1);

}  // namespace headland

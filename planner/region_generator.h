// Made-up irregular fields that come to a given number of convex parts.
#pragma once

#include <cstdint>
#include <string>

#include "terrains/field.h"

namespace headland {

struct RegionRecipe {
  int parts = 6;   // 1 to kMostMadeUpParts
  int holes = -1;  // -1: none for up to kPartsWithoutHoles parts, above one for about five parts
  double area_m2 = 3e5;
  std::uint64_t seed = 1;
};
inline constexpr int kMostMadeUpParts = 1000;
inline constexpr int kPartsWithoutHoles = 12;

// An irregular boundary with bays, seen whole from its middle, and convex holes of three to six
// corners, which convex_pieces() cuts into exactly so many parts: the coordinates of IGA-CPP's
// regions are lost. Up to kPartsWithoutHoles parts none is smaller than kLeastShare of the
// mean, so that no filter takes one away. Boundary counter-clockwise, holes clockwise, rings apart.
// Throws InputError(source): numbers out of range, or no such field found.
Field made_up_region(const RegionRecipe& recipe, const std::string& source);
inline constexpr double kLeastShare = 0.1;

}  // namespace headland

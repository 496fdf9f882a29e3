#include "planner/region_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "planner/arcs.h"
#include "planner/decomposition.h"
#include "planner/indexed.h"
#include "planner/seeded_random.h"
#include "planner/segment.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kFieldTries = 2000;    // fields begun anew
constexpr int kTriesForAHole = 200;  // places tried for one hole
constexpr int kLeastHoleCorners = 3;
constexpr int kMostHoleCorners = 6;
constexpr int kPartsPerHole = 5;
constexpr double kDeepestBay = 0.35;  // of the widest radius
constexpr double kHolesShare = 0.12;  // of the ground, all together, at most
constexpr double kUnitRadius_m = 100.0;

double draw_between(SeededRandom& random, double low, double high) {
  return low + (high - low) * draw_unit(random);
}

// Seen whole from the middle; radii from `least` to 1 of radius_m.
Ring star_ring(SeededRandom& random, const Eigen::Vector2d& middle_W, double radius_m, int corners,
               double least) {
  const double begin_rad = draw_between(random, 0.0, 2.0 * std::numbers::pi);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad =
        begin_rad + 2.0 * std::numbers::pi * (i + draw_between(random, -0.3, 0.3)) / corners;
    ring.emplace_back(middle_W +
                      radius_m * draw_between(random, least, 1.0) * direction_of(angle_rad));
  }
  return ring;
}

int concave_corners(const Ring& ring) {
  const int count = static_cast<int>(ring.size());
  int concave = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d& p_W = at(ring, i);
    const Eigen::Vector2d in = p_W - at(ring, (i + count - 1) % count);
    concave += cross(in, at(ring, (i + 1) % count) - p_W) < 0.0 ? 1 : 0;
  }
  return concave;
}

// Corners of the holes, so that they make about their share of the parts.
std::vector<int> hole_corners(const RegionRecipe& recipe, int holes, SeededRandom& random) {
  std::vector<int> corners;
  int left = recipe.parts - 1;
  for (int i = 0; i < holes; ++i) {
    const int most =
        std::min(kMostHoleCorners, left - (holes - 1 - i) * (kLeastHoleCorners - 1) + 1);
    const int own = kLeastHoleCorners + draw_below(random, most - kLeastHoleCorners + 1);
    corners.push_back(own);
    left -= own - 1;
  }
  return corners;
}

// Whether every hole found a place.
bool add_holes(const std::vector<int>& corners, SeededRandom& random, Field& field) {
  if (corners.empty()) return true;
  const double share_m2 =
      kHolesShare * signed_area_m2(field.boundary) / static_cast<double>(corners.size());
  const double radius_m = std::sqrt(share_m2 / std::numbers::pi);
  for (const int count : corners) {
    for (int tries = 0;; ++tries) {
      if (tries == kTriesForAHole) return false;
      const Eigen::Vector2d middle_W(draw_between(random, -kUnitRadius_m, kUnitRadius_m),
                                     draw_between(random, -kUnitRadius_m, kUnitRadius_m));
      if (field_clearance_m(field, middle_W) < 1.3 * radius_m) continue;
      Ring hole = star_ring(random, middle_W, radius_m, count, 0.8);
      if (concave_corners(hole) > 0 || !inside_ring(hole, middle_W)) continue;
      std::ranges::reverse(hole);
      field.holes.push_back(std::move(hole));
      break;
    }
  }
  return true;
}

bool has_parts(const Field& field, const RegionRecipe& recipe) {
  const std::vector<Ring> parts = convex_pieces({field.boundary, field.holes});
  if (static_cast<int>(parts.size()) != recipe.parts) return false;
  if (recipe.parts > kPartsWithoutHoles) return true;
  const double least_m2 = kLeastShare * field_area_m2(field) / recipe.parts;
  return std::ranges::all_of(parts,
                             [&](const Ring& part) { return signed_area_m2(part) >= least_m2; });
}

std::optional<Field> drawn_field(const RegionRecipe& recipe, int holes, SeededRandom& random) {
  const std::vector<int> corners = hole_corners(recipe, holes, random);
  const int by_holes = std::accumulate(corners.begin(), corners.end(), 0) - holes;
  const int concave = recipe.parts - 1 - by_holes;
  const int convex = 3 + draw_below(random, concave + 3);
  Field field;
  field.boundary = star_ring(random, {0.0, 0.0}, kUnitRadius_m, concave + convex, kDeepestBay);
  if (signed_area_m2(field.boundary) <= 0.0) return std::nullopt;
  if (concave_corners(field.boundary) != concave) return std::nullopt;
  if (!add_holes(corners, random, field)) return std::nullopt;
  const double scale = std::sqrt(recipe.area_m2 / field_area_m2(field));
  for (Eigen::Vector2d& p_W : field.boundary) p_W *= scale;
  for (Ring& hole : field.holes) {
    for (Eigen::Vector2d& p_W : hole) p_W *= scale;
  }
  return field;
}

}  // namespace

Field made_up_region(const RegionRecipe& recipe, const std::string& source) {
  if (recipe.parts < 1 || recipe.parts > kMostMadeUpParts) {
    throw InputError(source, "parts", fmt::format("{}", recipe.parts),
                     fmt::format("a whole number from 1 to {}", kMostMadeUpParts));
  }
  const int most_holes = (recipe.parts - 1) / (kLeastHoleCorners - 1);
  if (recipe.holes > most_holes) {
    throw InputError(source, "holes", fmt::format("{}", recipe.holes),
                     fmt::format("at most {} for {} parts", most_holes, recipe.parts));
  }
  if (!(recipe.area_m2 > 0.0) || !std::isfinite(recipe.area_m2)) {
    throw InputError(source, "area_m2", fmt::format("{}", recipe.area_m2), "an area above 0 m2");
  }
  const int holes = recipe.holes >= 0                    ? recipe.holes
                    : recipe.parts <= kPartsWithoutHoles ? 0
                                                         : recipe.parts / kPartsPerHole;
  SeededRandom random(recipe.seed);
  for (int tries = 0; tries < kFieldTries; ++tries) {
    std::optional<Field> field = drawn_field(recipe, holes, random);
    if (!field || !has_parts(*field, recipe)) continue;
    field->name = fmt::format("{} parts", recipe.parts);
    return *std::move(field);
  }
  throw InputError(
      source, "parts", fmt::format("{}", recipe.parts),
      fmt::format("no such field with {} holes found; other numbers are needed", holes));
}

}  // namespace headland

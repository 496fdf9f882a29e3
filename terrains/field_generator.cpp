#include "terrains/field_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "terrains/field_source.h"
#include "terrains/seeded_noise.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr double kFullTurn_rad = 2.0 * std::numbers::pi;
constexpr double kLeastGap_m = 0.5;  // between holes, trees and boundary
constexpr int kTriesEach = 20;       // places tried for a hole or a tree

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * seeded_uniform(seed_, drawn_++);
  }
  int count(int low, int high) { return static_cast<int>(number(low, high + 1.0)); }
  bool chance(double probability) { return number(0.0, 1.0) < probability; }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

Vector2d at_angle(double radius_m, double angle_rad) {
  return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)};
}

// Seen whole from its centre, corners at `least` to 1 of an ellipse's radius.
Ring star(Draws& draws, int corners, double least) {
  const double flat = draws.number(0.4, 1.0);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = kFullTurn_rad * (i + draws.number(-0.3, 0.3)) / corners;
    const Vector2d p = at_angle(draws.number(least, 1.0), angle_rad);
    ring.emplace_back(p.x(), flat * p.y());
  }
  return ring;
}

Ring thin(Draws& draws) {
  const double length = draws.number(8.0, 30.0);
  const double taper = draws.number(0.7, 1.0);
  const double slant = draws.number(-1.0, 1.0);
  return {{0.0, 0.0}, {length, 0.0}, {length + slant, taper}, {0.0, 1.0}};
}

Ring l_shape(Draws& draws) {
  const double across = draws.number(0.2, 0.6);
  const double up = draws.number(0.2, 0.6);
  const double height = draws.number(0.5, 1.0);
  return {{0.0, 0.0},       {1.0, 0.0},   {1.0, up * height}, {across, up * height},
          {across, height}, {0.0, height}};
}

Ring spiral(Draws& draws) {
  constexpr int kCornersPerTurn = 16;
  const double turns = draws.number(1.5, 2.5);
  const double width = draws.number(0.5, 0.8);  // of the distance between its turns
  const int steps = static_cast<int>(turns * kCornersPerTurn);
  Ring ring;
  for (int i = 0; i <= steps; ++i) {
    const double turn = static_cast<double>(i) / kCornersPerTurn;
    ring.push_back(at_angle(0.6 + turn + width, kFullTurn_rad * turn));
  }
  for (int i = steps; i >= 0; --i) {
    const double turn = static_cast<double>(i) / kCornersPerTurn;
    ring.push_back(at_angle(0.6 + turn, kFullTurn_rad * turn));
  }
  return ring;
}

Ring outline(Draws& draws, FieldShape shape) {
  switch (shape) {
    case FieldShape::kConvex:
      return star(draws, draws.count(3, 12), 1.0);
    case FieldShape::kConcave:
      return star(draws, draws.count(4, 14), draws.number(0.2, 0.6));
    case FieldShape::kThin:
      return thin(draws);
    case FieldShape::kL:
      return l_shape(draws);
    case FieldShape::kSpiral:
      return spiral(draws);
  }
  return {};
}

Vector2d middle_of(const Ring& ring) {
  Vector2d low = ring.front();
  Vector2d high = low;
  for (const Vector2d& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 0.5 * (low + high);
}

// Turned, brought to its area and around the origin.
Ring placed(Ring ring, double area_m2, double turned_rad) {
  const Vector2d middle = middle_of(ring);
  const double scale = std::sqrt(area_m2 / std::abs(signed_area_m2(ring)));
  for (Vector2d& p : ring) {
    const Vector2d at = scale * (p - middle);
    p = at.x() * at_angle(1.0, turned_rad) +
        at.y() * at_angle(1.0, turned_rad + kFullTurn_rad / 4.0);
  }
  return ring;
}

double extent_m(const Ring& ring) {
  double most_m = 0.0;
  for (const Vector2d& p_W : ring) most_m = std::max(most_m, p_W.cwiseAbs().maxCoeff());
  return most_m;
}

}  // namespace

std::string_view field_shape_name(FieldShape shape) {
  switch (shape) {
    case FieldShape::kConvex:
      return "convex";
    case FieldShape::kConcave:
      return "concave";
    case FieldShape::kThin:
      return "thin";
    case FieldShape::kL:
      return "L";
    case FieldShape::kSpiral:
      return "spiral";
  }
  return "";
}

Field made_up_field(const FieldRecipe& recipe) {
  Draws draws(recipe.seed);
  Field field;
  field.name = fmt::format("{}_{}", field_shape_name(recipe.shape), recipe.seed);
  const double turned_rad = draws.number(0.0, kFullTurn_rad);
  field.boundary = placed(outline(draws, recipe.shape), recipe.area_m2, turned_rad);
  const double reach_m = extent_m(field.boundary);
  const auto place = [&] {
    const double x_m = draws.number(-reach_m, reach_m);
    return Vector2d(x_m, draws.number(-reach_m, reach_m));
  };
  const double widest_m = std::min(20.0, 0.15 * std::sqrt(recipe.area_m2));
  for (int i = 0; i < kTriesEach * recipe.holes && std::ssize(field.holes) < recipe.holes; ++i) {
    const double radius_m = draws.number(0.5, widest_m);
    const Vector2d centre_W = place();
    if (field_clearance_m(field, centre_W) < radius_m + kLeastGap_m) continue;
    Ring hole = star(draws, draws.count(3, 9), 0.7);
    for (Vector2d& p_W : hole) p_W = centre_W + radius_m * p_W;
    field.holes.push_back(std::move(hole));
  }
  for (int i = 0; i < kTriesEach * recipe.trees && std::ssize(field.obstacles) < recipe.trees;
       ++i) {
    const Obstacle tree{ObstacleKind::kTree, place(), draws.number(0.1, 0.8), 5.0};
    if (field_clearance_m(field, tree.p_W) < tree.radius_m + kLeastGap_m) continue;
    field.obstacles.push_back(tree);
  }
  check_field(field, field.name);
  return field;
}

std::vector<FieldRecipe> field_suite(int count, std::uint64_t seed) {
  std::vector<FieldRecipe> recipes;
  Draws draws(seed);
  for (int i = 0; i < count; ++i) {
    FieldRecipe recipe;
    recipe.shape = kEveryFieldShape[static_cast<std::size_t>(i) % kEveryFieldShape.size()];
    recipe.area_m2 = 1e3 * std::pow(1e3, draws.number(0.0, 1.0));
    recipe.holes = draws.count(0, 8);
    recipe.trees = draws.chance(0.4) ? draws.count(1, 6) : 0;
    recipe.seed = seed + static_cast<std::uint64_t>(i);
    recipes.push_back(recipe);
  }
  return recipes;
}

}  // namespace headland

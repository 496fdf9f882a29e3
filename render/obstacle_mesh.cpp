#include "render/obstacle_mesh.h"

#include <algorithm>
#include <array>

namespace headland {
namespace {

using Profile = Eigen::Vector2d;  // radius, z
using Point = Eigen::Vector3d;

// A trunk and three crowns of leaves, each narrowing upwards.
Mesh tree_mesh(double radius_m, double height_m) {
  constexpr Rgba kTrunk{116, 88, 62};
  constexpr Rgba kLeaves{92, 142, 74};
  constexpr int kSides = 14;
  const double h = height_m;
  const std::array<Profile, 3> trunk = {
      {{radius_m, 0.0}, {0.8 * radius_m, 0.4 * h}, {0.0, 0.6 * h}}};
  Mesh tree = revolved_mesh(trunk, kSides, kTrunk);
  const double crown = std::max(0.22 * h, 2.0 * radius_m);
  const std::array<Profile, 7> leaves = {{{0.0, 0.27 * h},
                                          {0.75 * crown, 0.33 * h},
                                          {crown, 0.48 * h},
                                          {0.95 * crown, 0.66 * h},
                                          {0.70 * crown, 0.84 * h},
                                          {0.35 * crown, 0.96 * h},
                                          {0.0, h}}};
  append(tree, revolved_mesh(leaves, kSides, kLeaves), Eigen::Isometry3d::Identity());
  return tree;
}

Mesh pole_mesh(double radius_m, double height_m) {
  constexpr Rgba kPole{150, 148, 144};
  constexpr int kSides = 16;
  const std::array<Profile, 3> pole = {{{radius_m, 0.0}, {radius_m, height_m}, {0.0, height_m}}};
  return revolved_mesh(pole, kSides, kPole);
}

Mesh rock_mesh(double radius_m, double height_m) {
  constexpr Rgba kStone{148, 142, 134};
  constexpr int kSides = 7;
  const std::array<Profile, 5> rock = {{{radius_m, 0.0},
                                        {0.97 * radius_m, 0.35 * height_m},
                                        {0.75 * radius_m, 0.72 * height_m},
                                        {0.4 * radius_m, 0.95 * height_m},
                                        {0.0, height_m}}};
  return revolved_mesh(rock, kSides, kStone);
}

// The foot reaches into the ground, where the terrain between the ends lies lower than its chord.
Mesh wall_mesh(const Obstacle& obstacle, const Point& from, const Point& to) {
  constexpr Rgba kMasonry{176, 166, 152};
  constexpr double kFoot_m = 0.3;
  const Point along(to.x() - from.x(), to.y() - from.y(), 0.0);
  const Point aside = obstacle.radius_m * Point(-along.y(), along.x(), 0.0).normalized();
  const Point down(0.0, 0.0, -kFoot_m);
  const Point up(0.0, 0.0, obstacle.height_m);
  return prism_mesh(
      {from - aside + down, to - aside + down, to + aside + down, from + aside + down},
      {from - aside + up, to - aside + up, to + aside + up, from + aside + up}, kMasonry);
}

Mesh fence_mesh(const Obstacle& obstacle, const Point& from, const Point& to) {
  constexpr Rgba kPost{120, 96, 70};
  constexpr Rgba kRail{156, 130, 98};
  const double radius_m = obstacle.radius_m;
  const Point up(0.0, 0.0, obstacle.height_m);
  Mesh fence = bar_mesh(from, from + up, radius_m, kPost);
  append(fence, bar_mesh(to, to + up, radius_m, kPost), Eigen::Isometry3d::Identity());
  for (const double part : {0.4, 0.85}) {
    append(fence, bar_mesh(from + part * up, to + part * up, 0.6 * radius_m, kRail),
           Eigen::Isometry3d::Identity());
  }
  return fence;
}

}  // namespace

Mesh obstacle_mesh(const Obstacle& obstacle) {
  switch (obstacle.kind) {
    case ObstacleKind::kTree:
      return tree_mesh(obstacle.radius_m, obstacle.height_m);
    case ObstacleKind::kPole:
      return pole_mesh(obstacle.radius_m, obstacle.height_m);
    case ObstacleKind::kRock:
      return rock_mesh(obstacle.radius_m, obstacle.height_m);
    case ObstacleKind::kWall:
    case ObstacleKind::kFence:
      break;
  }
  return {};
}

Mesh barrier_mesh(const Obstacle& obstacle, const Point& from, const Point& to) {
  return obstacle.kind == ObstacleKind::kFence ? fence_mesh(obstacle, from, to)
                                               : wall_mesh(obstacle, from, to);
}

}  // namespace headland

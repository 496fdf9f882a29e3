#include "render/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/gltf.h"
#include "render/obstacle_mesh.h"
#include "render/relief.h"
#include "render/vehicle_mesh.h"

namespace headland {
namespace {

using Point3 = Eigen::Vector3d;

constexpr double kLift_m = 0.12;  // of lines, over ground that is drawn more coarsely than it is

// The terrain sampled evenly, so that its size in bytes is bounded whatever the grid.
Heightfield resampled(const Heightfield& terrain, const Extent& extent) {
  Heightfield coarse;
  coarse.cell_m = std::max(terrain.cell_m, extent.size().maxCoeff() / (kSceneNodes - 1));
  coarse.origin_W = extent.low;
  coarse.columns = std::max(2, static_cast<int>(extent.size().x() / coarse.cell_m) + 1);
  coarse.rows = std::max(2, static_cast<int>(extent.size().y() / coarse.cell_m) + 1);
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      const Eigen::Vector2d p = coarse.origin_W + coarse.cell_m * Eigen::Vector2d(column, row);
      coarse.height_m.push_back(surface_at(terrain, p.x(), p.y()).height_m);
    }
  }
  return coarse;
}

// What stands on the field, piece by piece, each about its foot.
struct Standing {
  std::vector<Point3> feet;
  std::vector<Mesh> meshes;
};

Standing standing(const PictureScene& scene, const Relief& relief) {
  constexpr double kPiece_m = 2.5;  // between a fence's posts
  Standing all;
  for (const Obstacle& obstacle : scene.field.obstacles) {
    if (!runs_along_line(obstacle.kind)) {
      all.feet.push_back(on_ground(scene.terrain, relief, obstacle.p_W));
      all.meshes.push_back(obstacle_mesh(obstacle));
      continue;
    }
    const std::vector<Point3> ends = draped(
        scene.terrain, relief, {obstacle.p_W, obstacle.p_W + obstacle.run_W}, false, kPiece_m, 0.0);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const Point3 foot = 0.5 * (ends[i - 1] + ends[i]);
      all.feet.push_back(foot);
      all.meshes.push_back(barrier_mesh(obstacle, ends[i - 1] - foot, ends[i] - foot));
    }
  }
  return all;
}

GltfNode obstacles_node(const Standing& all) {
  GltfNode node{.name = "obstacles"};
  for (std::size_t i = 0; i < all.feet.size(); ++i) {
    node.children.push_back({.name = "obstacle",
                             .X = Eigen::Isometry3d(Eigen::Translation3d(all.feet[i])),
                             .mesh = &all.meshes[i]});
  }
  return node;
}

bool is_pass(PathKind kind) { return kind == PathKind::kSwath || kind == PathKind::kHeadlandPass; }

// On the ground: of passes, which are nearly straight, every fourth point of the path and all ends.
std::vector<GltfLine> planned_lines(const PictureScene& scene, const Relief& relief, bool passes) {
  const std::size_t every = passes ? 4 : 1;
  std::vector<GltfLine> lines;
  for (const PathSegment& segment : scene.path.segments) {
    if (is_pass(segment.kind) != passes) continue;
    GltfLine& line = lines.emplace_back();
    for (std::size_t i = 0; i < segment.points.size(); ++i) {
      if (i % every != 0 && i + 1 != segment.points.size()) continue;
      line.points.push_back(on_ground(scene.terrain, relief, segment.points[i].p_W) +
                            Point3(0.0, 0.0, kLift_m));
    }
  }
  return lines;
}

std::vector<GltfLine> boundary_lines(const PictureScene& scene, const Relief& relief,
                                     double spacing_m) {
  std::vector<GltfLine> lines;
  const auto add = [&](const Ring& ring) {
    lines.push_back({draped(scene.terrain, relief, ring, true, spacing_m, kLift_m), true});
  };
  add(scene.field.boundary);
  for (const Ring& hole : scene.field.holes) add(hole);
  return lines;
}

// The vehicle's meshes, which its nodes point to.
struct VehicleMeshes {
  Mesh body;
  std::array<Mesh, 2> wheels;      // rear, front
  std::array<Mesh, 2> implements;  // up, down; about the origin of their node
  Point3 pin_B = Point3::Zero();
};

VehicleMeshes vehicle_meshes(const Vehicle& vehicle) {
  VehicleMeshes meshes;
  meshes.body = body_mesh(vehicle).mesh;
  meshes.wheels = {wheel_mesh(vehicle.rear), wheel_mesh(vehicle.front)};
  if (vehicle.implement.trailing) meshes.pin_B.x() = vehicle.implement.trailing->hitch_x_B_m;
  const Eigen::Isometry3d from_pin(Eigen::Translation3d(-meshes.pin_B));
  for (const std::size_t down : {0U, 1U}) {
    append(meshes.implements[down], implement_mesh(vehicle, down == 1), from_pin);
  }
  return meshes;
}

GltfNode vehicle_node(const Vehicle& vehicle, const VehicleMeshes& meshes) {
  const auto at = [](const Point3& p) { return Eigen::Isometry3d(Eigen::Translation3d(p)); };
  GltfNode node{.name = "vehicle"};
  node.children.push_back({.name = "body", .mesh = &meshes.body});
  for (std::size_t i = 0; i < 4; ++i) {
    const Axle& axle = i < 2 ? vehicle.rear : vehicle.front;
    if (!(axle.radius_m > 0.0)) continue;
    const double left_m = (i % 2 == 0 ? 0.5 : -0.5) * axle.track_m;
    node.children.push_back({.name = "wheel_" + std::to_string(i),
                             .X = at({axle.x_B_m, left_m, axle.radius_m}),
                             .mesh = &meshes.wheels[i / 2]});
  }
  GltfNode implement{.name = "implement", .X = at(meshes.pin_B)};
  implement.children.push_back({.name = "up", .mesh = meshes.implements.data()});
  implement.children.push_back({.name = "down", .mesh = &meshes.implements[1]});
  node.children.push_back(std::move(implement));
  return node;
}

}  // namespace

SceneFile scene_file(const PictureScene& scene) {
  constexpr double kMarginShare = 0.08;
  constexpr double kThickness = 0.03;
  const Extent field = extent_of(scene.field.boundary);
  const double size_m = field.size().maxCoeff();
  const Extent extent =
      overlap(grown(field, std::max(3.0, kMarginShare * size_m)), extent_of(scene.terrain));
  const Heightfield ground = resampled(scene.terrain, extent);
  const Extent block = extent_of(ground);
  const Relief relief{height_range(ground, block).low_m, 1.0};
  const Mesh top = relief_mesh(ground, relief, block, colours::kMeadow);
  const Mesh sides = relief_sides(ground, relief, block, -kThickness * size_m, colours::kBlockSide);
  const Standing obstacles = standing(scene, relief);
  const VehicleMeshes vehicle = vehicle_meshes(scene.vehicle);
  GltfNode root{.name = "scene"};
  root.children = {{.name = "terrain", .mesh = &top, .bare = true},
                   {.name = "block", .mesh = &sides},
                   {.name = "passes",
                    .lines = planned_lines(scene, relief, true),
                    .line_colour = colours::kPlannedPass},
                   {.name = "turns",
                    .lines = planned_lines(scene, relief, false),
                    .line_colour = colours::kPlannedTurn},
                   {.name = "boundary",
                    .lines = boundary_lines(scene, relief, ground.cell_m),
                    .line_colour = {250, 250, 246}},
                   obstacles_node(obstacles),
                   vehicle_node(scene.vehicle, vehicle)};
  return {glb_of(root), relief.base_m};
}

}  // namespace headland

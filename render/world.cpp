#include "render/world.h"

#include <cmath>
#include <limits>

#include "render/obstacle_mesh.h"
#include "render/sight.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

constexpr float kFadeFrom_m = 55.0F;
constexpr float kFadeTo_m = 170.0F;

// Normal of the stretched ground.
Point3 normal_D(const PictureScene& scene, const Relief& relief, const Point2& p_W) {
  const Point2 slope = relief.exaggeration * surface_at(scene.terrain, p_W.x(), p_W.y()).gradient;
  return {-slope.x(), -slope.y(), 1.0};
}

// Calls `stand(mesh in D, foot)` for every body on the field, a fence's pieces one by one.
template <typename Stand>
void for_each_obstacle(const PictureScene& scene, const Relief& relief, Stand stand) {
  for (const Obstacle& obstacle : scene.field.obstacles) {
    if (!runs_along_line(obstacle.kind)) {
      Mesh mesh;
      append(
          mesh, obstacle_mesh(obstacle),
          Eigen::Isometry3d(Eigen::Translation3d(on_ground(scene.terrain, relief, obstacle.p_W))));
      stand(mesh, obstacle.p_W);
      continue;
    }
    constexpr double kPiece_m = 2.5;  // between a fence's posts
    const std::vector<Point3> feet = draped(
        scene.terrain, relief, {obstacle.p_W, obstacle.p_W + obstacle.run_W}, false, kPiece_m, 0.0);
    for (std::size_t i = 1; i < feet.size(); ++i) {
      stand(barrier_mesh(obstacle, feet[i - 1], feet[i]),
            Point2((0.5 * (feet[i - 1] + feet[i])).head<2>()));
    }
  }
}

Mesh obstacles_of(const PictureScene& scene, const Relief& relief) {
  Mesh all;
  for_each_obstacle(scene, relief, [&](const Mesh& mesh, const Point2&) {
    append(all, mesh, Eigen::Isometry3d::Identity());
  });
  return all;
}

Mesh obstacle_shadows_of(const PictureScene& scene, const Relief& relief,
                         const Eigen::Vector3f& to_sun) {
  Mesh all;
  for_each_obstacle(scene, relief, [&](const Mesh& mesh, const Point2& foot_W) {
    append(all,
           shadow_mesh(mesh, on_ground(scene.terrain, relief, foot_W),
                       normal_D(scene, relief, foot_W), to_sun),
           Eigen::Isometry3d::Identity());
  });
  return all;
}

Mesh vehicle_of(const World& world, const RunSample* sample) {
  Mesh mesh;
  if (sample != nullptr) {
    append(mesh, moved_vehicle_mesh(world.scene.vehicle, world.body, *sample),
           pose_in_D(*sample, world.relief));
  }
  return mesh;
}

Mesh vehicle_shadow_of(const World& world, const RunSample* sample, const Mesh& machine_D) {
  if (sample == nullptr) return {};
  const Point2 p_W = sample->p_WB.head<2>();
  return shadow_mesh(machine_D, pose_in_D(*sample, world.relief).translation(),
                     normal_D(world.scene, world.relief, p_W), world.to_sun);
}

Mesh ground_of(const World& world, const FieldView& view, Surroundings surroundings,
               const Point2& centre_W) {
  const Heightfield& terrain = world.scene.terrain;
  if (surroundings != Surroundings::kSky) {
    return relief_mesh(terrain, world.relief, view.block, colours::kMeadow);
  }
  Mesh ground = graded_relief_mesh(terrain, world.relief, view.block, centre_W, colours::kMeadow);
  drop_unseen(ground, Sight(clip_from_D(view.camera)));
  return ground;
}

Mesh sides_of(const World& world, const FieldView& view, Surroundings surroundings) {
  if (surroundings == Surroundings::kSky) return {};
  return relief_sides(world.scene.terrain, world.relief, view.block, view.bottom_D,
                      colours::kBlockSide);
}

SurfaceLook look_of(const World& world, const Shot& shot) {
  SurfaceLook look;
  look.to_sun = world.to_sun;
  look.once = colours::kWorked;
  look.twice = colours::kWorkedTwice;
  look.thrice = colours::kWorkedThrice;
  look.missed = colours::kUnworked;
  look.shading = 1.0F;
  if (shot.surroundings == Surroundings::kBlock) return look;
  look.grain = 1.0F;
  look.fade_centre_W = shot.centre_W.cast<float>();
  look.fade_from_m = kFadeFrom_m;
  look.fade_to_m = kFadeTo_m;
  look.fade = colours::kSky;
  return look;
}

void paint_sky(const Canvas& canvas, const Typeface& typeface, const Box& box) {
  Sheet sky;
  // From the haze on the horizon to a deeper blue.
  constexpr int kBands = 48;
  constexpr Rgba kZenith{150, 186, 214};
  for (int i = 0; i < kBands; ++i) {
    const double share = (i + 0.5) / kBands;
    fill_box(sky, {box.x, box.y + box.height * i / kBands, box.width, box.height / kBands + 1.0},
             mix(kZenith, colours::kSky, std::min(1.0, 2.4 * share)));
  }
  look_through(box, canvas);
  paint(sky, typeface, canvas);
  look_through(box, canvas);
  glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace

World::World(const PictureScene& drawn, const Relief& stretched, const Eigen::Vector3f& sun)
    : scene(drawn),
      relief(stretched),
      to_sun(sun),
      body(body_mesh(drawn.vehicle).mesh),
      furrows(drawn, stretched),
      obstacles(upload(obstacles_of(drawn, stretched))),
      obstacle_shadows(upload(obstacle_shadows_of(drawn, stretched, sun))) {}

Shot::Shot(const World& world, const FieldView& from, Surroundings around, const RunSample* sample)
    : Shot(world, from, around, sample, vehicle_of(world, sample)) {}

Shot::Shot(const World& world, const FieldView& from, Surroundings around, const RunSample* sample,
           const Mesh& machine_D)
    : view(from),
      surroundings(around),
      now_s(sample != nullptr ? sample->time_s : std::numeric_limits<double>::infinity()),
      centre_W(sample != nullptr ? Point2(sample->p_WB.head<2>()) : from.block.centre()),
      ground(upload(ground_of(world, from, around, centre_W))),
      sides(upload(sides_of(world, from, around))),
      vehicle(upload(machine_D)),
      vehicle_shadow(upload(vehicle_shadow_of(world, sample, machine_D))) {}

void paint_world(const Canvas& canvas, const Typeface& typeface, const World& world,
                 const Shot& shot, const SurfaceCoverage& coverage, const Sheet& lines) {
  const Camera& camera = shot.view.camera;
  const Box& box = camera.view_px;
  const Eigen::Matrix4f clip = clip_from_D(camera);
  FurrowLook furrows{shot.now_s, shot.centre_W, 0.0, 0.0};
  Extent extent = shot.view.block;
  if (shot.surroundings == Surroundings::kSky) {
    paint_sky(canvas, typeface, box);
    furrows.fade_from_m = kFadeFrom_m;
    furrows.fade_to_m = kFadeTo_m;
    const Point2 reach = Point2::Constant(kFadeTo_m);
    extent = overlap(extent, {shot.centre_W - reach, shot.centre_W + reach});
  }
  look_through(box, canvas);
  paint_surface(canvas, shot.ground, clip, coverage, look_of(world, shot));
  paint_solids(canvas, shot.sides, clip, camera.eye_D, world.to_sun);
  world.furrows.paint(canvas, clip, extent, furrows);
  paint(lines, typeface, canvas, true);
  look_through(box, canvas);
  paint_shadows(canvas, world.obstacle_shadows, clip);
  paint_shadows(canvas, shot.vehicle_shadow, clip);
  paint_solids(canvas, world.obstacles, clip, camera.eye_D, world.to_sun);
  paint_solids(canvas, shot.vehicle, clip, camera.eye_D, world.to_sun);
  look_at_page();
}

namespace {

// Places in D as pixels with depth, those behind the camera left out.
std::vector<Point3> seen(const Camera& camera, const std::vector<Point3>& line_D) {
  std::vector<Point3> line;
  line.reserve(line_D.size());
  for (const Point3& p_D : line_D) {
    const Point3 pixel = pixel_of(camera, p_D);
    // Behind the camera there are no pixels.
    if (pixel.z() > -1.0 && pixel.z() < 1.0) line.push_back(pixel);
  }
  return thinned(line, 0.5);
}

}  // namespace

void draw_boundaries(Sheet& lines, const PictureScene& scene, const FieldView& view,
                     double width_px) {
  const double lift_m = 0.001 * view.block.size().maxCoeff();
  constexpr Rgba kDraped{250, 250, 246};
  const Extent drawn = grown(view.block, scene.terrain.cell_m);
  const auto near = [&](const Point3& p_D) {
    const Point2 p_W = p_D.head<2>();
    return (p_W.array() >= drawn.low.array()).all() && (p_W.array() <= drawn.high.array()).all();
  };
  const auto ring = [&](const Ring& points_W) {
    const auto line =
        draped(scene.terrain, view.relief, points_W, true, scene.terrain.cell_m, lift_m);
    // From leg to leg, as some lie behind the camera.
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Point3& from = line[i];
      const Point3& to = line[(i + 1) % line.size()];
      if (!near(from) && !near(to)) continue;
      stroke(lines, seen(view.camera, {from, to}), width_px, kDraped);
    }
  };
  ring(scene.field.boundary);
  for (const Ring& hole : scene.field.holes) ring(hole);
}

}  // namespace headland

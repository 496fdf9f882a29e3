// The field in three dimensions: ground, furrows, what stands on it, the machine.
#pragma once

#include "render/field_view.h"
#include "render/furrows.h"
#include "render/terrain_surface.h"
#include "render/vehicle_mesh.h"

namespace headland {

// What stays from moment to moment, on the graphics side. Refers to the scene.
struct World {
  World(const PictureScene& scene, const Relief& relief, const Eigen::Vector3f& to_sun);
  const PictureScene& scene;
  Relief relief;
  Eigen::Vector3f to_sun;
  Mesh body;  // the machine's, in frame B
  Furrows furrows;
  GlTriangles obstacles;
  GlTriangles obstacle_shadows;
};

// How the ground ends: as a cut block of earth, or fading into a sky.
enum class Surroundings { kBlock, kSky };

// One view of it at one moment, on the graphics side. Without a sample there is no machine.
struct Shot {
  Shot(const World& world, const FieldView& view, Surroundings surroundings,
       const RunSample* sample);
  FieldView view;
  Surroundings surroundings;
  double now_s;
  Eigen::Vector2d centre_W;  // of what is near
  GlTriangles ground;
  GlTriangles sides;
  GlTriangles vehicle;
  GlTriangles vehicle_shadow;

 private:
  Shot(const World& world, const FieldView& view, Surroundings surroundings,
       const RunSample* sample, const Mesh& machine_D);
};

// Into the view's window; `lines` (places with depth) lie on the ground and are hidden by what
// stands before them.
void paint_world(const Canvas& canvas, const Typeface& typeface, const World& world,
                 const Shot& shot, const SurfaceCoverage& coverage, const Sheet& lines);

// The boundary and the holes' rims as such lines.
void draw_boundaries(Sheet& lines, const PictureScene& scene, const FieldView& view,
                     double width_px);

}  // namespace headland

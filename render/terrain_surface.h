// The terrain's surface on the picture: its light, its coverage, its contours.
#pragma once

#include "render/camera.h"
#include "render/coverage_classes.h"
#include "render/mesh.h"
#include "render/palette.h"

namespace headland {

// Unit vector to the sun: from north-west, the way relief on maps is lit, and for a camera that
// looks along `heading_rad`, from its left and a little behind it.
Eigen::Vector3f map_sun();
Eigen::Vector3f sun_for(double heading_rad);

struct SurfaceLook {
  Rgba once;
  Rgba twice;
  Rgba thrice;
  Rgba missed;
  Eigen::Vector3f to_sun = map_sun();
  float shading = 0.8F;
  float grain = 0.0F;  // strength of the soil's unevenness as seen from close by; 0: even colours
  float contour_step_D = 0.0F;  // 0: none
  Rgba contour{60, 50, 40, 110};
  // Ground farther than fade_to_m from the centre has the colour `fade`; 0: no fading.
  Eigen::Vector2f fade_centre_W = Eigen::Vector2f::Zero();
  float fade_from_m = 0.0F;
  float fade_to_m = 0.0F;
  Rgba fade;
};

// Coverage on the graphics side; an empty raster is no coverage anywhere.
class SurfaceCoverage {
 public:
  explicit SurfaceCoverage(const CoverageClasses& classes);

 private:
  friend void paint_surface(const Canvas& canvas, const GlTriangles& surface,
                            const Eigen::Matrix4f& clip, const SurfaceCoverage& coverage,
                            const SurfaceLook& look);
  Eigen::Vector2f origin_W_;
  Eigen::Vector2f size_m_;
  GlTexture texture_;
};

// Paints a relief_mesh through `clip` into the current viewport, with depth.
void paint_surface(const Canvas& canvas, const GlTriangles& surface, const Eigen::Matrix4f& clip,
                   const SurfaceCoverage& coverage, const SurfaceLook& look);

// Paints solid bodies likewise, as seen from `eye_D`.
void paint_solids(const Canvas& canvas, const GlTriangles& solids, const Eigen::Matrix4f& clip,
                  const Eigen::Vector3d& eye_D, const Eigen::Vector3f& to_sun);

// The shadow that a body casts on the plane through p_D with the given normal, as a flat mesh.
Mesh shadow_mesh(const Mesh& body, const Eigen::Vector3d& p_D, const Eigen::Vector3d& normal_D,
                 const Eigen::Vector3f& to_sun);

// Paints such shadows; where several fall the ground is darkened once.
void paint_shadows(const Canvas& canvas, const GlTriangles& shadows, const Eigen::Matrix4f& clip);

}  // namespace headland

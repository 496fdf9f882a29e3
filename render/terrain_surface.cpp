#include "render/terrain_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace headland {
namespace {

constexpr std::array<std::uint8_t, 4> kNoCoverage{};

}  // namespace

Eigen::Vector3f map_sun() { return Eigen::Vector3f(-1.0F, 1.0F, 1.3F).normalized(); }

Eigen::Vector3f sun_for(double heading_rad) {
  constexpr double kLeft_rad = 2.0;
  const double azimuth = heading_rad + kLeft_rad;
  return Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.95).normalized().cast<float>();
}

SurfaceCoverage::SurfaceCoverage(const CoverageClasses& classes)
    : origin_W_(classes.origin_W.cast<float>()),
      size_m_(classes.size_m.cast<float>().cwiseMax(1e-6F)),
      texture_(std::max(classes.columns, 1), std::max(classes.rows, 1), 4,
               classes.shares.empty() ? std::span<const std::uint8_t>(kNoCoverage)
                                      : std::span<const std::uint8_t>(classes.shares),
               true) {}

void paint_surface(const Canvas& canvas, const GlTriangles& surface, const Eigen::Matrix4f& clip,
                   const SurfaceCoverage& coverage, const SurfaceLook& look) {
  const GlProgram& program = canvas.programs.terrain;
  program.use();
  program.set("clip_from_D", clip);
  program.set("to_sun", look.to_sun);
  program.set("shading", look.shading);
  program.set("grain", look.grain);
  program.set("classes_origin", coverage.origin_W_);
  program.set("classes_size", coverage.size_m_);
  program.set("once", look.once);
  program.set("twice", look.twice);
  program.set("thrice", look.thrice);
  program.set("missed", look.missed);
  program.set("contour_step", look.contour_step_D);
  program.set("contour_colour", look.contour);
  program.set("fade_centre", look.fade_centre_W);
  program.set("fade_from_to", Eigen::Vector2f(look.fade_from_m, look.fade_to_m));
  program.set("fade_colour", look.fade);
  coverage.texture_.bind();
  glEnable(GL_DEPTH_TEST);
  // Lines that lie on the surface win against it.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 1.0F);
  surface.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void paint_solids(const Canvas& canvas, const GlTriangles& solids, const Eigen::Matrix4f& clip,
                  const Eigen::Vector3d& eye_D, const Eigen::Vector3f& to_sun) {
  const GlProgram& program = canvas.programs.solid;
  program.use();
  program.set("clip_from_D", clip);
  program.set("to_sun", to_sun);
  program.set("eye_D", Eigen::Vector3f(eye_D.cast<float>()));
  glEnable(GL_DEPTH_TEST);
  solids.draw();
}

Mesh shadow_mesh(const Mesh& body, const Eigen::Vector3d& p_D, const Eigen::Vector3d& normal_D,
                 const Eigen::Vector3f& to_sun) {
  const Eigen::Vector3f normal = normal_D.normalized().cast<float>();
  const Eigen::Vector3f ray = to_sun / to_sun.dot(normal);
  const Eigen::Vector3f foot = p_D.cast<float>();
  Mesh shadow = body;
  for (MeshVertex& vertex : shadow.vertices) {
    vertex.p -= ray * std::max(0.0F, (vertex.p - foot).dot(normal));
  }
  return shadow;
}

void paint_shadows(const Canvas& canvas, const GlTriangles& shadows, const Eigen::Matrix4f& clip) {
  constexpr Rgba kShadow{20, 18, 24, 105};
  const GlProgram& program = canvas.programs.shadow;
  program.use();
  program.set("clip_from_D", clip);
  program.set("shadow", kShadow);
  // Each pixel is darkened once, however many faces fall on it.
  glClear(GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  // The ground is not quite the plane.
  glPolygonOffset(-4.0F, -4.0F);
  shadows.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_STENCIL_TEST);
}

}  // namespace headland

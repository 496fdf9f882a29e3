#include "render/camera.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

using Point = Eigen::Vector3d;

// Rows: right, down, forward of the camera.
Eigen::Matrix3d camera_axes(const Point& forward) {
  const Point right = forward.cross(Point::UnitZ()).normalized();
  Eigen::Matrix3d axes;
  axes.row(0) = right;
  axes.row(1) = forward.cross(right);
  axes.row(2) = forward;
  return axes;
}

double depth_of(const Camera& camera, double forward_m) {
  const double span = camera.far_m - camera.near_m;
  return (camera.far_m + camera.near_m) / span -
         2.0 * camera.far_m * camera.near_m / (span * forward_m);
}

}  // namespace

MapCamera fit_map(const Extent& wanted, const Extent& available, const Box& view_px) {
  const Eigen::Vector2d view(view_px.width, view_px.height);
  const double px_per_m = view.cwiseQuotient(wanted.size()).minCoeff();
  const Eigen::Vector2d reach = 0.5 * view / px_per_m;
  Extent window = overlap({wanted.centre() - reach, wanted.centre() + reach}, available);
  // Whole pixels keep the window's frame sharp.
  const Eigen::Vector2d size_px = (window.size() * px_per_m).array().floor();
  const Eigen::Vector2d centre = window.centre();
  window = {centre - 0.5 * size_px / px_per_m, centre + 0.5 * size_px / px_per_m};
  const Eigen::Vector2d corner =
      (Eigen::Vector2d(view_px.x, view_px.y) + 0.5 * (view - size_px)).array().floor();
  return {{corner.x(), corner.y(), size_px.x(), size_px.y()}, window, px_per_m};
}

Camera fit_camera(std::span<const Point> points_D, double heading_rad, double down_rad,
                  double field_of_view_rad, const Box& view_px) {
  const Point forward(std::cos(down_rad) * std::cos(heading_rad),
                      std::cos(down_rad) * std::sin(heading_rad), -std::sin(down_rad));
  const Eigen::Matrix3d axes = camera_axes(forward);
  Camera camera;
  camera.view_px = view_px;
  camera.focal_px =
      0.5 * std::max(view_px.width, view_px.height) / std::tan(0.5 * field_of_view_rad);
  camera.centre_px = {view_px.x + 0.5 * view_px.width, view_px.y + 0.5 * view_px.height};

  // Each point bounds the eye from both sides across and up: |x - ex| <= t (z - ez), which is
  // linear in the eye's place (ex, ey, ez) along the camera's axes. The extreme lines meet at the
  // nearest eye of each direction; the farther of the two serves both.
  const double tan_x = 0.5 * view_px.width / camera.focal_px;
  const double tan_y = 0.5 * view_px.height / camera.focal_px;
  Eigen::Vector2d most = Eigen::Vector2d::Constant(-1e300);
  Eigen::Vector2d least = Eigen::Vector2d::Constant(1e300);
  double nearest = 1e300;
  double farthest = -1e300;
  for (const Point& p_D : points_D) {
    const Point p = axes * p_D;
    const Eigen::Vector2d cone(tan_x * p.z(), tan_y * p.z());
    most = most.cwiseMax(p.head<2>() - cone);
    least = least.cwiseMin(p.head<2>() + cone);
    nearest = std::min(nearest, p.z());
    farthest = std::max(farthest, p.z());
  }
  const Eigen::Vector2d eye_xy = 0.5 * (most + least);
  const double eye_z =
      std::min((least.x() - most.x()) / (2.0 * tan_x), (least.y() - most.y()) / (2.0 * tan_y));
  const Point eye(eye_xy.x(), eye_xy.y(), eye_z);
  camera.eye_D = axes.transpose() * eye;
  camera.target_D = camera.eye_D + forward * std::max(1.0, 0.5 * (nearest + farthest) - eye_z);
  // Room for what stands on the points; a ratio that 24 bits of depth resolve.
  camera.far_m = 1.5 * (farthest - eye_z) + 10.0;
  camera.near_m = std::max(0.3 * (nearest - eye_z), 1e-3 * camera.far_m);
  return camera;
}

Point pixel_of(const Camera& camera, const Point& p_D) {
  const Point p = camera_axes((camera.target_D - camera.eye_D).normalized()) * (p_D - camera.eye_D);
  return {camera.centre_px.x() + camera.focal_px * p.x() / p.z(),
          camera.centre_px.y() + camera.focal_px * p.y() / p.z(), depth_of(camera, p.z())};
}

Eigen::Vector2d pixel_of(const MapCamera& camera, const Eigen::Vector2d& p_W) {
  return {camera.view_px.x + camera.px_per_m * (p_W.x() - camera.window.low.x()),
          camera.view_px.y + camera.px_per_m * (camera.window.high.y() - p_W.y())};
}

Eigen::Matrix4f clip_from_D(const Camera& camera) {
  const Eigen::Matrix3d axes = camera_axes((camera.target_D - camera.eye_D).normalized());
  const double half_width = 0.5 * camera.view_px.width;
  const double half_height = 0.5 * camera.view_px.height;
  const double span = camera.far_m - camera.near_m;
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = camera.focal_px / half_width;
  projection(0, 2) = (camera.centre_px.x() - camera.view_px.x) / half_width - 1.0;
  projection(1, 1) = -camera.focal_px / half_height;
  projection(1, 2) = 1.0 - (camera.centre_px.y() - camera.view_px.y) / half_height;
  projection(2, 2) = (camera.far_m + camera.near_m) / span;
  projection(2, 3) = -2.0 * camera.far_m * camera.near_m / span;
  projection(3, 2) = 1.0;
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = axes;
  view.topRightCorner<3, 1>() = -axes * camera.eye_D;
  return (projection * view).cast<float>();
}

Eigen::Matrix4f clip_from_D(const MapCamera& camera, double low_D, double high_D) {
  const Eigen::Vector2d centre = camera.window.centre();
  const Eigen::Vector2d size = camera.window.size();
  const double thickness = std::max(high_D - low_D, 1.0) * 1.1;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
  clip(0, 0) = 2.0 / size.x();
  clip(0, 3) = -2.0 * centre.x() / size.x();
  clip(1, 1) = 2.0 / size.y();
  clip(1, 3) = -2.0 * centre.y() / size.y();
  clip(2, 2) = -2.0 / thickness;
  clip(2, 3) = (low_D + high_D) / thickness;
  return clip.cast<float>();
}

void look_through(const Box& view_px, const Canvas& canvas) {
  const auto x = static_cast<GLint>(std::lround(view_px.x - canvas.corner_px.x()));
  const auto y =
      static_cast<GLint>(std::lround(canvas.corner_px.y() + canvas.tile_px.y() - view_px.bottom()));
  const auto width = static_cast<GLsizei>(std::lround(view_px.width));
  const auto height = static_cast<GLsizei>(std::lround(view_px.height));
  glViewport(x, y, width, height);
  glScissor(x, y, width, height);
  glEnable(GL_SCISSOR_TEST);
}

void look_at_page() { glDisable(GL_SCISSOR_TEST); }

}  // namespace headland

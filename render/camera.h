// From places in the drawn world to pixels.
#pragma once

#include <Eigen/Core>
#include <span>

#include "render/relief.h"
#include "render/sheet.h"

namespace headland {

// Looking straight down, north up. `view_px` is the map's window in the picture, whose upper left
// corner shows (window.low.x, window.high.y).
struct MapCamera {
  Box view_px;
  Extent window;
  double px_per_m = 1.0;
};

// The largest window around `wanted` inside `available` that fills `view_px` as far as it can,
// at the largest scale that shows all of `wanted`; the view shrinks to the window, centred.
MapCamera fit_map(const Extent& wanted, const Extent& available, const Box& view_px);

// Pinhole camera in frame D (render/relief.h), upright, square pixels. `view_px` is its window in
// the picture.
struct Camera {
  Eigen::Vector3d eye_D = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_D = Eigen::Vector3d::UnitX();
  double focal_px = 1000.0;
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  // where the target is seen
  double near_m = 0.1;
  double far_m = 1000.0;
  Box view_px;
};

// A camera that looks along `heading_rad` (counter-clockwise from +x) and `down_rad` below the
// horizon and just sees all the points in its view, from as near as that allows.
Camera fit_camera(std::span<const Eigen::Vector3d> points_D, double heading_rad, double down_rad,
                  double field_of_view_rad, const Box& view_px);

// Pixel (x right, y down from the picture's upper left corner) and depth as in SheetVertex.
Eigen::Vector3d pixel_of(const Camera& camera, const Eigen::Vector3d& p_D);
Eigen::Vector2d pixel_of(const MapCamera& camera, const Eigen::Vector2d& p_W);

// For shaders, into a viewport of the size of view_px.
Eigen::Matrix4f clip_from_D(const Camera& camera);
Eigen::Matrix4f clip_from_D(const MapCamera& camera, double low_D, double high_D);

// Limits drawing to a window of the picture, and to the whole picture again.
void look_through(const Box& view_px, const Canvas& canvas);
void look_at_page();

}  // namespace headland

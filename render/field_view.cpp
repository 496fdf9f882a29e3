#include "render/field_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

using Point = Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

// Relief is seen well when its height is this share of the field's size.
constexpr double kWellSeenRelief = 0.10;
constexpr double kMaxExaggeration = 5.0;
constexpr double kLevelRelief = 0.002;  // share below which stretching would show mere noise

double exaggeration_for(double relief_m, double size_m) {
  if (relief_m < kLevelRelief * size_m) return 1.0;
  return std::clamp(std::floor(kWellSeenRelief * size_m / relief_m), 1.0, kMaxExaggeration);
}

// Everything that has to be in the picture.
std::vector<Point> outline(const PictureScene& scene, const FieldView& view) {
  const Eigen::Vector2d& low = view.block.low;
  const Eigen::Vector2d& high = view.block.high;
  const std::vector<Eigen::Vector2d> corners = {
      low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  const double spacing_m = 0.05 * view.block.size().maxCoeff();
  std::vector<Point> points = draped(scene.terrain, view.relief, corners, true, spacing_m, 0.0);
  for (const Eigen::Vector2d& p : corners) points.emplace_back(p.x(), p.y(), view.bottom_D);
  for (const Point& p :
       draped(scene.terrain, view.relief, scene.field.boundary, true, spacing_m, 0.0)) {
    points.push_back(p);
  }
  for (const Obstacle& obstacle : scene.field.obstacles) {
    for (const Eigen::Vector2d& end_W :
         {obstacle.p_W, Eigen::Vector2d(obstacle.p_W + obstacle.run_W)}) {
      points.push_back(on_ground(scene.terrain, view.relief, end_W) +
                       Point(0.0, 0.0, obstacle.height_m));
    }
  }
  return points;
}

// Of the boundary as seen, positive when its upper side is.
double seen_area_px2(const PictureScene& scene, const FieldView& view, const Camera& camera) {
  Ring seen;
  const double spacing_m = 0.05 * view.block.size().maxCoeff();
  for (const Point& p :
       draped(scene.terrain, view.relief, scene.field.boundary, true, spacing_m, 0.0)) {
    const Point pixel = pixel_of(camera, p);
    seen.emplace_back(pixel.x(), -pixel.y());
  }
  return signed_area_m2(seen);
}

}  // namespace

Page view_page(const PictureSize& size) {
  constexpr double kCloseUpUnits = 470.0;
  return page_of(size, kCloseUpUnits);
}

FieldView field_view(const PictureScene& scene, const Page& page,
                     std::optional<double> exaggeration) {
  constexpr double kMarginShare = 0.03;
  constexpr double kThickness = 0.035;
  constexpr double kDown_rad = 41.0 * kPi / 180.0;
  constexpr double kFieldOfView_rad = 26.0 * kPi / 180.0;
  FieldView view;
  const Extent terrain = extent_of(scene.terrain);
  const Extent field = extent_of(scene.field.boundary);
  const double size_m = field.size().maxCoeff();
  view.block = overlap(grown(field, std::max(2.0, kMarginShare * size_m)), terrain);
  const HeightRange heights = height_range(scene.terrain, view.block);
  view.relief = {heights.low_m,
                 exaggeration.value_or(exaggeration_for(heights.high_m - heights.low_m, size_m))};
  view.bottom_D = -kThickness * size_m;

  const std::vector<Point> points = outline(scene, view);
  double best = -1e300;
  constexpr int kHeadings = 8;
  for (int k = 0; k < kHeadings; ++k) {
    // A little aside, so that no edge of the block lies level; north-up comes first and wins ties.
    const double heading = 0.5 * kPi + 0.35 + 2.0 * kPi * k / kHeadings;
    const Camera camera = fit_camera(points, heading, kDown_rad, kFieldOfView_rad, page.main);
    constexpr double kFamiliarNorth = 0.15;
    const double area =
        seen_area_px2(scene, view, camera) * (1.0 + kFamiliarNorth * std::sin(heading));
    if (area <= best) continue;
    best = area;
    view.camera = camera;
    view.heading_rad = heading;
  }
  return view;
}

const RunSample* last_pose(const RunRecord& run) {
  const auto last = std::find_if(run.samples.rbegin(), run.samples.rend(),
                                 [](const RunSample& sample) { return sample.p_WB.allFinite(); });
  return last == run.samples.rend() ? nullptr : &*last;
}

namespace {

// From where a vehicle is looked at.
struct Viewpoint {
  double heading_rad = 0.0;
  double down_rad = 0.0;
  double field_of_view_rad = 0.0;
  double ahead_m = 0.0;  // of ground before the vehicle that is to be seen
  std::optional<Relief> relief{};
};

FieldView view_of_vehicle(const PictureScene& scene, const RunSample& sample, const Viewpoint& from,
                          const Box& view_px) {
  constexpr double kReach_m = 160.0;
  // Beyond this width the ends of the implement may leave the picture: the vehicle is the subject.
  constexpr double kWidest_m = 10.0;
  const Body& body = scene.vehicle.body;
  const Extent terrain = extent_of(scene.terrain);
  const Eigen::Vector2d p_W =
      Eigen::Vector2d(sample.p_WB.head<2>()).cwiseMax(terrain.low).cwiseMin(terrain.high);
  FieldView view;
  const Extent near{p_W - Eigen::Vector2d::Constant(kReach_m),
                    p_W + Eigen::Vector2d::Constant(kReach_m)};
  view.block = overlap(near, terrain);
  view.relief = from.relief.value_or(Relief{sample.p_WB.z(), 1.0});

  // Corners of the hull, and of the implement as far as it is not much wider.
  const Eigen::Rotation2Dd turn(sample.yaw_rad);
  std::vector<Point> points;
  const auto add_corners = [&](double x, double half_width_m, double height_m) {
    for (const double y : {-half_width_m, half_width_m}) {
      const Eigen::Vector2d corner = p_W + turn * Eigen::Vector2d(x, y);
      const Point foot = on_ground(scene.terrain, view.relief, corner);
      points.push_back(foot - Point(0.0, 0.0, 0.2));
      points.push_back(foot + Point(0.0, 0.0, height_m));
    }
  };
  constexpr double kAround_m = 0.35;
  constexpr double kImplementHeight_m = 0.9;
  add_corners(-body.rear_overhang_m, 0.5 * body.width_m + kAround_m, body.height_m + kAround_m);
  add_corners(body.length_m - body.rear_overhang_m + kAround_m, 0.5 * body.width_m + kAround_m,
              body.height_m + kAround_m);
  add_corners(scene.vehicle.implement.x_B_m,
              0.5 * std::min(kWidest_m, scene.vehicle.implement.working_width_m) + kAround_m,
              kImplementHeight_m);
  if (from.ahead_m > 0.0) {
    // Ground around the vehicle, more of it ahead.
    constexpr double kBeside_m = 1.5;
    const double half_m =
        0.5 * std::max(body.width_m, std::min(kWidest_m, scene.vehicle.implement.working_width_m)) +
        kBeside_m;
    add_corners(-body.rear_overhang_m - 1.5 * kBeside_m, half_m, 0.0);
    add_corners(body.length_m + from.ahead_m, half_m, 0.0);
  }
  view.heading_rad = from.heading_rad;
  view.camera =
      fit_camera(points, view.heading_rad, from.down_rad, from.field_of_view_rad, view_px);
  view.camera.far_m = 2.0 * kReach_m + 100.0;
  view.camera.near_m = std::max(0.2, 0.2 * (view.camera.target_D - view.camera.eye_D).norm());
  return view;
}

}  // namespace

FieldView close_up(const PictureScene& scene, const RunSample& sample, const Box& view_px) {
  constexpr double kAside_rad = -0.66;
  return view_of_vehicle(scene, sample,
                         {sample.yaw_rad + kPi + kAside_rad, 17.0 * kPi / 180.0, 34.0 * kPi / 180.0,
                          0.0, std::nullopt},
                         view_px);
}

FieldView chase_view(const PictureScene& scene, const RunSample& sample, double heading_rad,
                     const Box& view_px, std::optional<Relief> relief) {
  constexpr double kAhead_m = 14.0;
  FieldView view = view_of_vehicle(
      scene, sample, {heading_rad, 21.0 * kPi / 180.0, 50.0 * kPi / 180.0, kAhead_m, relief},
      view_px);
  // Behind a rise the camera stands on it.
  constexpr double kAboveGround_m = 1.2;
  Eigen::Vector3d& eye_D = view.camera.eye_D;
  const Extent terrain = extent_of(scene.terrain);
  const Eigen::Vector2d eye_W =
      Eigen::Vector2d(eye_D.head<2>()).cwiseMax(terrain.low).cwiseMin(terrain.high);
  eye_D.z() =
      std::max(eye_D.z(), on_ground(scene.terrain, view.relief, eye_W).z() + kAboveGround_m);
  return view;
}

double trailing_heading_rad(const RunRecord& run, double time_s) {
  constexpr double kMemory_s = 2.5;
  const auto& samples = run.samples;
  const auto after =
      std::upper_bound(samples.begin(), samples.end(), time_s,
                       [](double time, const RunSample& sample) { return time < sample.time_s; });
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (auto i = after; i != samples.begin();) {
    --i;
    const double age_s = time_s - i->time_s;
    if (age_s > 3.0 * kMemory_s) break;
    if (!std::isfinite(i->yaw_rad)) continue;
    sum +=
        std::exp(-age_s / kMemory_s) * Eigen::Vector2d(std::cos(i->yaw_rad), std::sin(i->yaw_rad));
  }
  return std::atan2(sum.y(), sum.x());
}

}  // namespace headland

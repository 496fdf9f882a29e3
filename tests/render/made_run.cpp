#include "tests/render/made_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

// By the even-odd rule.
bool in_ring(const Ring& ring, const Point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& a = ring[i];
    const Point2& b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
      inside = !inside;
    }
  }
  return inside;
}

CoverageRaster empty_raster(const Field& field, double cell_m, double margin_m) {
  Point2 low = field.boundary.front();
  Point2 high = low;
  for (const Point2& p : field.boundary) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  CoverageRaster raster;
  raster.cell_m = cell_m;
  raster.origin_W = low - Point2(margin_m, margin_m);
  raster.columns = static_cast<int>(std::lround((high.x() - low.x() + 2 * margin_m) / cell_m));
  raster.rows = static_cast<int>(std::lround((high.y() - low.y() + 2 * margin_m) / cell_m));
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const Point2 p = raster.origin_W + cell_m * Point2(i + 0.5, j + 0.5);
      bool in = in_ring(field.boundary, p);
      for (const Ring& hole : field.holes) in = in && !in_ring(hole, p);
      raster.in_field.push_back(in ? 1 : 0);
    }
  }
  raster.times.assign(raster.in_field.size(), 0);
  return raster;
}

Vehicle made_vehicle(double working_width_m) {
  Vehicle vehicle;
  vehicle.name = "made tractor";
  vehicle.body.length_m = 3.9;
  vehicle.body.width_m = 1.3;
  vehicle.body.height_m = 2.5;
  vehicle.body.rear_overhang_m = 0.8;
  vehicle.body.ground_clearance_m = 0.45;
  vehicle.rear.track_m = 1.6;
  vehicle.rear.radius_m = 0.75;
  vehicle.rear.width_m = 0.45;
  vehicle.front = vehicle.rear;
  vehicle.front.x_B_m = 2.2;
  vehicle.front.radius_m = 0.5;
  vehicle.front.width_m = 0.3;
  vehicle.implement.name = "harrow";
  vehicle.implement.x_B_m = -1.8;
  vehicle.implement.working_width_m = working_width_m;
  return vehicle;
}

double rolling_height_m(const Point2& p, double size_m) {
  const double k = 2.0 * std::numbers::pi / size_m;
  return 212.0 + 0.025 * size_m * std::sin(k * p.x()) * std::cos(0.8 * k * p.y()) +
         0.012 * size_m * std::sin(2.3 * k * p.y() + 1.0) + 0.02 * p.y();
}

PathSegment straight(const Point2& from, const Point2& to, PathKind kind, int manoeuvre) {
  PathSegment segment;
  segment.kind = kind;
  segment.implement_down = kind == PathKind::kSwath;
  segment.manoeuvre = manoeuvre;
  const int pieces = std::max(1, static_cast<int>((to - from).norm() / kPathSpacing_m));
  for (int i = 0; i <= pieces; ++i) {
    const Point2 along = to - from;
    segment.points.push_back({from + along * i / pieces, std::atan2(along.y(), along.x()), 0.0});
  }
  return segment;
}

// Half circle, from heading up or down.
PathSegment half_turn(const Point2& from, const Point2& to, bool over_the_top, int manoeuvre) {
  PathSegment segment;
  segment.kind = PathKind::kUTurn;
  segment.manoeuvre = manoeuvre;
  const Point2 centre = 0.5 * (from + to);
  const double radius = 0.5 * (to - from).norm();
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::numbers::pi * (1.0 - i / 24.0);
    const double sign = over_the_top ? 1.0 : -1.0;
    const Point2 p = centre + radius * Point2(std::cos(angle), sign * std::sin(angle));
    segment.points.push_back({p, sign * (angle - 0.5 * std::numbers::pi), 0.0});
  }
  return segment;
}

void drive(MadeRun& made, const std::vector<std::size_t>& left_out) {
  constexpr double kSpeed_mps = 1.5;
  RunSample sample;
  for (std::size_t s = 0; s < made.path.segments.size(); ++s) {
    const PathSegment& segment = made.path.segments[s];
    for (const PathPoint& point : segment.points) {
      const SurfacePoint ground = surface_at(made.terrain, point.p_W.x(), point.p_W.y());
      const Point2 ahead(std::cos(point.heading_rad), std::sin(point.heading_rad));
      const Point2 left(-ahead.y(), ahead.x());
      const double step_m =
          made.run.samples.empty() ? 0.0 : (point.p_W - sample.p_WB.head<2>()).norm();
      sample.travel_m += step_m;
      sample.time_s += step_m / kSpeed_mps;
      sample.p_WB = {point.p_W.x(), point.p_W.y(), ground.height_m};
      sample.yaw_rad = point.heading_rad;
      sample.pitch_rad = std::atan(ground.gradient.dot(ahead));
      sample.roll_rad = std::atan(ground.gradient.dot(left));
      sample.segment = static_cast<int>(s);
      sample.implement_down = segment.implement_down;
      sample.battery_power_w = kSpeed_mps * (900.0 + 16000.0 * ground.gradient.dot(ahead)) +
                               (segment.implement_down ? 2500.0 : 600.0);
      sample.wheel_angle_rad.fill(sample.travel_m);
      made.run.samples.push_back(sample);
      if (!segment.implement_down) continue;
      const Point2 middle = point.p_W + made.vehicle.implement.x_B_m * ahead;
      const Point2 half = 0.5 * made.vehicle.implement.working_width_m * left;
      made.run.footprints.push_back({middle + half, middle - half, sample.time_s, sample.travel_m,
                                     &point == &segment.points.front()});
    }
    const bool out = std::find(left_out.begin(), left_out.end(), s) != left_out.end();
    if (segment.implement_down && !out) {
      cover_strip(made.coverage, segment.points.front().p_W, segment.points.back().p_W,
                  1.04 * made.vehicle.implement.working_width_m);
    }
  }
  made.run.distance_m = sample.travel_m;
  made.run.duration_s = sample.time_s;
}

}  // namespace

void cover_strip(CoverageRaster& coverage, const Point2& from_W, const Point2& to_W,
                 double width_m) {
  const double length_m = (to_W - from_W).norm();
  const Point2 along = (to_W - from_W) / length_m;
  for (int j = 0; j < coverage.rows; ++j) {
    for (int i = 0; i < coverage.columns; ++i) {
      const Point2 p = coverage.origin_W + coverage.cell_m * Point2(i + 0.5, j + 0.5) - from_W;
      const double across_m = along.x() * p.y() - along.y() * p.x();
      if (along.dot(p) < 0.0 || along.dot(p) > length_m || std::abs(across_m) > 0.5 * width_m) {
        continue;
      }
      ++coverage.times[static_cast<std::size_t>(j) * static_cast<std::size_t>(coverage.columns) +
                       static_cast<std::size_t>(i)];
    }
  }
}

MadeRun level_run(double width_m, double height_m, double margin_m) {
  MadeRun made;
  made.field.name = "Level field";
  made.field.boundary = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  made.terrain.columns = static_cast<int>(width_m + 2.0 * margin_m) + 1;
  made.terrain.rows = static_cast<int>(height_m + 2.0 * margin_m) + 1;
  made.terrain.origin_W = {-margin_m, -margin_m};
  made.terrain.height_m.assign(
      static_cast<std::size_t>(made.terrain.columns) * static_cast<std::size_t>(made.terrain.rows),
      100.0);
  made.vehicle = made_vehicle(3.0);
  made.coverage = empty_raster(made.field, 0.25, 3.0);
  return made;
}

MadeRun rolling_run(double size_m, double working_width_m) {
  MadeRun made;
  const double s = size_m;
  made.field.name = "Äußere Breite";
  made.field.boundary = {{0.0, 0.0},          {0.55 * s, -0.08 * s}, {s, 0.03 * s},
                         {1.08 * s, 0.5 * s}, {0.9 * s, 0.85 * s},   {0.4 * s, 0.9 * s},
                         {0.05 * s, 0.7 * s}};
  made.field.holes = {
      {{0.62 * s, 0.42 * s}, {0.58 * s, 0.52 * s}, {0.68 * s, 0.58 * s}, {0.74 * s, 0.46 * s}}};
  made.field.obstacles = {{ObstacleKind::kTree, {0.25 * s, 0.35 * s}, 0.4, 8.0},
                          {ObstacleKind::kTree, {0.3 * s, 0.52 * s}, 0.3, 6.0},
                          {ObstacleKind::kPole, {0.82 * s, 0.3 * s}, 0.15, 9.0},
                          {ObstacleKind::kRock, {0.45 * s, 0.72 * s}, 1.2, 1.1}};
  constexpr double kMargin_m = 30.0;
  made.terrain.origin_W = {-kMargin_m, -0.08 * s - kMargin_m};
  made.terrain.columns = static_cast<int>(1.08 * s + 2.0 * kMargin_m) + 1;
  made.terrain.rows = static_cast<int>(0.98 * s + 2.0 * kMargin_m) + 1;
  for (int j = 0; j < made.terrain.rows; ++j) {
    for (int i = 0; i < made.terrain.columns; ++i) {
      made.terrain.height_m.push_back(
          rolling_height_m(made.terrain.origin_W + Point2(i, j), size_m));
    }
  }
  made.vehicle = made_vehicle(working_width_m);
  made.coverage = empty_raster(made.field, 0.25, working_width_m);

  const double headland_m = std::max(1.5 * working_width_m, 8.0);
  bool up = true;
  int manoeuvre = 0;
  for (double x = 0.06 * s; x < 1.0 * s; x += working_width_m, up = !up) {
    const auto reach = [&](double from, double to) {
      double y = from;
      const double step = from < to ? 0.5 : -0.5;
      while (!in_ring(made.field.boundary, {x, y})) y += step;
      return y + std::copysign(headland_m, step);
    };
    const Point2 low(x, reach(-0.1 * s, s));
    const Point2 high(x, reach(s, -0.1 * s));
    const Point2& from = up ? low : high;
    const Point2& to = up ? high : low;
    if (!made.path.segments.empty()) {
      const Point2 last = made.path.segments.back().points.back().p_W;
      const double y = up ? std::min(last.y(), from.y()) : std::max(last.y(), from.y());
      made.path.segments.push_back(straight(last, {last.x(), y}, PathKind::kTransit, manoeuvre));
      made.path.segments.push_back(half_turn({last.x(), y}, {x, y}, !up, manoeuvre));
      made.path.segments.push_back(straight({x, y}, from, PathKind::kTransit, manoeuvre));
    }
    made.path.segments.push_back(straight(from, to, PathKind::kSwath, manoeuvre++));
  }
  const std::vector<std::size_t> left_out = {16, 40};
  drive(made, left_out);
  const PathSegment& again = made.path.segments[24];
  for (int k = 0; k < 2; ++k) {
    cover_strip(made.coverage, again.points[60].p_W, again.points.back().p_W,
                1.5 * working_width_m);
  }
  return made;
}

}  // namespace headland

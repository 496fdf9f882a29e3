#include "render/vehicle_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/mesh_file.h"
#include "sim/wheel.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Point = Eigen::Vector3d;

constexpr Rgba kTyre{44, 44, 46};
constexpr Rgba kRim{222, 214, 188};
constexpr Rgba kHub{120, 116, 108};
constexpr Rgba kPlainBody{196, 70, 40};
constexpr Rgba kFrame{58, 66, 76};
constexpr Rgba kTool{150, 154, 158};

Eigen::Isometry3d moved(const Point& p) { return Eigen::Isometry3d(Eigen::Translation3d(p)); }

Rgba colour_of(const std::array<double, 3>& rgb) {
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  };
  return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

Mesh plain_body(const Body& body) {
  const double front_m = body.length_m - body.rear_overhang_m;
  return box_mesh({-body.rear_overhang_m, -0.5 * body.width_m, body.ground_clearance_m},
                  {front_m, 0.5 * body.width_m, body.height_m}, kPlainBody);
}

// The mesh of a file, stretched by the shape's factors.
MeshFile stretched_mesh(const Shape& shape) {
  MeshFile read = read_mesh(shape.mesh_file);
  Mesh& mesh = read.mesh;
  const Eigen::Vector3f factors = shape.size.cast<float>();
  for (MeshVertex& vertex : mesh.vertices) {
    vertex.p = vertex.p.cwiseProduct(factors);
    vertex.normal = vertex.normal.cwiseQuotient(factors).normalized();
    if (shape.rgb) vertex.colour = colour_of(*shape.rgb);
  }
  // A colour of its own needs no materials.
  if (shape.rgb) read.lacks.clear();
  return read;
}

void append_shape(VehicleMesh& body, const Shape& shape) {
  Mesh& mesh = body.mesh;
  const Rgba colour = shape.rgb ? colour_of(*shape.rgb) : kPlainBody;
  constexpr int kSides = 32;
  std::vector<Eigen::Vector2d> profile;
  switch (shape.kind) {
    case ShapeKind::kMesh: {
      const MeshFile read = stretched_mesh(shape);
      append(mesh, read.mesh, shape.X);
      for (const std::string& lack : read.lacks) {
        if (std::find(body.lacks.begin(), body.lacks.end(), lack) == body.lacks.end()) {
          body.lacks.push_back(lack);
        }
      }
      return;
    }
    case ShapeKind::kBox:
      append(mesh, box_mesh(-0.5 * shape.size, 0.5 * shape.size, colour), shape.X);
      return;
    case ShapeKind::kCylinder: {
      const double half_m = 0.5 * shape.size.z();
      profile = {
          {0.0, -half_m}, {shape.size.x(), -half_m}, {shape.size.x(), half_m}, {0.0, half_m}};
      break;
    }
    case ShapeKind::kSphere:
      for (int k = 0; k <= kSides / 2; ++k) {
        const double angle = std::numbers::pi * (2.0 * k / kSides - 0.5);
        profile.emplace_back(shape.size.x() * std::cos(angle), shape.size.x() * std::sin(angle));
      }
      break;
  }
  append(mesh, revolved_mesh(profile, kSides, colour), shape.X);
}

void append_wheels(Mesh& mesh, const Vehicle& vehicle, const RunSample& sample) {
  for (std::size_t i = 0; i < sample.wheel_angle_rad.size(); ++i) {
    const Axle& axle = i >= 2 ? vehicle.front : vehicle.rear;
    if (!(axle.radius_m > 0.0)) continue;
    const double left_m = (i % 2 == 0 ? 0.5 : -0.5) * axle.track_m;
    const double steer = wheel_angle_rad(vehicle, sample.steer_rad, {axle.x_B_m, left_m});
    const Eigen::Isometry3d X = moved({axle.x_B_m, left_m, axle.radius_m}) *
                                Eigen::AngleAxisd(steer, Point::UnitZ()) *
                                Eigen::AngleAxisd(sample.wheel_angle_rad[i], Point::UnitY());
    append(mesh, wheel_mesh(axle), X);
  }
}

constexpr double kRaised_m = 0.45;
constexpr double kBarHeight_m = 0.5;
constexpr double kBetweenBars_m = 0.55;

// Two cross bars with tools below; ties between the bars at their ends and `tie_y_m` from the
// middle.
Mesh bars_mesh(const Implement& implement, double tie_y_m) {
  constexpr double kHalfBar_m = 0.05;
  constexpr double kToolSpacing_m = 0.4;
  constexpr double kTie_m = 0.04;
  Mesh mesh;
  const double half_m = 0.5 * implement.working_width_m;
  const double x = implement.x_B_m;
  const double outwards = x <= 0.0 ? -1.0 : 1.0;
  const int tools = std::max(2, static_cast<int>(implement.working_width_m / kToolSpacing_m));
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  for (int bar = 0; bar < 2; ++bar) {
    const double at = x - outwards * kBetweenBars_m * (bar - 0.5);
    append(mesh,
           box_mesh({at - kHalfBar_m, -half_m, kBarHeight_m - kHalfBar_m},
                    {at + kHalfBar_m, half_m, kBarHeight_m + kHalfBar_m}, kFrame),
           here);
    for (int i = bar; i < tools; i += 2) {
      const double y = half_m * (2.0 * (i + 0.5) / tools - 1.0);
      append(mesh, bar_mesh({at, y, kBarHeight_m}, {at - 0.12, y, -0.02}, 0.025, kTool), here);
    }
  }
  const double end_m = half_m - kTie_m;
  for (const double y : {-end_m, end_m, -tie_y_m, tie_y_m}) {
    append(mesh,
           bar_mesh({x - 0.5 * kBetweenBars_m, y, kBarHeight_m},
                    {x + 0.5 * kBetweenBars_m, y, kBarHeight_m}, kTie_m, kFrame),
           here);
  }
  return mesh;
}

// Carried by two beams from the body.
void append_mounted(Mesh& mesh, const Vehicle& vehicle, bool down) {
  const double rise_m = down ? 0.0 : kRaised_m;
  const double x = vehicle.implement.x_B_m;
  const double outwards = x <= 0.0 ? -1.0 : 1.0;
  const double beam_half_m = std::min(0.35, 0.3 * vehicle.body.width_m);
  append(mesh, bars_mesh(vehicle.implement, beam_half_m), moved({0.0, 0.0, rise_m}));
  const double hitch = x <= 0.0 ? 0.5 * (vehicle.rear.x_B_m - vehicle.body.rear_overhang_m)
                                : vehicle.body.length_m - vehicle.body.rear_overhang_m;
  for (const double y : {-beam_half_m, beam_half_m}) {
    append(mesh,
           bar_mesh({hitch, y, kBarHeight_m + 0.15},
                    {x + outwards * 0.5 * kBetweenBars_m, y, kBarHeight_m + rise_m}, 0.045, kFrame),
           Eigen::Isometry3d::Identity());
  }
}

// On its own wheels, turned about the pin: drawn straight behind the vehicle, then turned.
void append_trailed(Mesh& mesh, const Vehicle& vehicle, const RunSample& sample) {
  const Implement& implement = vehicle.implement;
  const Trailing& trailing = *implement.trailing;
  const double axle_x_m = trailing.hitch_x_B_m - trailing.drawbar_length_m;
  const double half_track_m = 0.5 * trailing.track_m;
  const double rise_m = sample.implement_down ? 0.0 : kRaised_m;
  const Point pin(trailing.hitch_x_B_m, 0.0, trailing.hitch_height_m);
  const Point beam_end(axle_x_m, 0.0, std::max(kBarHeight_m + rise_m, trailing.wheel_radius_m));
  Mesh trailed;
  append(trailed, bars_mesh(implement, half_track_m), moved({0.0, 0.0, rise_m}));
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  for (const double y : {-half_track_m, half_track_m}) {
    append(trailed, bar_mesh(pin, beam_end + Point(0.0, y, 0.0), 0.05, kFrame), here);
  }
  append(trailed,
         bar_mesh({axle_x_m, -half_track_m, trailing.wheel_radius_m},
                  {axle_x_m, half_track_m, trailing.wheel_radius_m}, 0.05, kFrame),
         here);
  append(trailed, bar_mesh(beam_end, {implement.x_B_m, 0.0, kBarHeight_m + rise_m}, 0.06, kFrame),
         here);
  Axle axle;
  axle.radius_m = trailing.wheel_radius_m;
  axle.width_m = trailing.wheel_width_m;
  for (const double y : {-half_track_m, half_track_m}) {
    append(trailed, wheel_mesh(axle),
           moved({axle_x_m, y, axle.radius_m}) *
               Eigen::AngleAxisd(sample.travel_m / axle.radius_m, Point::UnitY()));
  }
  append(mesh, trailed,
         moved(pin) * Eigen::AngleAxisd(sample.hitch_angle_rad, Point::UnitZ()) * moved(-pin));
}

void append_implement(Mesh& mesh, const Vehicle& vehicle, const RunSample& sample) {
  if (!(vehicle.implement.working_width_m > 0.0)) return;
  if (vehicle.implement.trailing) {
    append_trailed(mesh, vehicle, sample);
  } else {
    append_mounted(mesh, vehicle, sample.implement_down);
  }
}

}  // namespace

VehicleMesh body_mesh(const Vehicle& vehicle) {
  VehicleMesh out;
  try {
    for (const Shape& shape : vehicle.shapes) append_shape(out, shape);
    if (vehicle.shapes.empty()) out.note = "no mesh: plain box";
  } catch (const InputError& unread) {
    out.note =
        std::filesystem::path(unread.source).filename().string() + " cannot be read: plain box";
  }
  if (!out.note.empty()) out.mesh = plain_body(vehicle.body);
  return out;
}

std::vector<std::string> vehicle_notes(const Vehicle& vehicle) {
  std::vector<std::string> notes = vehicle.notes;
  const bool told = std::any_of(notes.begin(), notes.end(),
                                [](const std::string& note) { return note.starts_with("mesh "); });
  const VehicleMesh body = body_mesh(vehicle);
  if (!body.note.empty() && !told) notes.push_back(body.note + " in the pictures");
  notes.insert(notes.end(), body.lacks.begin(), body.lacks.end());
  return notes;
}

Mesh wheel_mesh(const Axle& axle) {
  const double r = axle.radius_m;
  const double w = axle.width_m;
  constexpr int kSides = 40;
  const std::array<Eigen::Vector2d, 8> tyre = {{{0.56 * r, -0.36 * w},
                                                {0.62 * r, -0.50 * w},
                                                {0.86 * r, -0.50 * w},
                                                {0.95 * r, -0.40 * w},
                                                {0.95 * r, 0.40 * w},
                                                {0.86 * r, 0.50 * w},
                                                {0.62 * r, 0.50 * w},
                                                {0.56 * r, 0.36 * w}}};
  const std::array<Eigen::Vector2d, 4> rim = {
      {{0.0, -0.20 * w}, {0.56 * r, -0.36 * w}, {0.56 * r, 0.36 * w}, {0.0, 0.20 * w}}};
  const std::array<Eigen::Vector2d, 4> hub = {
      {{0.0, -0.34 * w}, {0.20 * r, -0.34 * w}, {0.20 * r, 0.34 * w}, {0.0, 0.34 * w}}};
  Mesh about_z = revolved_mesh(tyre, kSides, kTyre);
  append(about_z, revolved_mesh(rim, kSides, kRim), Eigen::Isometry3d::Identity());
  append(about_z, revolved_mesh(hub, kSides / 2, kHub), Eigen::Isometry3d::Identity());

  Mesh wheel;
  append(wheel, about_z,
         Eigen::Isometry3d(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Point::UnitX())));
  // Lugs slant from the middle outwards, alternately to either side. Their outermost corners are
  // at the radius, so that the wheel stands on the ground.
  constexpr int kLugs = 32;
  constexpr double kSlant_rad = 0.6;
  const Eigen::Vector2d half(0.028 * r, 0.55 * w);
  const double across_m = half.x() * std::cos(kSlant_rad) + half.y() * std::sin(kSlant_rad);
  const double top_m = std::sqrt(std::max(0.0, r * r - across_m * across_m));
  const Mesh lug = box_mesh({-half.x(), 0.02 * w, 0.90 * r}, {half.x(), half.y(), top_m},
                            mix(kTyre, {90, 90, 90}, 0.35));
  for (int k = 0; k < kLugs; ++k) {
    const double side = k % 2 == 0 ? 0.0 : std::numbers::pi;
    const double slant = k % 2 == 0 ? kSlant_rad : -kSlant_rad;
    const Eigen::Isometry3d X(
        Eigen::AngleAxisd(2.0 * std::numbers::pi * k / kLugs, Point::UnitY()) *
        Eigen::AngleAxisd(side + slant, Point::UnitZ()));
    append(wheel, lug, X);
  }
  return wheel;
}

Mesh implement_mesh(const Vehicle& vehicle, bool down) {
  RunSample sample;
  sample.implement_down = down;
  Mesh mesh;
  append_implement(mesh, vehicle, sample);
  return mesh;
}

VehicleMesh vehicle_mesh(const Vehicle& vehicle, const RunSample& sample) {
  VehicleMesh out = body_mesh(vehicle);
  out.mesh = moved_vehicle_mesh(vehicle, out.mesh, sample);
  return out;
}

Mesh moved_vehicle_mesh(const Vehicle& vehicle, const Mesh& body, const RunSample& sample) {
  Mesh mesh = body;
  append_wheels(mesh, vehicle, sample);
  append_implement(mesh, vehicle, sample);
  return mesh;
}

Eigen::Isometry3d pose_in_D(const RunSample& sample, const Relief& relief) {
  const auto stretched = [&](double angle) {
    return std::atan(relief.exaggeration * std::tan(angle));
  };
  const Point p_D(sample.p_WB.x(), sample.p_WB.y(),
                  (sample.p_WB.z() - relief.base_m) * relief.exaggeration);
  return moved(p_D) * Eigen::AngleAxisd(sample.yaw_rad, Point::UnitZ()) *
         Eigen::AngleAxisd(-stretched(sample.pitch_rad), Point::UnitY()) *
         Eigen::AngleAxisd(stretched(sample.roll_rad), Point::UnitX());
}

}  // namespace headland

// Vehicles, terrains and paths that the physics tests drive.
#pragma once

#include <cmath>
#include <numbers>

#include "planner/path.h"
#include "sim/machine.h"
#include "sim/simulation.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "terrains/soil_map.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::test {

// Plane h = slope_x x + slope_y y over the square |x|, |y| <= reach_m.
inline Heightfield plane(double slope_x, double slope_y, double reach_m = 200.0) {
  Heightfield terrain;
  terrain.cell_m = 2.0;
  terrain.columns = terrain.rows = static_cast<int>(2.0 * reach_m / terrain.cell_m) + 1;
  terrain.origin_W = {-reach_m, -reach_m};
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j);
      terrain.height_m.push_back(slope_x * p.x() + slope_y * p.y());
    }
  }
  return terrain;
}

// Distance from the path, root mean square over the rows and over the rest.
inline constexpr double kRows_m = 0.03;  // targets with ideal positioning
inline constexpr double kTurns_m = 0.15;
struct TrackingError {
  double rows_m = 0.0;
  double turns_m = 0.0;
};
inline TrackingError tracking_error(const Path& path, const RunRecord& run) {
  double rows_m3 = 0.0, rows_m = 0.0, turns_m3 = 0.0, turns_m = 0.0;
  for (const SegmentRecord& segment : run.segments) {
    const bool row = path.segments[static_cast<std::size_t>(segment.segment)].implement_down;
    (row ? rows_m3 : turns_m3) += segment.cross_track_sum_m3;
    (row ? rows_m : turns_m) += segment.distance_m;
  }
  return {std::sqrt(rows_m3 / rows_m), std::sqrt(turns_m3 / turns_m)};
}

// Smooth hills: amplitude and wavelength along both axes.
inline Heightfield hills(double amplitude_m, double wavelength_m, double reach_m = 100.0,
                         double cell_m = 0.5) {
  Heightfield terrain;
  terrain.cell_m = cell_m;
  terrain.columns = terrain.rows = static_cast<int>(2.0 * reach_m / cell_m) + 1;
  terrain.origin_W = {-reach_m, -reach_m};
  const double k = 2.0 * std::numbers::pi / wavelength_m;
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p = terrain.origin_W + cell_m * Eigen::Vector2d(i, j);
      terrain.height_m.push_back(amplitude_m * std::sin(k * p.x()) * std::cos(0.7 * k * p.y()));
    }
  }
  return terrain;
}

// The same with a side slope (rise over run along y) under it.
inline Heightfield hillside(double slope_y, double amplitude_m, double wavelength_m,
                            double reach_m = 120.0) {
  Heightfield terrain = hills(amplitude_m, wavelength_m, reach_m);
  for (int j = 0; j < terrain.rows; ++j) {
    const double rise_m = slope_y * (terrain.origin_W.y() + j * terrain.cell_m);
    for (int i = 0; i < terrain.columns; ++i) {
      terrain.height_m[static_cast<std::size_t>(j * terrain.columns + i)] += rise_m;
    }
  }
  return terrain;
}

inline Field open_field(double reach_m = 190.0) {
  Field field;
  field.name = "open";
  field.boundary = {
      {-reach_m, -reach_m}, {reach_m, -reach_m}, {reach_m, reach_m}, {-reach_m, reach_m}};
  return field;
}

// Appends an arc (curvature != 0) or a line of this length to a path, as a segment of its own.
inline void extend(Path& path, PathKind kind, Gear gear, bool implement_down, double length_m,
                   double curvature_per_m) {
  PathPoint at;
  if (!path.segments.empty()) at = path.segments.back().points.back();
  PathSegment segment;
  segment.kind = kind;
  segment.gear = gear;
  segment.implement_down = implement_down;
  segment.manoeuvre = static_cast<int>(path.segments.size());
  const int steps = static_cast<int>(std::ceil(length_m / 0.1));
  const double step_m = (gear == Gear::kForward ? 1.0 : -1.0) * length_m / steps;
  at.curvature_per_m = curvature_per_m;
  segment.points.push_back(at);
  for (int i = 0; i < steps; ++i) {
    // The chord of an arc points along the mean of its end headings.
    const double middle_rad = at.heading_rad + 0.5 * step_m * curvature_per_m;
    at.p_W += step_m * Eigen::Vector2d(std::cos(middle_rad), std::sin(middle_rad));
    at.heading_rad += step_m * curvature_per_m;
    segment.points.push_back(at);
  }
  path.segments.push_back(segment);
}

inline Path straight(double length_m, bool implement_down = false, double heading_rad = 0.0,
                     const Eigen::Vector2d& start_W = Eigen::Vector2d::Zero()) {
  Path path;
  PathSegment segment;
  segment.kind = implement_down ? PathKind::kSwath : PathKind::kTransit;
  segment.implement_down = implement_down;
  const int steps = static_cast<int>(std::ceil(length_m / 0.25));
  const Eigen::Vector2d ahead(std::cos(heading_rad), std::sin(heading_rad));
  for (int i = 0; i <= steps; ++i) {
    segment.points.push_back({start_W + length_m * i / steps * ahead, heading_rad, 0.0});
  }
  path.segments.push_back(segment);
  return path;
}

// Rows up and down joined by omega turns (bulbs), as the prototype's reference drive.
inline Path rows_with_omega_turns(int rows, double length_m, double width_m, double radius_m) {
  Path path;
  const double a = std::acos((radius_m + 0.5 * width_m) / (2.0 * radius_m));
  for (int row = 0; row < rows; ++row) {
    extend(path, PathKind::kSwath, Gear::kForward, true, length_m, 0.0);
    if (row + 1 == rows) break;
    const double side = row % 2 == 0 ? 1.0 : -1.0;  // next row lies to the left, then to the right
    extend(path, PathKind::kUTurn, Gear::kForward, false, radius_m * a, -side / radius_m);
    extend(path, PathKind::kUTurn, Gear::kForward, false, radius_m * (std::numbers::pi + 2.0 * a),
           side / radius_m);
    extend(path, PathKind::kUTurn, Gear::kForward, false, radius_m * a, -side / radius_m);
  }
  return path;
}

inline double cause_j(const EnergyBalance& energy, EnergyCause cause) {
  return energy.cause_j[static_cast<std::size_t>(cause)];
}

// Ground on which a textbook formula is exact: enough grip, known rolling resistance.
inline SoilMap textbook_soil(double friction = 0.8, double rolling_resistance = 0.05) {
  return uniform_soil({"textbook", ConstantGround{friction, rolling_resistance, 10.0}, 0.09, ""});
}

// Rows of the vehicle's working width with the tightest turns that it can plan.
inline Path rows_for(const Vehicle& vehicle, int rows, double length_m) {
  const double width_m = vehicle.implement.working_width_m;
  // An omega turn needs a radius over half the width.
  return rows_with_omega_turns(rows, length_m, width_m,
                               std::max(planning_turning_radius_m(vehicle), width_m / 1.9));
}

inline SoilMap soil_named(std::string_view name) { return uniform_soil(*find_soil(name)); }

inline RunRecord run(const Path& path, const Vehicle& vehicle, const Heightfield& terrain,
                     const SoilMap& soil, SimulationOptions options = {},
                     const Field& field = open_field()) {
  return simulate({field, terrain, soil, vehicle, path, options, {}});
}

// A vehicle braked on a slope (rise over run along its x axis).
struct ParkedVehicle {
  double drift_mm_per_min = 0.0;  // over a minute, after 20 s to settle
  PerWheel<WheelState> wheels;
};
inline ParkedVehicle park(const Vehicle& vehicle, double slope, double rate_hz,
                          const SoilMap& soil = textbook_soil()) {
  const Heightfield terrain = plane(slope, 0.0);
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(open_field(), terrain, vehicle);
  stand(machine, {0.0, 0.0}, 0.0, world);
  MachineState state;
  DriverCommand braked;
  braked.hold = true;
  const auto wait = [&](double seconds) {
    for (long i = 0; i < std::lround(seconds * rate_hz); ++i) {
      step_machine(machine, braked, {}, 0.0, 1.0 / rate_hz, world, state);
    }
    return world.state().p_WC;
  };
  const Eigen::Vector3d settled = wait(20.0);
  return {1000.0 * (wait(60.0) - settled).norm(), state.wheels};
}

}  // namespace headland::test

#include "evaluate/manoeuvre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/arcs.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;
constexpr double kStraight_m = 30.0;  // measured at constant speed
constexpr double kRaised_m = 15.0;    // with the implement up, in its cycle
constexpr double kLowered_m = 0.01;
constexpr double kSettle_s = 4.0;  // after a change of speed, until driving is steady
constexpr double kCourseSpacing_m = 0.1;
constexpr double kSame_m = 0.05;  // row spacings closer than this are one

constexpr std::array<std::string_view, 8> kNames = {
    "straight", "stop and start", "implement cycle",  "90-degree turn",
    "U turn",   "omega turn",     "three-point turn", "pivot turn"};

// Appends arcs of one movement at the path's end.
void drive_on(Path& path, PathKind kind, bool implement_down, const std::vector<Arc>& arcs,
              double turn_on_spot_rad = 0.0) {
  Pose pose;
  int manoeuvre = 0;
  if (!path.segments.empty()) {
    pose = pose_of(path.segments.back().points.back());
    manoeuvre = path.segments.back().manoeuvre + 1;
  }
  pose.heading_rad += turn_on_spot_rad;
  for (PathSegment& segment : sample(pose, arcs, kCourseSpacing_m)) {
    segment.kind = kind;
    segment.implement_down = implement_down;
    segment.manoeuvre = manoeuvre;
    path.segments.push_back(std::move(segment));
  }
}

void drive_straight(Path& path, bool implement_down, double length_m) {
  drive_on(path, implement_down ? PathKind::kSwath : PathKind::kTransit, implement_down,
           {{length_m, 0.0, Gear::kForward}});
}

// Way in which the speed changes by up to `speed_mps` and settles.
double settling_m(const Vehicle& vehicle, double speed_mps) {
  const double to_speed_m = 0.5 * speed_mps * speed_mps / vehicle.driver.max_acceleration_mps2;
  return to_speed_m + kSettle_s * speed_mps;
}

std::vector<Arc> turn_arcs(const Manoeuvre& manoeuvre, double radius_m) {
  const double left = 1.0 / radius_m;
  const double spacing_m = manoeuvre.row_spacing_m;
  const Arc quarter{kQuarter_rad * radius_m, left, Gear::kForward};
  switch (manoeuvre.kind) {
    case ManoeuvreKind::kTurn90:
      return {quarter};
    case ManoeuvreKind::kUTurn:
      return {quarter, {spacing_m - 2.0 * radius_m, 0.0, Gear::kForward}, quarter};
    case ManoeuvreKind::kOmegaTurn: {
      const double out_rad = std::acos((radius_m + 0.5 * spacing_m) / (2.0 * radius_m));
      const Arc out{out_rad * radius_m, -left, Gear::kForward};
      return {out, {(std::numbers::pi + 2.0 * out_rad) * radius_m, left, Gear::kForward}, out};
    }
    case ManoeuvreKind::kThreePointTurn:
      return {quarter, {2.0 * radius_m - spacing_m, 0.0, Gear::kReverse}, quarter};
    default:
      return {};
  }
}

bool turns_between_rows(ManoeuvreKind kind) { return kind >= ManoeuvreKind::kUTurn; }

void add_turn(Course& course, const Manoeuvre& manoeuvre, const Vehicle& vehicle) {
  Path& path = course.path;
  if (manoeuvre.kind == ManoeuvreKind::kPivotTurn) {
    drive_on(path, PathKind::kUTurn, false, {{manoeuvre.row_spacing_m, 0.0, Gear::kForward}},
             kQuarter_rad);
    return;
  }
  const bool between_rows = turns_between_rows(manoeuvre.kind);
  drive_on(path, between_rows ? PathKind::kUTurn : PathKind::kTurn,
           manoeuvre.implement_down && !between_rows,
           turn_arcs(manoeuvre, planning_turning_radius_m(vehicle)));
}

std::vector<double> row_spacings_m(const Vehicle& vehicle, const ManoeuvreRanges& ranges) {
  if (!ranges.spacings_m.empty()) return ranges.spacings_m;
  std::vector<double> spacings_m;
  for (const double times : {1.0, 2.0, 3.0}) {
    spacings_m.push_back(times * vehicle.implement.working_width_m);
    spacings_m.push_back(times * planning_turning_radius_m(vehicle));
  }
  std::sort(spacings_m.begin(), spacings_m.end());
  const auto same = [](double a, double b) { return b - a < kSame_m; };
  spacings_m.erase(std::unique(spacings_m.begin(), spacings_m.end(), same), spacings_m.end());
  return spacings_m;
}

void add_turns_between_rows(const Vehicle& vehicle, const ManoeuvreRanges& ranges,
                            std::vector<Manoeuvre>& list) {
  const double speed_mps = vehicle.driver.work_speed_mps;
  const double diameter_m = 2.0 * planning_turning_radius_m(vehicle);
  const auto add = [&](ManoeuvreKind kind, double spacing_m) {
    list.push_back({kind, true, speed_mps, 0.0, 0.0, spacing_m});
  };
  const std::vector<double> spacings_m = row_spacings_m(vehicle, ranges);
  for (const double spacing_m : spacings_m) {
    if (spacing_m >= diameter_m) add(ManoeuvreKind::kUTurn, spacing_m);
  }
  for (const double spacing_m : spacings_m) {
    if (spacing_m < diameter_m) add(ManoeuvreKind::kOmegaTurn, spacing_m);
  }
  if (vehicle.implement.trailing) return;  // neither reverses nor turns on the spot
  for (const double spacing_m : spacings_m) {
    if (spacing_m < diameter_m) add(ManoeuvreKind::kThreePointTurn, spacing_m);
  }
  if (vehicle.steering.kind != SteeringKind::kSkid) return;
  for (const double spacing_m : spacings_m) add(ManoeuvreKind::kPivotTurn, spacing_m);
}

}  // namespace

std::string_view manoeuvre_name(ManoeuvreKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

Course course_of(const Manoeuvre& manoeuvre, const Vehicle& vehicle) {
  const bool down = manoeuvre.implement_down;
  const double settle_m = settling_m(vehicle, manoeuvre.speed_mps);
  Course course;
  double& straight_m = down ? course.down_m : course.raised_m;
  if (manoeuvre.kind == ManoeuvreKind::kStopStart) {
    // The implement is lowered at standstill before the first of these centimetres.
    drive_straight(course.path, down, kLowered_m);
    drive_straight(course.path, down, 2.0 * settle_m);
    course.first_segment = course.last_segment = 1;
    straight_m = 2.0 * settle_m;
    return course;
  }
  drive_straight(course.path, down, settle_m);
  course.first_segment = 1;
  if (manoeuvre.kind == ManoeuvreKind::kStraight) {
    drive_straight(course.path, down, kStraight_m);
  } else {
    drive_straight(course.path, down, settle_m);
    if (manoeuvre.kind == ManoeuvreKind::kImplementCycle) {
      drive_straight(course.path, false, kRaised_m);
      course.raised_m = kRaised_m;
    } else {
      add_turn(course, manoeuvre, vehicle);
    }
    const bool pivots = manoeuvre.kind == ManoeuvreKind::kPivotTurn;
    drive_on(course.path, down ? PathKind::kSwath : PathKind::kTransit, down,
             {{settle_m, 0.0, Gear::kForward}}, pivots ? kQuarter_rad : 0.0);
    straight_m += 2.0 * settle_m;
  }
  course.last_segment = static_cast<int>(course.path.segments.size()) - 1;
  drive_straight(course.path, down, settle_m);
  return course;
}

std::vector<Manoeuvre> standard_manoeuvres(const Vehicle& vehicle, const ManoeuvreRanges& ranges) {
  const double work_mps = vehicle.driver.work_speed_mps;
  std::vector<Manoeuvre> list;
  for (const bool down : {true, false}) {
    for (const double share : ranges.speed_shares) {
      const double speed_mps = share * work_mps;
      if (speed_mps > top_speed_mps(vehicle)) continue;
      for (const double slope : ranges.slopes) {
        list.push_back({ManoeuvreKind::kStraight, down, speed_mps, slope, 0.0, 0.0});
      }
    }
    for (const double slope : ranges.side_slopes) {
      list.push_back({ManoeuvreKind::kStraight, down, work_mps, 0.0, slope, 0.0});
    }
  }
  for (const bool down : {true, false}) {
    list.push_back({ManoeuvreKind::kStopStart, down, work_mps, 0.0, 0.0, 0.0});
  }
  list.push_back({ManoeuvreKind::kImplementCycle, true, work_mps, 0.0, 0.0, 0.0});
  for (const bool down : {true, false}) {
    list.push_back({ManoeuvreKind::kTurn90, down, work_mps, 0.0, 0.0, 0.0});
  }
  add_turns_between_rows(vehicle, ranges, list);
  return list;
}

}  // namespace headland

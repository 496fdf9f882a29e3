#include "sim/incidents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

std::string at_place(const Eigen::Vector3d& p_WB) {
  return fmt::format("at x {:.1f} m, y {:.1f} m", p_WB.x(), p_WB.y());
}

bool stuck(const Machine& machine, const StepReport& report, const DriverState& driver,
           double time_s, ProgressWatch& watch) {
  if (driver.place.run != watch.run || driver.place.along_m > watch.along_m + kStuckProgress_m) {
    watch = {driver.place.run, driver.place.along_m, time_s};
  }
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (machine.wheels[i].driven) watch.worst_slip = std::max(watch.worst_slip, report.slip[i]);
  }
  watch.clipped = watch.clipped || report.clipped;
  return time_s - watch.time_s > kStuckAfter_s;
}

std::string why_stuck(const ProgressWatch& watch) {
  constexpr double kSpinning = 0.5;
  if (watch.worst_slip > kSpinning) {
    return fmt::format("stuck: the driven wheels spin (slip {:.2f})", watch.worst_slip);
  }
  if (watch.clipped) return "stuck: the motor or the battery is at its limit";
  return "stuck: no headway along the path";
}

// A machine that crawls at its limit for most of the way is late for that reason.
std::string why_late(const RunRecord& record, double time_s) {
  constexpr double kMostOfTheTime = 0.5;
  const double share = record.peaks.motor_clipped_s / time_s;
  if (share < kMostOfTheTime) return "";
  return fmt::format(", the motor at its limit for {:.0f} % of the time: too steep or too soft",
                     100.0 * share);
}

}  // namespace

std::optional<Incident> find_incident(const SimulationSetup& setup, const Machine& machine,
                                      const StepReport& report, const BulletWorld& world,
                                      const MachineState& state, const DriverState& driver,
                                      const RunRecord& record, double time_s, double max_time_s,
                                      ProgressWatch& watch) {
  const ChassisState& chassis = report.chassis;
  const Eigen::Vector3d p_WB = origin_of(chassis, machine.mass);
  if (!p_WB.allFinite() || !chassis.v_W.allFinite() || chassis.v_W.norm() > kAbsurdSpeed_mps) {
    return Incident{Outcome::kDiverged, "the motion blew up"};
  }
  const auto incident = [&](Outcome outcome, const std::string& cause) {
    return Incident{outcome, cause + " " + at_place(p_WB)};
  };
  if (chassis.R_WB(2, 2) < std::cos(kRolledOver_rad)) {
    return incident(Outcome::kRolledOver, "rolled over");
  }
  if (const auto& trailing = setup.vehicle.implement.trailing) {
    if (report.trailer.R_WB(2, 2) < std::cos(kRolledOver_rad)) {
      return incident(Outcome::kRolledOver, "the trailed implement rolled over");
    }
    if (std::abs(report.hitch_angle_rad) > trailing->max_angle_rad) {
      return incident(Outcome::kJackknifed,
                      fmt::format("the drawbar touched the vehicle: {:.0f} deg from straight",
                                  kDegreesPerRad * std::abs(report.hitch_angle_rad)));
    }
  }
  if (const auto touched = world.touched_obstacle()) {
    const Obstacle& obstacle = setup.field.obstacles[*touched];
    const Eigen::Vector2d hit_W = nearest_of(obstacle, p_WB.head<2>());
    return incident(Outcome::kHitObstacle,
                    fmt::format("hit the {} at x {:.1f} m, y {:.1f} m",
                                obstacle_kind_name(obstacle.kind), hit_W.x(), hit_W.y()));
  }
  if (!report.trailer_on_terrain ||
      std::any_of(report.contacts.begin(), report.contacts.end(),
                  [](const WheelContact& contact) { return !contact.on_terrain; })) {
    return incident(Outcome::kLeftTerrain, "a wheel ran off the edge of the terrain");
  }
  if (record.peaks.boundary_overrun_m.value > setup.options.max_overrun_m) {
    const bool in_hole = record.peaks.overrun_in_hole;
    return incident(in_hole ? Outcome::kEnteredHole : Outcome::kLeftField,
                    fmt::format("{:.1f} m {}", record.peaks.boundary_overrun_m.value,
                                in_hole ? "into a hole" : "outside the field"));
  }
  if (state.battery.soc < machine.vehicle.battery.empty_soc) {
    return incident(Outcome::kBatteryEmpty, fmt::format("state of charge below {:.0f} %",
                                                        100.0 * machine.vehicle.battery.empty_soc));
  }
  if (time_s > max_time_s) {
    Incident late =
        incident(Outcome::kTimedOut, fmt::format("not done within {:.0f} s", max_time_s));
    late.detail += why_late(record, time_s);
    return late;
  }
  if (stuck(machine, report, driver, time_s, watch)) {
    return incident(Outcome::kStuck, why_stuck(watch));
  }
  return std::nullopt;
}

}  // namespace headland

#include "vehicle_models/vehicle_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "terrains/input_error.h"
#include "vehicle_models/draft.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

[[noreturn]] void refuse(const std::string& source, std::string_view key, double value,
                         std::string allowed) {
  throw InputError(source, std::string(key), fmt::format("{:g}", value), std::move(allowed));
}

void check_body(const Vehicle& vehicle, const std::string& source) {
  const Body& body = vehicle.body;
  const Eigen::Vector3d& inertia = body.inertia_kg_m2;
  if (inertia.minCoeff() <= 0.0) {
    refuse(source, "inertia [kg m2]", inertia.minCoeff(), "every moment must be above 0");
  }
  if (2.0 * inertia.maxCoeff() > inertia.sum()) {
    refuse(source, "inertia [kg m2]", inertia.maxCoeff(),
           "no rigid body has one moment of inertia larger than the sum of the other two");
  }
  if (body.com_B.x() <= vehicle.rear.x_B_m || body.com_B.x() >= vehicle.front.x_B_m) {
    refuse(source, "centre of mass [m]", body.com_B.x(),
           fmt::format("the centre of mass must lie between the axles, x in ({:g}, {:g}) m",
                       vehicle.rear.x_B_m, vehicle.front.x_B_m));
  }
  const double narrower_m = std::min(vehicle.rear.track_m, vehicle.front.track_m);
  if (std::abs(body.com_B.y()) >= 0.5 * narrower_m) {
    refuse(source, "centre of mass [m]", body.com_B.y(),
           fmt::format("must lie between the wheels, y within {:g} m", 0.5 * narrower_m));
  }
  if (body.com_B.z() > body.height_m) {
    refuse(source, "centre of mass [m]", body.com_B.z(),
           fmt::format("the centre of mass must lie in the hull, z below {:g} m", body.height_m));
  }
  if (body.ground_clearance_m >= body.height_m) {
    refuse(source, "ground clearance [m]", body.ground_clearance_m,
           fmt::format("must be below the height, {:g} m", body.height_m));
  }
  if (body.rear_overhang_m >= body.length_m) {
    refuse(source, "hull behind frame B [m]", body.rear_overhang_m,
           fmt::format("must be below the length, {:g} m", body.length_m));
  }
}

void check_axle(const Vehicle& vehicle, const Axle& axle, double load_n, const std::string& name,
                const std::string& source) {
  if (axle.radius_m < vehicle.body.ground_clearance_m) {
    refuse(source, name + " wheel radius [m]", axle.radius_m,
           fmt::format("must be at least the ground clearance, {:g} m, or the axle would hang "
                       "below the hull",
                       vehicle.body.ground_clearance_m));
  }
  const double sag_m = 0.5 * load_n / axle.vertical_stiffness_n_per_m;
  if (sag_m > kMaxStaticDeflection * axle.radius_m) {
    refuse(source, name + "_tyres.vertical_stiffness_n_per_m", axle.vertical_stiffness_n_per_m,
           fmt::format("the tyre would sag {:.2f} m at rest; at least {:.0f} N/m", sag_m,
                       0.5 * load_n / (kMaxStaticDeflection * axle.radius_m)));
  }
}

void check_axles(const Vehicle& vehicle, const std::string& source) {
  const double rear_x_m =
      vehicle.steering.kind == SteeringKind::kFront ? 0.0 : -vehicle.front.x_B_m;
  if (vehicle.rear.x_B_m != rear_x_m) {
    refuse(source, "rear.x_B_m", vehicle.rear.x_B_m,
           fmt::format("must be {:g}: frame B starts where the vehicle turns about", rear_x_m));
  }
  const AxleLoads loads = static_axle_loads(vehicle);
  const double weight_n = loads.rear_n + loads.front_n;
  if (loads.front_n < kMinFrontLoadShare * weight_n) {
    refuse(source, "implement.mass_kg", vehicle.implement.mass_kg,
           fmt::format("with it raised the front axle carries {:.0f} % of the weight; at least "
                       "{:.0f} % is needed to steer",
                       100.0 * loads.front_n / weight_n, 100.0 * kMinFrontLoadShare));
  }
  if (loads.rear_n < kMinFrontLoadShare * weight_n) {
    refuse(source, "implement.mass_kg", vehicle.implement.mass_kg,
           fmt::format("with it raised the rear axle carries {:.0f} % of the weight; at least "
                       "{:.0f} % is needed to stand and pull",
                       100.0 * loads.rear_n / weight_n, 100.0 * kMinFrontLoadShare));
  }
  check_axle(vehicle, vehicle.rear, loads.rear_n, "rear", source);
  check_axle(vehicle, vehicle.front, loads.front_n, "front", source);
  if (!vehicle.rear.driven && !vehicle.front.driven) {
    throw InputError(source, "drivetrain.driven", "", "at least one axle must be driven");
  }
  if (vehicle.rear.driven && vehicle.front.driven &&
      std::abs(vehicle.rear.radius_m - vehicle.front.radius_m) > 0.02 * vehicle.rear.radius_m) {
    refuse(source, "front wheel radius [m]", vehicle.front.radius_m,
           fmt::format("one gear ratio drives both axles: within 2 % of rear.radius_m, {:g} m, or "
                       "only one axle driven",
                       vehicle.rear.radius_m));
  }
}

void check_steering(const Vehicle& vehicle, const std::string& source) {
  const Steering& steering = vehicle.steering;
  const auto need = [&](std::string_view key, double value, std::string_view kind) {
    if (value > 0.0) return;
    throw InputError(source, fmt::format("steering.{}", key), "",
                     fmt::format("missing key: {} steering needs it", kind));
  };
  const auto spare = [&](std::string_view key, double value, std::string_view kind) {
    if (value == 0.0) return;
    throw InputError(source, fmt::format("steering.{}", key), "",
                     fmt::format("only for {} steering; this vehicle's is '{}'", kind,
                                 steering_word(steering.kind)));
  };
  if (steering.kind == SteeringKind::kSkid) {
    spare("actuator_power_w", steering.actuator_power_w, "wheel");
    need("max_yaw_rate_deg_per_s", steering.max_yaw_rate_rad_per_s, "skid");
    need("turning_radius_m", steering.turning_radius_m, "skid");
    if (!vehicle.drivetrain.motor_per_wheel) {
      throw InputError(source, "drivetrain.driven", "",
                       "skid steering turns by its motors: must be per_wheel");
    }
  } else {
    need("max_rate_deg_per_s", steering.max_rate_rad_per_s, "wheel");
    spare("max_yaw_rate_deg_per_s", steering.max_yaw_rate_rad_per_s, "skid");
    spare("turning_radius_m", steering.turning_radius_m, "skid");
  }
  const double radius_m = min_turning_radius_m(vehicle);
  if (!(radius_m <= kMaxTurningRadius_m)) {
    refuse(
        source, "steering limits [deg]", kDegreesPerRadian * steering.max_angle_rad,
        fmt::format("turns no tighter than {:.3g} m; at most {:g} m, or no field has room to turn",
                    radius_m, kMaxTurningRadius_m));
  }
}

void check_trailing(const Vehicle& vehicle, const std::string& source) {
  const auto& trailing = vehicle.implement.trailing;
  if (!trailing) return;
  if (trailing->hitch_x_B_m > vehicle.rear.x_B_m) {
    refuse(source, "trailing.hitch_x_B_m", trailing->hitch_x_B_m,
           fmt::format("must be at or behind the rear axle, at most {:g} m", vehicle.rear.x_B_m));
  }
  if (vehicle.implement.x_B_m >= trailing->hitch_x_B_m) {
    refuse(source, "implement.x_B_m", vehicle.implement.x_B_m,
           fmt::format("a trailed implement works behind its hitch, below {:g} m",
                       trailing->hitch_x_B_m));
  }
  if (trailing->com_ahead_m >= trailing->drawbar_length_m) {
    refuse(source, "trailing.com_ahead_m", trailing->com_ahead_m,
           fmt::format("must lie between the implement's axle and the pin, below {:g} m",
                       trailing->drawbar_length_m));
  }
  const double load_n = 0.5 * (kGravity_mps2 * vehicle.implement.mass_kg - hitch_load_n(vehicle));
  const double least_n_per_m = load_n / (kMaxStaticDeflection * trailing->wheel_radius_m);
  if (trailing->vertical_stiffness_n_per_m < least_n_per_m) {
    refuse(source, "trailing.vertical_stiffness_n_per_m", trailing->vertical_stiffness_n_per_m,
           fmt::format("the tyre would sag {:.2f} m at rest; at least {:.0f} N/m",
                       load_n / trailing->vertical_stiffness_n_per_m, least_n_per_m));
  }
  const double radius_m = planning_turning_radius_m(vehicle);
  const double angle_rad = -steady_hitch_angle_rad(*trailing, 1.0 / radius_m);
  if (!(angle_rad < trailing->max_angle_rad)) {
    refuse(source, "trailing.drawbar_length_m", trailing->drawbar_length_m,
           fmt::format("on the tightest circle of plans, {:.2f} m, the drawbar would jackknife: "
                       "beyond max_angle_deg, {:.0f}",
                       radius_m, kDegreesPerRadian * trailing->max_angle_rad));
  }
}

void check_drive(const Vehicle& vehicle, const std::string& source) {
  const Driver& driver = vehicle.driver;
  const double fastest_mps = std::max({driver.work_speed_mps, driver.turn_speed_mps,
                                       driver.transit_speed_mps, driver.reverse_speed_mps});
  const double top_mps = top_speed_mps(vehicle);
  if (top_mps < fastest_mps) {
    refuse(source, "drivetrain.gear_ratio", vehicle.drivetrain.gear_ratio,
           fmt::format("reaches {:.2f} m/s, the driver wants {:.2f} m/s; at most {:.1f}", top_mps,
                       fastest_mps, vehicle.drivetrain.gear_ratio * top_mps / fastest_mps));
  }
  const Implement& implement = vehicle.implement;
  if (implement.lift_time_s <= 0.0 && implement.lift_energy_j > 0.0) {
    refuse(source, "implement.lift_time_s", implement.lift_time_s,
           fmt::format("above 0, to lift with {:g} J", implement.lift_energy_j));
  }
  const double pull_n = draft_n(implement, SoilTexture::kMedium, driver.work_speed_mps);
  const double force_n = drive_force_n(vehicle, driver.work_speed_mps);
  if (pull_n >= force_n) {
    const std::string why =
        fmt::format("draws {:.0f} N over {:g} m; the motor pulls {:.0f} N at {:g} m/s", pull_n,
                    implement.working_width_m, force_n, driver.work_speed_mps);
    if (implement.tillage) refuse(source, "draft.depth_cm", implement.tillage->depth_cm, why);
    refuse(source, "implement.draft_n_per_m", implement.draft_n_per_m, why);
  }
  const double holding_nm = total_mass_kg(vehicle) * kGravity_mps2 *
                            std::sin(std::atan(kParkingGrade)) *
                            std::max(vehicle.rear.radius_m, vehicle.front.radius_m);
  if (vehicle.drivetrain.brake_torque_max_nm < holding_nm) {
    refuse(source, "drivetrain.brake_torque_max_nm", vehicle.drivetrain.brake_torque_max_nm,
           fmt::format("at least {:.0f} N m to hold the machine on a {:.0f} % slope", holding_nm,
                       100.0 * kParkingGrade));
  }
}

void check_power(const Vehicle& vehicle, const std::string& source) {
  const double wanted_w = drive_peak_input_w(vehicle) +
                          shaft_power_w(vehicle.implement) / vehicle.implement.shaft_efficiency +
                          vehicle.battery.auxiliary_power_w;
  const double available_w = max_battery_power_w(vehicle.battery);
  if (available_w < wanted_w) {
    refuse(source, "battery.resistance_ohm", vehicle.battery.resistance_ohm,
           fmt::format("the nearly empty battery gives at most {:.1f} kW; motor, implement and "
                       "auxiliaries draw up to {:.1f} kW",
                       available_w / 1000.0, wanted_w / 1000.0));
  }
}

}  // namespace

void check_vehicle(const Vehicle& vehicle, const std::string& source) {
  check_body(vehicle, source);
  check_axles(vehicle, source);
  check_steering(vehicle, source);
  check_trailing(vehicle, source);
  check_drive(vehicle, source);
  check_power(vehicle, source);
}

}  // namespace headland

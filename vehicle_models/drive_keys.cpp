#include "vehicle_models/drive_keys.h"

#include <numbers>

#include "vehicle_models/draft.h"

namespace headland {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

DriveKey number(std::string_view key, double& target, double min, double max, double scale = 1.0) {
  return {.key = key, .min = min, .max = max, .number = &target, .scale = scale};
}

DriveKey integer(std::string_view key, int& target, double min, double max) {
  return {.key = key, .min = min, .max = max, .integer = &target};
}

DriveKey optional(DriveKey key) {
  key.optional = true;
  return key;
}

std::vector<DriveKey> tyre_keys(Axle& axle) {
  return {number("vertical_stiffness_n_per_m", axle.vertical_stiffness_n_per_m, 1e3, 1e8),
          number("vertical_damping_n_s_per_m", axle.vertical_damping_n_s_per_m, 0.0, 1e6),
          number("section_height_m", axle.section_height_m, 0.005, 1.5)};
}

std::vector<DriveKey> steering_keys(Steering& steering) {
  DriveKey kind{.key = "kind", .words = {"front", "four_wheel", "skid"}};
  kind.choose = [&steering](std::size_t word) {
    constexpr SteeringKind kKinds[] = {SteeringKind::kFront, SteeringKind::kFourWheel,
                                       SteeringKind::kSkid};
    steering.kind = kKinds[word];
  };
  return {kind,
          optional(number("max_rate_deg_per_s", steering.max_rate_rad_per_s, 1.0, 360.0, kDegree)),
          optional(number("max_yaw_rate_deg_per_s", steering.max_yaw_rate_rad_per_s, 1.0, 360.0,
                          kDegree)),
          optional(number("turning_radius_m", steering.turning_radius_m, 0.05, 50.0)),
          optional(number("actuator_power_w", steering.actuator_power_w, 0.0, 1e5)),
          optional(number("actuator_efficiency", steering.actuator_efficiency, 0.01, 1.0))};
}

DriveKey driven_key(Vehicle& v) {
  DriveKey key{.key = "driven", .words = {"rear", "front", "all", "per_wheel"}};
  key.choose = [&v](std::size_t word) {
    v.rear.driven = word != 1;
    v.front.driven = word != 0;
    v.drivetrain.motor_per_wheel = word == 3;
  };
  return key;
}

DriveKey chemistry_key(Battery& battery) {
  DriveKey key{.key = "chemistry", .words = {"lead_acid", "lfp"}};
  key.choose = [&battery](std::size_t word) {
    battery.chemistry = word == 0 ? Chemistry::kLeadAcid : Chemistry::kLfp;
  };
  return key;
}

std::vector<DriveKey> trailing_keys(Trailing& trailing) {
  return {
      number("hitch_x_B_m", trailing.hitch_x_B_m, -10.0, 10.0),
      optional(number("hitch_height_m", trailing.hitch_height_m, 0.05, 2.0)),
      number("drawbar_length_m", trailing.drawbar_length_m, 0.2, 20.0),
      optional(number("com_ahead_m", trailing.com_ahead_m, 0.0, 10.0)),
      optional(number("track_m", trailing.track_m, 0.2, 10.0)),
      optional(number("wheel_radius_m", trailing.wheel_radius_m, 0.05, 2.0)),
      optional(number("wheel_width_m", trailing.wheel_width_m, 0.02, 2.0)),
      optional(number("wheel_inertia_kg_m2", trailing.wheel_inertia_kg_m2, 0.001, 1000.0)),
      optional(number("vertical_stiffness_n_per_m", trailing.vertical_stiffness_n_per_m, 1e3, 1e8)),
      optional(number("vertical_damping_n_s_per_m", trailing.vertical_damping_n_s_per_m, 0.0, 1e6)),
      optional(number("section_height_m", trailing.section_height_m, 0.005, 1.5)),
      optional(number("rolling_resistance", trailing.rolling_resistance, 0.0, 1.0)),
      optional(number("max_angle_deg", trailing.max_angle_rad, 5.0, 120.0, kDegree))};
}

DriveKey tool_key(TillageDraft& draft) {
  DriveKey key{.key = kDraftTool};
  for (const D497Tool& tool : d497_tools()) key.words.push_back(tool.name);
  key.choose = [&draft](std::size_t word) {
    const D497Tool& tool = d497_tools()[word];
    draft.a = tool.a;
    draft.b = tool.b;
    draft.c = tool.c;
    draft.texture_factor = tool.texture_factor;
  };
  return optional(key);
}

std::vector<DriveKey> draft_keys(TillageDraft& draft) {
  auto& factor = draft.texture_factor;
  return {tool_key(draft),
          optional(number("a", draft.a, 0.0, 1e5)),
          optional(number("b", draft.b, 0.0, 1e4)),
          optional(number("c", draft.c, 0.0, 1e3)),
          optional(number("factor_fine", factor[0], 0.0, 10.0)),
          optional(number("factor_medium", factor[1], 0.0, 10.0)),
          optional(number("factor_coarse", factor[2], 0.0, 10.0)),
          optional(integer("tools", draft.tools, 1.0, 1000.0)),
          number("depth_cm", draft.depth_cm, 0.1, 100.0)};
}

}  // namespace

std::vector<DriveSection> sections_of(Vehicle& v) {
  std::vector<DriveSection> sections = {
      {"steering", steering_keys(v.steering)},
      {"rear_tyres", tyre_keys(v.rear)},
      {"front_tyres", tyre_keys(v.front)},
      {"drivetrain",
       {driven_key(v), number("gear_ratio", v.drivetrain.gear_ratio, 0.1, 1000.0),
        number("efficiency", v.drivetrain.efficiency, 0.1, 1.0),
        number("brake_torque_max_nm", v.drivetrain.brake_torque_max_nm, 1.0, 1e6)}},
      {"motor",
       {number("max_torque_nm", v.motor.max_torque_nm, 0.1, 1e5),
        number("max_power_w", v.motor.max_power_w, 10.0, 1e6),
        number("max_speed_rad_per_s", v.motor.max_speed_rad_per_s, 1.0, 5000.0),
        number("copper_loss_kc", v.motor.copper_loss_kc, 0.0, 1000.0),
        number("iron_loss_ki", v.motor.iron_loss_ki, 0.0, 1000.0),
        number("windage_loss_kw", v.motor.windage_loss_kw, 0.0, 1.0),
        number("constant_loss_w", v.motor.constant_loss_w, 0.0, 1e5),
        optional(number("rotor_inertia_kg_m2", v.motor.rotor_inertia_kg_m2, 0.0, 100.0)),
        optional(number("inverter_efficiency", v.motor.inverter_efficiency, 0.1, 1.0)),
        number("regeneration_fraction", v.motor.regeneration_fraction, 0.0, 1.0),
        number("regeneration_min_speed_mps", v.motor.regeneration_min_speed_mps, 0.0, 10.0)}},
      {"battery",
       {chemistry_key(v.battery),
        integer("cells_in_series", v.battery.cells_in_series, 1.0, 1000.0),
        number("capacity_ah", v.battery.capacity_ah, 0.1, 10000.0),
        number("resistance_ohm", v.battery.resistance_ohm, 1e-5, 10.0),
        number("polarisation_resistance_ohm", v.battery.polarisation_resistance_ohm, 0.0, 10.0),
        number("polarisation_time_constant_s", v.battery.polarisation_time_constant_s, 0.1, 1e5),
        number("max_charge_c_rate", v.battery.max_charge_c_rate, 0.0, 20.0),
        number("peukert", v.battery.peukert, 1.0, 1.6),
        number("empty_soc", v.battery.empty_soc, 0.0, 0.9),
        number("auxiliary_power_w", v.battery.auxiliary_power_w, 0.0, 1e5)}},
      {"implement",
       {{.key = "name", .text = &v.implement.name},
        number("mass_kg", v.implement.mass_kg, 0.0, 20000.0),
        number("x_B_m", v.implement.x_B_m, -10.0, 10.0),
        number("working_width_m", v.implement.working_width_m, 0.05, 100.0),
        optional(number(kDraftPerMetre, v.implement.draft_n_per_m, 0.0, 1e5)),
        number("draft_height_m", v.implement.draft_height_m, -1.0, 2.0),
        optional(number("com_height_m", v.implement.com_height_m, 0.0, 5.0)),
        number("shaft_power_w", v.implement.shaft_power_w, 0.0, 1e6),
        optional(number("shaft_power_w_per_m", v.implement.shaft_power_w_per_m, 0.0, 1e5)),
        optional(number("shaft_efficiency", v.implement.shaft_efficiency, 0.01, 1.0)),
        number("lift_time_s", v.implement.lift_time_s, 0.0, 60.0),
        number("lift_energy_j", v.implement.lift_energy_j, 0.0, 1e6)}},
      {"driver",
       {number("work_speed_mps", v.driver.work_speed_mps, 0.05, 15.0),
        number("turn_speed_mps", v.driver.turn_speed_mps, 0.05, 15.0),
        number("transit_speed_mps", v.driver.transit_speed_mps, 0.05, 15.0),
        number("reverse_speed_mps", v.driver.reverse_speed_mps, 0.05, 15.0),
        number("max_acceleration_mps2", v.driver.max_acceleration_mps2, 0.05, 5.0),
        number("max_lateral_acceleration_mps2", v.driver.max_lateral_acceleration_mps2, 0.05, 5.0),
        number("look_ahead_m", v.driver.look_ahead_m, 0.1, 50.0),
        number("look_ahead_time_s", v.driver.look_ahead_time_s, 0.0, 10.0)}},
  };
  if (v.implement.tillage) sections.push_back({kDraft, draft_keys(*v.implement.tillage)});
  if (v.implement.trailing) {
    sections.push_back({kTrailing, trailing_keys(*v.implement.trailing)});
  }
  return sections;
}

}  // namespace headland

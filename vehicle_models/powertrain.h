// What drives a vehicle: motor, gears, brakes and battery as data.
#pragma once

namespace headland {

// Motor by the loss model of Larminie and Lowry: P_in = T w + kc T^2 + ki w + kw w^3 + C.
struct Motor {
  double max_torque_nm = 0.0;
  double max_power_w = 0.0;
  double max_speed_rad_per_s = 0.0;
  double copper_loss_kc = 0.0;
  double iron_loss_ki = 0.0;
  double windage_loss_kw = 0.0;
  double constant_loss_w = 0.0;
  double regeneration_fraction = 0.0;  // of the braking power that the motor takes, 0..1
  double regeneration_min_speed_mps = 0.5;
  double rotor_inertia_kg_m2 = 0.0;  // each driven wheel carries its share, see Axle
  double inverter_efficiency = 1.0;  // battery to motor and back
};

struct Drivetrain {
  // False: one motor, open differentials to the axles with `driven`. True: an equal motor with its
  // own gear at each of their wheels; `Motor` and `gear_ratio` are those of one of them.
  bool motor_per_wheel = false;
  double gear_ratio = 1.0;           // motor speed / wheel speed
  double efficiency = 1.0;           // motor shaft to wheel hubs
  double brake_torque_max_nm = 0.0;  // all wheels together
};

enum class Chemistry { kLeadAcid, kLfp };

struct Battery {
  Chemistry chemistry = Chemistry::kLfp;
  int cells_in_series = 16;
  double capacity_ah = 100.0;
  double resistance_ohm = 0.01;              // R0 of the pack
  double polarisation_resistance_ohm = 0.0;  // R1 of the pack
  double polarisation_time_constant_s = 30.0;
  double max_charge_c_rate = 0.5;
  double peukert = 1.0;
  double empty_soc = 0.05;  // the run ends with kBatteryEmpty below this
  double auxiliary_power_w = 0.0;
};

}  // namespace headland

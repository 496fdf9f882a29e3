// The machine: body, wheels, drivetrain, battery and implement, advanced by one step.
#pragma once

#include "sim/battery.h"
#include "sim/belly.h"
#include "sim/bullet_world.h"
#include "sim/driver.h"
#include "sim/drivetrain.h"
#include "sim/ledger.h"
#include "sim/trailer.h"
#include "sim/tyre.h"
#include "terrains/heightfield.h"
#include "terrains/soil_map.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// What never changes in a run. Nothing is owned.
struct Machine {
  const Vehicle& vehicle;
  const Heightfield& terrain;
  const SoilMap& soil;
  ChassisMass mass;
  PerWheel<WheelDefinition> wheels;
  MotorLayout motors;
  Belly belly;
  std::optional<Trailer> trailer;  // a trailed implement
};

Machine make_machine(const Vehicle& vehicle, const Heightfield& terrain, const SoilMap& soil);

// What evolves besides the rigid body, which Bullet keeps.
struct MachineState {
  PerWheel<WheelState> wheels;
  BatteryState battery;
  double belly_clear_m = 0.0;  // see watch_belly
  PerWheel<WheelState> trailer_wheels;
};

// One step seen from outside: the state before it and what happened in it.
struct StepReport {
  ChassisState chassis;  // before
  PerWheel<WheelContact> contacts;
  std::vector<BellyContact> belly;
  StoredEnergy stored;  // before
  PerWheel<double> slip{};
  double scuffing_m2_per_s = 0.0;  // ground that the treads slide over
  double motor_nm = 0.0;           // all motors
  double motor_w = 0.0;            // electrical, into the inverters
  double battery_w = 0.0;          // at the terminals
  double battery_v = 0.0;
  double draft_n = 0.0;
  bool clipped = false;
  EnergyBalance energy;  // of the step, without the stores
  // Of a trailed implement.
  ChassisState trailer;  // before
  double hitch_angle_rad = 0.0;
  double trailer_load_transfer_ratio = 0.0;  // (left - right) / total of its wheels' loads
  bool trailer_on_terrain = true;
};

// Attitude and height that fit the terrain under the wheels at a place and heading, at rest.
ChassisState place_on_ground(const Machine& machine, const Eigen::Vector2d& p_W,
                             double heading_rad);

// The machine in the world, standing on the ground there, with a trailed implement straight behind.
void stand(const Machine& machine, const Eigen::Vector2d& p_W, double heading_rad,
           BulletWorld& world);

// Energy in the stores of the machine as it is in the world, steered by `steer_rad`.
StoredEnergy energy_now(const Machine& machine, const BulletWorld& world, const MachineState& state,
                        double steer_rad, double dt_s);

// Position of B's origin in W.
Eigen::Vector3d origin_of(const ChassisState& chassis, const ChassisMass& mass);

// Angle of the virtual front wheel on the centre line, and how fast its actuator turns it.
struct Steer {
  double angle_rad = 0.0;
  double rate_rad_per_s = 0.0;
};

// Drives one step: motor, normal forces, draft, tyres, Bullet, battery, ledger. `lowered` is how
// far the implement is down (0..1), `steer` the angle of the virtual front wheel and its rate.
StepReport step_machine(const Machine& machine, const DriverCommand& command, Steer steer,
                        double lowered, double dt_s, BulletWorld& world, MachineState& state);

}  // namespace headland

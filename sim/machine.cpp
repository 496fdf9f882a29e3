#include "sim/machine.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

PerMotor<double> motor_speeds_now(const Machine& machine, const PerWheel<WheelContact>& contacts,
                                  const PerWheel<WheelState>& states,
                                  const Eigen::Vector3d& omega_W) {
  PerWheel<double> relative{};
  for (std::size_t i = 0; i < kWheels; ++i) {
    relative[i] = states[i].spin_rad_per_s - omega_W.dot(contacts[i].axle);
  }
  return motor_speeds(machine.motors, relative, machine.vehicle.drivetrain.gear_ratio);
}

// Electrical power [W] of the implement's shaft and of lifting it.
double implement_power_w(const Implement& implement, const DriverCommand& command) {
  double power_w = command.working ? shaft_power_w(implement) / implement.shaft_efficiency : 0.0;
  if (command.lifting && implement.lift_time_s > 0.0) {
    power_w += implement.lift_energy_j / implement.lift_time_s;
  }
  return power_w;
}

// Electrical power [W] of the steering actuator: in proportion to how fast it turns.
double steering_power_w(const Steering& steering, double rate_rad_per_s) {
  if (steering.max_rate_rad_per_s <= 0.0) return 0.0;
  return steering.actuator_power_w * std::abs(rate_rad_per_s) /
         (steering.max_rate_rad_per_s * steering.actuator_efficiency);
}

void charge(EnergyBalance& balance, EnergyCause cause, double energy_j) {
  balance.cause_j[static_cast<std::size_t>(cause)] += energy_j;
}

StoredEnergy sum(const StoredEnergy& a, const StoredEnergy& b) {
  return {a.grade_j + b.grade_j, a.kinetic_j + b.kinetic_j, a.spring_j + b.spring_j};
}

// What the vehicle's step tells of a trailed implement.
void report_trailer(const TrailerStep& step, StepReport& report) {
  report.trailer = step.before;
  report.hitch_angle_rad = hitch_angle_rad(report.chassis, step.before);
  report.draft_n = step.draft_n;
  report.stored = sum(report.stored, step.stored);
  const double left_n = step.contacts[0].load_n;
  const double right_n = step.contacts[1].load_n;
  if (left_n + right_n > 0.0) {
    report.trailer_load_transfer_ratio = (left_n - right_n) / (left_n + right_n);
  }
  for (std::size_t i = 0; i < kTrailerWheels; ++i) {
    report.trailer_on_terrain = report.trailer_on_terrain && step.contacts[i].on_terrain;
  }
}

}  // namespace

Machine make_machine(const Vehicle& vehicle, const Heightfield& terrain, const SoilMap& soil) {
  const ChassisMass mass = chassis_mass(vehicle);
  return {vehicle,
          terrain,
          soil,
          mass,
          define_wheels(vehicle, mass),
          motor_layout(vehicle),
          make_belly(vehicle, mass, terrain),
          make_trailer(vehicle, mass)};
}

ChassisState place_on_ground(const Machine& machine, const Eigen::Vector2d& p_W,
                             double heading_rad) {
  const Eigen::Vector2d ahead(std::cos(heading_rad), std::sin(heading_rad));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  PerWheel<Eigen::Vector3d> foot;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const Eigen::Vector3d hub_B = machine.wheels[i].hub_C + machine.mass.com_B;
    const Eigen::Vector2d place = p_W + hub_B.x() * ahead + hub_B.y() * left;
    foot[i] = {place.x(), place.y(), surface_at(machine.terrain, place.x(), place.y()).height_m};
  }
  const Eigen::Vector3d rear = 0.5 * (foot[0] + foot[1]);
  const Eigen::Vector3d front = 0.5 * (foot[2] + foot[3]);
  const Eigen::Vector3d x_axis = (front - rear).normalized();
  const Eigen::Vector3d across = foot[0] - foot[1];
  const Eigen::Vector3d z_axis = x_axis.cross(across).normalized();
  ChassisState state;
  state.R_WB.col(0) = x_axis;
  state.R_WB.col(1) = z_axis.cross(x_axis);
  state.R_WB.col(2) = z_axis;
  const double rear_x_m = machine.vehicle.rear.x_B_m;
  const Eigen::Vector3d origin =
      rear - rear_x_m / (machine.vehicle.front.x_B_m - rear_x_m) * (front - rear);
  state.p_WC = origin + state.R_WB * machine.mass.com_B;
  // On a slope the tyres carry less than on the flat: stand that much higher, or the body bounces.
  const double c = z_axis.z();
  const double sag_m = machine.wheels[0].free_radius_m - machine.wheels[0].radius_m;
  state.p_WC.z() += sag_m * (1.0 / c - c * c);
  return state;
}

void stand(const Machine& machine, const Eigen::Vector2d& p_W, double heading_rad,
           BulletWorld& world) {
  const ChassisState chassis = place_on_ground(machine, p_W, heading_rad);
  world.set_state(chassis);
  if (machine.trailer) {
    world.set_trailer_state(place_trailer(*machine.trailer, machine.terrain, chassis));
  }
}

StoredEnergy energy_now(const Machine& machine, const BulletWorld& world, const MachineState& state,
                        double steer_rad, double dt_s) {
  const ChassisState chassis = world.state();
  const auto contacts = touch_ground(machine.terrain, chassis, machine.wheels,
                                     curvature_of(machine.vehicle, steer_rad));
  const auto belly = touch_belly(machine.belly, machine.terrain, chassis).contacts;
  const StoredEnergy own = stored_energy(machine.mass, chassis, machine.wheels, state.wheels,
                                         contacts, belly_spring_j(machine.belly, belly));
  if (!machine.trailer) return own;
  const Trailer& trailer = *machine.trailer;
  const ChassisState trailed = world.trailer_state();
  return sum(own, trailer_energy(trailer, trailed, state.trailer_wheels,
                                 touch_ground(machine.terrain, trailed, trailer.own_wheels(), 0.0),
                                 pin_force(trailer, chassis, trailed, dt_s)));
}

Eigen::Vector3d origin_of(const ChassisState& chassis, const ChassisMass& mass) {
  return chassis.p_WC - chassis.R_WB * mass.com_B;
}

StepReport step_machine(const Machine& machine, const DriverCommand& command, Steer steer,
                        double lowered, double dt_s, BulletWorld& world, MachineState& state) {
  const Vehicle& vehicle = machine.vehicle;
  StepReport report;
  report.chassis = world.state();
  const ChassisState& chassis = report.chassis;
  report.contacts = touch_ground(machine.terrain, chassis, machine.wheels,
                                 curvature_of(vehicle, steer.angle_rad));
  report.belly = watch_belly(machine.belly, machine.terrain, chassis, dt_s, state.belly_clear_m);
  report.stored = stored_energy(machine.mass, chassis, machine.wheels, state.wheels,
                                report.contacts, belly_spring_j(machine.belly, report.belly));

  const double implement_w = implement_power_w(vehicle.implement, command);
  const double steering_w = steering_power_w(vehicle.steering, steer.rate_rad_per_s);
  const double other_w = vehicle.battery.auxiliary_power_w + implement_w + steering_w;
  const double inverter = vehicle.motor.inverter_efficiency;
  const double speed_mps = chassis.v_W.dot(chassis.R_WB.col(0));
  DriveRequest request;
  request.wheel_torque_nm = split_torque(vehicle, machine.motors, report.contacts,
                                         command.wheel_torque_nm, command.yaw_torque_nm);
  limit_slip(vehicle, machine.motors, machine.wheels, report.contacts, state.wheels, chassis,
             request.wheel_torque_nm);
  request.hold = command.hold;
  request.direction = command.direction;
  request.speed_mps = speed_mps;
  request.motor_speed_rad_per_s =
      motor_speeds_now(machine, report.contacts, state.wheels, chassis.omega_W);
  request.available_w =
      inverter * std::max(0.0, max_discharge_power_w(vehicle.battery, state.battery) - other_w);
  request.acceptable_w = (max_charge_power_w(vehicle.battery, state.battery) + other_w) / inverter;
  const DrivetrainCommand drivetrain =
      command_drive(vehicle, machine.motors, report.contacts, request);

  Load load;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const WheelContact& contact = report.contacts[i];
    load.add(contact.load_n * contact.normal, contact.normal_arm);
    load.torque_W -= drivetrain.wheels[i].drive_nm * contact.axle;
  }
  for (const BellyContact& contact : report.belly) {
    load.add(contact.load_n * contact.normal, contact.arm);
  }
  std::optional<TrailerStep> trailed;
  Eigen::Vector3d draft_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d draft_arm = Eigen::Vector3d::Zero();
  if (machine.trailer) {
    trailed = pull_trailer(*machine.trailer, vehicle.implement, machine.terrain, machine.soil,
                           chassis, world.trailer_state(), lowered, dt_s, state.trailer_wheels);
    load.add(trailed->pin.force_W, trailed->pin.vehicle_arm);
    report_trailer(*trailed, report);
  } else {
    draft_arm = chassis.R_WB *
                (Eigen::Vector3d(vehicle.implement.x_B_m, 0.0, vehicle.implement.draft_height_m) -
                 machine.mass.com_B);
    report.draft_n =
        draft_now_n(vehicle.implement, soil_at(machine.soil, (chassis.p_WC + draft_arm).head<2>()),
                    speed_mps, lowered);
    draft_W = -report.draft_n * chassis.R_WB.col(0);
    load.add(draft_W, draft_arm);
  }

  const Velocities free = velocities_after(chassis, machine.mass, load, dt_s);
  PerWheel<double> spin_before{};
  for (std::size_t i = 0; i < kWheels; ++i) spin_before[i] = state.wheels[i].spin_rad_per_s;
  const TyreResult tyres =
      solve_tyres(report.contacts, machine.wheels, drivetrain.wheels, machine.soil, machine.mass,
                  chassis, free.v_W, free.omega_W, dt_s, state.wheels, report.belly);
  world.step(load.force_W + tyres.force_W, load.torque_W + tyres.torque_W, dt_s,
             trailed ? trailed->load : Load{});

  const ChassisState after = world.state();
  StepLosses losses = step_losses(
      {{chassis, after, machine.wheels, report.contacts, spin_before, state.wheels, tyres},
       drivetrain.wheels,
       machine.motors,
       drivetrain.motor_nm,
       vehicle.drivetrain.gear_ratio,
       draft_W,
       draft_arm,
       report.belly});
  if (trailed) {
    charge_trailer(*machine.trailer, *trailed, world.trailer_state(), state.trailer_wheels, chassis,
                   after, losses.cause_w);
  }
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    report.energy.cause_j[i] = dt_s * losses.cause_w[i];
  }
  double motor_loss = 0.0;
  double motor_input_w = 0.0;
  for (int m = 0; m < machine.motors.motors; ++m) {
    const auto i = static_cast<std::size_t>(m);
    const double torque_nm = drivetrain.motor_nm[i];
    const double speed_rad_per_s = losses.motor_speed_rad_per_s[i];
    const double loss_w = motor_loss_w(vehicle.motor, torque_nm, speed_rad_per_s);
    // Each motor has an inverter of its own: what one gives back another does not get for free.
    const double input_w = torque_nm * speed_rad_per_s + loss_w;
    report.motor_w += input_w > 0.0 ? input_w / inverter : input_w * inverter;
    report.motor_nm += torque_nm;
    motor_loss += loss_w;
    motor_input_w += input_w;
  }
  report.battery_w = report.motor_w + other_w;
  const BatteryFlow flow = draw(vehicle.battery, report.battery_w, dt_s, state.battery);
  report.battery_v = flow.voltage_v;
  report.energy.battery_j = dt_s * flow.chemistry_w;
  charge(report.energy, EnergyCause::kBatteryLoss, dt_s * flow.loss_w);
  charge(report.energy, EnergyCause::kMotor, dt_s * motor_loss);
  charge(report.energy, EnergyCause::kInverter, dt_s * (report.motor_w - motor_input_w));
  charge(report.energy, EnergyCause::kSteering, dt_s * steering_w);
  charge(report.energy, EnergyCause::kAuxiliary, dt_s * vehicle.battery.auxiliary_power_w);
  charge(report.energy, EnergyCause::kImplement, dt_s * implement_w);
  report.slip = tyres.slip;
  for (std::size_t i = 0; i < kWheels; ++i) {
    report.scuffing_m2_per_s += machine.wheels[i].tyre.width_m * tyres.sliding_mps[i];
  }
  if (trailed) {
    for (std::size_t i = 0; i < kTrailerWheels; ++i) {
      report.scuffing_m2_per_s +=
          machine.trailer->wheels[i].tyre.width_m * trailed->tyres.sliding_mps[i];
    }
  }
  report.clipped = drivetrain.clipped;
  return report;
}

}  // namespace headland

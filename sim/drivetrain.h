// Motor, reduction gear and brakes.
#pragma once

#include "sim/tyre.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Torque that the motor gives for a request, and whether a limit cut it.
struct MotorTorque {
  double torque_nm = 0.0;
  bool clipped = false;
};

// Losses [W] of the motor: kc T^2 + ki |w| + kw |w|^3 + C (Larminie and Lowry), >= 0.
double motor_loss_w(const Motor& motor, double torque_nm, double speed_rad_per_s);

// Limits by torque, power and speed, and by the electrical power that the battery can give
// (`available_w`) or take (`acceptable_w`), both >= 0.
MotorTorque limit_motor(const Motor& motor, double wanted_nm, double speed_rad_per_s,
                        double available_w, double acceptable_w);

// Which motor turns which wheels. One motor turns all driven wheels through open differentials,
// each with the same torque; a motor at each wheel turns that one.
struct MotorLayout {
  int motors = 0;
  PerWheel<int> motor_of{};  // -1: not driven
};
MotorLayout motor_layout(const Vehicle& vehicle);

template <typename T>
using PerMotor = std::array<T, kWheels>;

// Motor speeds [rad/s] for wheel spins relative to the chassis: the mean of each motor's wheels.
PerMotor<double> motor_speeds(const MotorLayout& layout, const PerWheel<double>& relative_spin,
                              double gear_ratio);

// What the driver asks and what bounds it.
struct DriveRequest {
  PerMotor<double> wheel_torque_nm{};  // of each motor's wheels together
  bool hold = false;                   // brakes set fully
  double direction = 0.0;              // of travel that is meant: 1, -1, or 0 for neither
  double speed_mps = 0.0;              // of the vehicle along x
  PerMotor<double> motor_speed_rad_per_s{};
  double available_w = 0.0;   // electrical, all motors together, >= 0
  double acceptable_w = 0.0;  // likewise, charging
};

// Wheel torque [N m] of each motor for a force along the vehicle, given as a torque of the rear (if
// they are driven) or the front wheels, and a couple about its z axis, which only a vehicle with
// motors on both sides can give: what their torque limit leaves beside the force. Wheels of one
// side share by their loads, as wheels do that are kept at one speed, and one takes over what the
// other's motor cannot give.
PerMotor<double> split_torque(const Vehicle& vehicle, const MotorLayout& layout,
                              const PerWheel<WheelContact>& contacts, double total_nm,
                              double yaw_torque_nm);

// What the controllers of motors at the wheels do: a wheel whose rim is faster or slower than the
// ground under its hub by more than kFreeSlip of the ground speed, or kScrubbingSlip times the
// speed at which it slides sideways, gets torque against it, in proportion to what is beyond.
// Without it a light wheel of a motor of its own spins up. One motor for all wheels is left alone.
void limit_slip(const Vehicle& vehicle, const MotorLayout& layout,
                const PerWheel<WheelDefinition>& wheels, const PerWheel<WheelContact>& contacts,
                const PerWheel<WheelState>& states, const ChassisState& chassis,
                PerMotor<double>& wheel_torque_nm);
// Where tyres pull efficiently. Loose soil pulls up to half as much more at slips of 0.6, at which
// it is dug away: figures by grip (vehicle_figures.h), which take the best pull, promise that much
// more.
inline constexpr double kFreeSlip = 0.15;
inline constexpr double kFreeSlipSpeed_mps = 0.1;  // and at any speed
// Friction acts against the sliding: a wheel dragged sideways pulls along with 1 / hypot(1, 1 / 2),
// nine tenths of its grip, when it slips twice as fast along as it slides across.
inline constexpr double kScrubbingSlip = 2.0;
inline constexpr double kSlipGain_per_s = 30.0;  // speed loop: wheel inertia times this

// What one step does to motors and wheels.
struct DrivetrainCommand {
  PerMotor<double> motor_nm{};  // on the motor shafts, forward positive
  PerWheel<WheelTorques> wheels;
  bool clipped = false;
};

// Torque against the motion brakes, unless it acts in the direction that is meant: a vehicle that
// rolls back while it pulls away. Braking goes to a motor up to its regeneration fraction above the
// least speed for it, the rest to brakes: of all wheels in proportion to their load, or of the
// motor's own wheel. Pulling away is all the motor's; brakes give what it cannot.
DrivetrainCommand command_drive(const Vehicle& vehicle, const MotorLayout& layout,
                                const PerWheel<WheelContact>& contacts,
                                const DriveRequest& request);

}  // namespace headland

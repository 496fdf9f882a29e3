// A trailed implement: a second rigid body on two wheels, pulled by a pin on the vehicle.
//
// The pin is a stiff spring with damping between two points, not a constraint of Bullet's: the
// impulse of a constraint acts while its points turn about each other, which does work that no
// cause can be charged for; a spring's energy is a function of state and the ledger closes.
#pragma once

#include <optional>
#include <span>

#include "sim/chassis.h"
#include "sim/ledger.h"
#include "sim/tyre.h"
#include "sim/wheel.h"
#include "terrains/heightfield.h"
#include "terrains/soil_map.h"
#include "vehicle_models/vehicle.h"

namespace headland {

inline constexpr std::size_t kTrailerWheels = 2;  // left, right: the first two of a PerWheel

// The pin's spring is as stiff as the step allows: its quickest oscillation turns by this angle
// [rad] in a step (stable below 1.5 with this damping).
inline constexpr double kPinAnglePerStep_rad = 0.6;
inline constexpr double kPinDamping = 0.3;  // of critical

// Speed below which draft fades, to nothing at standstill.
inline constexpr double kDraftFullSpeed_mps = 0.1;

// What never changes in a run. Frame T: origin on the ground below the implement's axle, x along
// the drawbar to the pin; offsets are from the body's centre of mass.
struct Trailer {
  ChassisMass mass;  // com in T
  PerWheel<WheelDefinition> wheels;
  Eigen::Vector3d pin_on_vehicle_C = Eigen::Vector3d::Zero();  // from the vehicle's centre of mass
  Eigen::Vector3d pin_C = Eigen::Vector3d::Zero();
  Eigen::Vector3d tool_C = Eigen::Vector3d::Zero();  // working line's middle, where draft acts
  double pin_mass_kg = 0.0;  // least mass that pin and vehicle oppose each other with

  std::span<const WheelDefinition> own_wheels() const {
    return std::span(wheels).first(kTrailerWheels);
  }
};

// The vehicle's trailed implement; none when it is mounted.
std::optional<Trailer> make_trailer(const Vehicle& vehicle, const ChassisMass& vehicle_mass);

// Standing straight behind a standing vehicle, on the pin, its wheels on the ground.
ChassisState place_trailer(const Trailer& trailer, const Heightfield& terrain,
                           const ChassisState& vehicle);

// Yaw [rad] of the trailer less the vehicle's, in [-pi, pi).
double hitch_angle_rad(const ChassisState& vehicle, const ChassisState& trailer);

// The pin in one step.
struct PinForce {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();    // on the vehicle; against it on the trailer
  Eigen::Vector3d damping_W = Eigen::Vector3d::Zero();  // part of it
  Eigen::Vector3d vehicle_arm = Eigen::Vector3d::Zero();
  Eigen::Vector3d trailer_arm = Eigen::Vector3d::Zero();
  double spring_j = 0.0;
};
PinForce pin_force(const Trailer& trailer, const ChassisState& vehicle, const ChassisState& state,
                   double dt_s);

// One step of the trailer seen from outside: the state before it and the forces in it.
struct TrailerStep {
  ChassisState before;
  PerWheel<WheelContact> contacts;
  PerWheel<double> spin_before{};
  PinForce pin;
  TyreResult tyres;
  Eigen::Vector3d draft_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d draft_arm = Eigen::Vector3d::Zero();
  double draft_n = 0.0;  // forward pull, signed
  Load load;             // all on the trailer
  StoredEnergy stored;   // before, with the pin's spring
};

// Ground, pin, draft of the implement lowered by `lowered` (0..1) and tyres. Advances `wheels`, the
// states of the trailer's wheels.
TrailerStep pull_trailer(const Trailer& trailer, const Implement& implement,
                         const Heightfield& terrain, const SoilMap& soil,
                         const ChassisState& vehicle, const ChassisState& state, double lowered,
                         double dt_s, PerWheel<WheelState>& wheels);

// Energy in the trailer's stores and in the pin's spring.
StoredEnergy trailer_energy(const Trailer& trailer, const ChassisState& state,
                            const PerWheel<WheelState>& wheels,
                            const PerWheel<WheelContact>& contacts, const PinForce& pin);

// Charges what the step cost, with the bodies as they are after it: wheels, draft, and the pin's
// damping to that of the tyres.
void charge_trailer(const Trailer& trailer, const TrailerStep& step, const ChassisState& after,
                    const PerWheel<WheelState>& wheels, const ChassisState& vehicle_before,
                    const ChassisState& vehicle_after, CauseLosses& cause_w);

// Draft [N] of the implement against its tool's speed along it, lowered by a share: fades below
// kDraftFullSpeed_mps and takes the sign of the speed.
double draft_now_n(const Implement& implement, const Soil& under, double speed_mps, double lowered);

}  // namespace headland

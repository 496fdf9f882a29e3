// What a run leaves behind: the only output of simulate().
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "planner/path.h"

namespace headland {

enum class Outcome {
  kFinished,
  kStuck,
  kRolledOver,
  kJackknifed,
  kLeftField,
  kEnteredHole,
  kLeftTerrain,
  kHitObstacle,
  kBatteryEmpty,
  kTimedOut,
  kDiverged,
  kInterrupted
};

// Where the battery's energy went [J]. Losses are >= 0 in every step; grade, kinetic and stored
// (suspension springs) are changes of a store and may have either sign.
enum class EnergyCause {
  kBatteryLoss,  // R0 and the RC pair
  kAuxiliary,
  kSteering,  // steering actuator
  kInverter,
  kMotor,
  kDrivetrain,
  kBrake,
  kRolling,     // rolling resistance of the tyres
  kSlip,        // longitudinal slip
  kScrub,       // lateral slip, steering scrub
  kSuspension,  // tyre damping, and that of a trailed implement's pin
  kBelly,       // the hull's underside on the ground: friction and damping
  kDraft,       // implement draft
  kImplement,   // shaft power and lifting
  kGrade,       // potential energy of the whole machine
  kKinetic,
  kStored,
  kResidual,  // what the ledger does not account for
  kCount
};
inline constexpr std::size_t kEnergyCauses = static_cast<std::size_t>(EnergyCause::kCount);

inline constexpr double kJoulePerWattHour = 3600.0;

struct EnergyBalance {
  double battery_j = 0.0;  // drawn from the cells' chemistry (OCV times current), net of charge
  std::array<double, kEnergyCauses> cause_j{};
};

// One row of run.csv. Angles in rad, forces in N, frames as named.
struct RunSample {
  double time_s = 0.0;
  double travel_m = 0.0;  // along the driven track, either gear
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;  // nose up positive
  double roll_rad = 0.0;   // right side down positive
  double speed_mps = 0.0;  // of B along x, negative backwards
  double steer_rad = 0.0;
  double slip = 0.0;                 // worst of the driven wheels, 0..1
  double load_transfer_ratio = 0.0;  // (left - right) / total wheel load, -1..1, of the vehicle or
                                     // of a trailed implement, whichever is larger in magnitude
  double cross_track_error_m = 0.0;  // of B's origin, left of the path positive
  double motor_torque_nm = 0.0;
  double motor_power_w = 0.0;    // electrical
  double battery_power_w = 0.0;  // at the terminals, discharge positive
  double battery_voltage_v = 0.0;
  double soc = 0.0;
  double draft_n = 0.0;
  double hitch_angle_rad = 0.0;  // yaw of a trailed implement less the vehicle's
  int segment = 0;               // index into the path's segments
  bool implement_down = false;
  std::array<double, 4> wheel_load_n{};     // rear left, rear right, front left, front right
  std::array<double, 4> wheel_angle_rad{};  // spin
};

// The implement's working line on the ground while it is down: its left and right end, p_W.
struct FootprintSample {
  Eigen::Vector2d left_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d right_W = Eigen::Vector2d::Zero();
  double time_s = 0.0;
  double travel_m = 0.0;
  bool starts_strip = false;  // not joined to the footprint before it
};

// Totals of one path segment as driven.
struct SegmentRecord {
  int segment = 0;
  double start_time_s = 0.0;
  double duration_s = 0.0;
  double distance_m = 0.0;
  EnergyBalance energy;
  double cross_track_sum_m3 = 0.0;  // integral of squared error over distance [m3]
  double scuffed_m2 = 0.0;          // tread width times the way it slid, all wheels
  double slip_sum_m = 0.0;          // integral of the driven wheels' worst slip over distance
  double peak_power_w = 0.0;        // at the battery's terminals
};

// An extreme or an incident, at full time resolution.
struct Peak {
  double value = 0.0;
  double time_s = 0.0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
};

struct Peaks {
  Peak slip;                 // largest mean over kSustained_s
  Peak load_transfer_ratio;  // largest magnitude of the mean over kSustained_s, of the vehicle
                             // or of a trailed implement
  bool load_transfer_of_trailer = false;  // the largest was the implement's
  Peak cross_track_working_m;             // implement down
  Peak cross_track_turning_m;             // implement up
  Peak boundary_overrun_m;                // hull outside the boundary or in a hole, 0 when never
  bool overrun_in_hole = false;           // the largest was in a hole
  Peak belly_contact_m;                   // hull's underside below the ground, 0 when never
  Peak implement_overhang_m;              // implement, up or down, beyond the boundary
  Peak battery_power_w;
  Peak roll_rad;
  Peak pitch_rad;
  Peak min_voltage_v;
  double motor_clipped_s = 0.0;  // time at a torque, power or battery limit
  int belly_contacts = 0;        // times the belly came down on the ground
};

inline constexpr double kSustained_s = 0.5;

struct RunRecord {
  Outcome outcome = Outcome::kFinished;
  std::string outcome_detail;  // place and cause in words, empty when finished
  double duration_s = 0.0;
  double distance_m = 0.0;
  double soc_start = 1.0;
  double soc_end = 1.0;
  double rested_voltage_start_v = 0.0;
  double rested_voltage_end_v = 0.0;
  EnergyBalance energy;
  Peaks peaks;
  std::vector<RunSample> samples;
  std::vector<FootprintSample> footprints;
  std::vector<SegmentRecord> segments;  // in the order driven
};

std::string_view outcome_name(Outcome outcome);
std::string_view energy_cause_name(EnergyCause cause);

}  // namespace headland

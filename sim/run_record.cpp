#include "sim/run_record.h"

namespace headland {

std::string_view outcome_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFinished:
      return "finished";
    case Outcome::kStuck:
      return "stuck";
    case Outcome::kRolledOver:
      return "rolled over";
    case Outcome::kJackknifed:
      return "jackknifed";
    case Outcome::kLeftField:
      return "left the field";
    case Outcome::kEnteredHole:
      return "entered a hole";
    case Outcome::kLeftTerrain:
      return "left the terrain";
    case Outcome::kHitObstacle:
      return "hit an obstacle";
    case Outcome::kBatteryEmpty:
      return "battery empty";
    case Outcome::kTimedOut:
      return "timed out";
    case Outcome::kDiverged:
      return "diverged";
    case Outcome::kInterrupted:
      return "interrupted";
  }
  return "";
}

std::string_view energy_cause_name(EnergyCause cause) {
  switch (cause) {
    case EnergyCause::kBatteryLoss:
      return "battery loss";
    case EnergyCause::kAuxiliary:
      return "auxiliary";
    case EnergyCause::kSteering:
      return "steering";
    case EnergyCause::kInverter:
      return "inverter";
    case EnergyCause::kMotor:
      return "motor loss";
    case EnergyCause::kDrivetrain:
      return "drivetrain loss";
    case EnergyCause::kBrake:
      return "brake";
    case EnergyCause::kRolling:
      return "rolling resistance";
    case EnergyCause::kSlip:
      return "slip";
    case EnergyCause::kScrub:
      return "lateral scrub";
    case EnergyCause::kSuspension:
      return "tyre damping";
    case EnergyCause::kBelly:
      return "belly contact";
    case EnergyCause::kDraft:
      return "draft";
    case EnergyCause::kImplement:
      return "implement shaft and lift";
    case EnergyCause::kGrade:
      return "grade";
    case EnergyCause::kKinetic:
      return "kinetic";
    case EnergyCause::kStored:
      return "stored in tyres";
    case EnergyCause::kResidual:
      return "unaccounted";
    case EnergyCause::kCount:
      break;
  }
  return "";
}

}  // namespace headland

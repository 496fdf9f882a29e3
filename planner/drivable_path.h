// Makes plans and foreign tracks drivable for one vehicle, inside the field.
#pragma once

#include <string>
#include <vector>

#include "planner/cancel.h"
#include "planner/path.h"
#include "planner/plan.h"
#include "terrains/field.h"
#include "terrains/track.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct PathOptions {
  // Kept between hull and boundary and holes by every turn and transit, kObstacleClearances
  // (free_space.h) times as much from obstacles. Passes are not
  // moved: one that keeps less keeps what it does, and so do the turns at its ends.
  double clearance_m = 0.1;
  bool allow_overrun = false;  // record what does not fit as violations instead of refusing
  // Wheels keep off the ground of swaths driven before, between swaths (worked_rows.h).
  bool keep_off_worked = false;
  // Turns bend no faster than the vehicle steers, where such ones fit (continuous_turns.h). Refused
  // of skid steering.
  bool continuous_turns = false;
};

// Throws InputError("path", "continuous_turns", ...) for continuous turns of skid steering.
void check_path_options(const Vehicle& vehicle, const PathOptions& options);

// Joins the passes of `plan` in their order by the cheapest turn that fits: U, omega, three-point,
// any Dubins or Reeds-Shepp curve, or a route around what is in the way (hybrid A*). Swaths are
// shifted along their direction so that the implement, not the axle, works from end to end. The
// path begins at the field's entry, if it has one. With a trailed implement nothing is driven in
// reverse, and swaths have a straight run-in (run_in_m of work_line.h).
// Throws InputError for continuous turns of a skid-steered vehicle, PlanInfeasible naming the place
// and the headland width that would do when a turn does not fit and overruns are not allowed, when
// turns lead to less than half of the ground that passes would work, also for a pass without
// length; Cancelled.
Path make_path(const Field& field, const Vehicle& vehicle, const Plan& plan,
               const PathOptions& options, const CancelAsked& cancelled = {});

// What make_drivable did to a track, for the user.
struct TrackReport {
  int pieces = 0;                  // after cutting at gaps and undrivable corners
  int cut_corners = 0;             // corners tighter than the vehicle, replaced by turns
  double max_deviation_m = 0.0;    // of the driven line from the track's points
  std::vector<std::string> notes;  // each with a place
};

inline constexpr double kMinTrackTolerance_m = 0.01;
inline constexpr double kMaxTrackTolerance_m = 100.0;

// Cuts the track where it has gaps, jumps or corners tighter than the vehicle can steer, smooths
// the pieces within `tolerance_m`, and joins them like the passes of a plan. Throws PlanInfeasible
// as make_path and for a track without a piece to follow; Cancelled.
Path make_drivable(const Field& field, const Vehicle& vehicle, const Track& track,
                   double tolerance_m, const PathOptions& options, TrackReport* report,
                   const CancelAsked& cancelled = {});

}  // namespace headland

// Transits: from where the vehicle stands along a road to where it is to stand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/cancel.h"
#include "planner/drivable_path.h"
#include "planner/path.h"
#include "planner/polygon.h"
#include "planner/worked_ground.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

inline constexpr int kTransitNodes = 100000;

// Ground is where the hull may be: `leaving` from `from` to the road, `road` along it, `arriving`
// from there to `to`.
struct TransitRequest {
  // Ends of passes, driven forward with their curvature.
  std::optional<PathPoint> from;  // none: the path begins on the road
  std::optional<PathPoint> to;    // none: it ends there
  Polyline way_W;                 // of B's origin; shorter than kLeastRoad_m it is left out
  Field leaving;
  Field road;
  Field arriving;
  // Not owned; kept off between `from` and the road where a way does so. Else the wheels run over
  // them, which is recorded where overruns are allowed.
  const WorkedGround* rows = nullptr;
  int nodes = kTransitNodes;  // of all routes; a search for a way off the rows has its own
};

// Forwards along the way within kRoadTolerance_m, but for corners, which are rounded by the
// planning radius and more by clothoids; the implement up; to and from it by the cheapest turn or
// route that fits. With continuous turns asked for, bends of the road begin and end in clothoids
// where it is straight before and after; what jumps still is counted in `abrupt_turns`, and in
// `abrupt_joints` where only a bent pass at `from` or `to` makes it jump. All segments are of kind
// transit, of manoeuvre 0, and join. Throws PlanInfeasible with the place where the hull does not
// fit on the road or no turn fits, unless overruns are allowed, which are then recorded; Cancelled.
Path transit_path(const TransitRequest& request, const Vehicle& vehicle, const PathOptions& options,
                  const CancelAsked& cancelled = {});

inline constexpr double kRoadTolerance_m = 0.2;
inline constexpr double kLeastRoad_m = 6.0;

}  // namespace headland

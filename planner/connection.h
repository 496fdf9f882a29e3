// Joins two poses in a field by the cheapest curve that fits.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "planner/arcs.h"
#include "planner/cancel.h"
#include "planner/free_space.h"
#include "planner/path.h"

namespace headland {

// Between places where the hull is looked at: its corners come no deeper into anything between two
// of them than 0.01 m.
inline constexpr double kLookSpacing_m = 0.05;

// Whether the hull fits all along the arcs, looked at every kLookSpacing_m.
bool fits_along(const FreeSpace& space, const Pose& from, const std::vector<Arc>& arcs,
                double clearance_m);

// The deepest overrun along the arcs or points.
Overrun worst_overrun(const FreeSpace& space, const Pose& from, const std::vector<Arc>& arcs);
Overrun worst_overrun(const FreeSpace& space, const std::vector<PathPoint>& points);

struct ConnectionOptions {
  double radius_m = 0.0;
  double clearance_m = 0.0;  // >= -kFitTolerance_m
  CancelAsked cancelled{};
  double most_m = std::numeric_limits<double>::infinity();  // turns that cost as much are left out
  double sharpness_per_m2 = 0.0;  // most that turns may have; 0: curvature may jump
};

// The clearance [m] that both ends keep, at most `clearance_m`: no connection keeps more. Below
// -kFitTolerance_m when an end does not fit.
double clearance_between(const FreeSpace& space, const Pose& from, const Pose& to,
                         double clearance_m);

// The cheapest turn that keeps the clearance from end to end, with no more sharpness than asked for
// (continuous_turns.h); none when there is none, as when an end does not keep it.
std::optional<std::vector<Arc>> connect_by_turn(const FreeSpace& space, const Pose& from,
                                                const Pose& to, const ConnectionOptions& options);

// The cheapest turn that fits, else one whose curvature jumps, else a route by hybrid A* that
// expands at most `node_budget` nodes and takes them off it. None when neither is found. Throws
// Cancelled.
std::optional<std::vector<Arc>> connect(const FreeSpace& space, const Pose& from, const Pose& to,
                                        const ConnectionOptions& options, int& node_budget);

// The turn that overruns least for its cost (kOverrunMetreCost); always one.
std::vector<Arc> connect_overrunning(const FreeSpace& space, const Pose& from, const Pose& to,
                                     double radius_m);

// What a metre of overrun is weighed like, in metres driven.
inline constexpr double kOverrunMetreCost = 10.0;

// How far [m] the hull swings out along `outward` beyond p_W in the turn that needs least.
double least_depth_m(const FreeSpace& space, const Pose& from, const Pose& to, double radius_m,
                     const Eigen::Vector2d& p_W, const Eigen::Vector2d& outward);

// Poses nearest to a place where the hull keeps the clearance, all on the same ring about it, in 24
// headings: an entry is usually a gate in the boundary, and the path begins where there is room
// near it. None within 25 m.
std::vector<Pose> poses_near(const FreeSpace& space, const Eigen::Vector2d& p_W,
                             double clearance_m);

// Where a path keeps least of the clearance asked for.
TightestPlace tightest_place(const FreeSpace& space, const Path& path, double asked_m);

}  // namespace headland

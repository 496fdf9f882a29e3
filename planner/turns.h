// Turns from one pose to another with a given radius, in closed form.
#pragma once

#include <optional>
#include <vector>

#include "planner/arcs.h"

namespace headland {

// What a metre in reverse and a change of gear cost, in metres driven forward: reversing is about
// half as fast, and a cusp costs a stop, a gear change and turning the wheels at standstill.
inline constexpr double kReverseMetreCost = 2.0;
inline constexpr double kCuspCost_m = 5.0;

// The longest way [m] in reverse gear without a change of gear.
double longest_backing_m(const std::vector<Arc>& arcs);

// No turn goes less than this [m] in one gear between changes,
inline constexpr double kLeastRun_m = 0.1;
// or further in reverse.
inline constexpr double kLongestBacking_m = 25.0;
// Whether arcs do. `alone`: between passes, which are driven forwards, so that a short way forwards
// at either end goes on from them.
bool has_odd_run(const std::vector<Arc>& arcs, bool alone);

struct Turn {
  std::vector<Arc> arcs;
  double cost_m = 0.0;
};

double cost_m(const std::vector<Arc>& arcs);

// Every turn of these families that exists, cheapest first, each ending within 1e-6 m and rad of
// `to`: arc-line-arc and arc-arc-arc with the gears fff (all Dubins curves), frf, rff and ffr, and
// the shortest curve of Reeds and Shepp (OMPL); forward only, the Dubins curves alone. Radius in
// metres, positive.
std::vector<Turn> turns(const Pose& from, const Pose& to, double radius_m,
                        Gears gears = Gears::kBoth);

// Length of the shortest curve driven forward (Dubins 1957), by the closed forms above: OMPL's
// Dubins aborts the program where rounding spoils a word.
double forward_length_m(const Pose& from, const Pose& to, double radius_m);

// The shortest curve with both gears (Reeds and Shepp 1990), by OMPL; none when rounding spoils it.
std::optional<Turn> reeds_shepp(const Pose& from, const Pose& to, double radius_m);
double reeds_shepp_length_m(const Pose& from, const Pose& to, double radius_m);

// Turns with straight run-outs before and after them, cheapest first, those without included. For
// swath ends that are not level with each other, or boundaries askew to the swaths.
std::vector<Turn> turns_with_run_outs(const Pose& from, const Pose& to, double radius_m,
                                      Gears gears = Gears::kBoth);

// Turns that back away from `from` along its own line, and back into `to` along its own, with a
// gentle curve away from what is beside the line: out of a corner that the front stands in, into
// one that the next line begins in. `aside` says on which side of each pose there is more room, +1
// for the left. Cheapest first.
struct Aside {
  double from = 1.0;
  double to = 1.0;
};
std::vector<Turn> backing_turns(const Pose& from, const Pose& to, double radius_m,
                                const Aside& aside);

// Radius of those gentle curves, in turning radii: the rear corner swings out by a quarter then.
inline constexpr double kGentleRadius = 4.0;

}  // namespace headland

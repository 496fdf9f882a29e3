#include "planner/turns.h"

#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

namespace headland {
namespace {

namespace ob = ompl::base;

// A turn that misses its end by more than this is not a solution (rounding at degenerate poses).
constexpr double kEndTolerance = 1e-6;  // m and rad
// An arc this close to a whole circle is a zero arc spoilt by rounding; shorter pieces are dropped.
constexpr double kZeroAngle_rad = 1e-9;
constexpr double kZeroLength_m = 1e-9;
// Swath ends further from level than this many radii are not levelled by a run-out.
constexpr double kMaxLevelling = 6.0;
// Gentle curves away from what is beside a line are this long, in turning radii.
constexpr double kGentleLength = 0.7;

using GearsOfArcs = std::array<Gear, 3>;
constexpr Gear F = Gear::kForward;
constexpr Gear B = Gear::kReverse;
// Forward only first.
constexpr std::array<GearsOfArcs, 4> kGears = {{{F, F, F}, {F, B, F}, {B, F, F}, {F, F, B}}};

double sign_of(Gear gear) { return gear == Gear::kForward ? 1.0 : -1.0; }

// The arc on `side` (+1 left) that turns the body from one heading to the other in `gear`.
Arc turning_arc(double from_rad, double to_rad, double side, Gear gear, double radius_m) {
  double angle_rad = side * sign_of(gear) * (to_rad - from_rad);
  angle_rad -= 2.0 * std::numbers::pi * std::floor(angle_rad / (2.0 * std::numbers::pi));
  if (angle_rad > 2.0 * std::numbers::pi - kZeroAngle_rad) angle_rad = 0.0;
  return {angle_rad * radius_m, side / radius_m, gear};
}

std::optional<Turn> checked(const Pose& from, const Pose& to, std::vector<Arc> arcs) {
  std::erase_if(arcs, [](const Arc& arc) { return arc.length_m < kZeroLength_m; });
  const Pose end = end_of(from, arcs);
  if (!((end.p_W - to.p_W).norm() < kEndTolerance) ||
      !(std::abs(wrap_angle(end.heading_rad - to.heading_rad)) < kEndTolerance)) {
    return std::nullopt;
  }
  const double cost = cost_m(arcs);
  return Turn{std::move(arcs), cost};
}

Eigen::Vector2d circle_centre(const Pose& pose, double side, double radius_m) {
  return pose.p_W + side * radius_m * left_of(pose.heading_rad);
}

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

// Arc, line, arc: the line touches both circles, driven along its heading or against it.
void add_with_line(const Pose& from, const Pose& to, double radius_m, const GearsOfArcs& gears,
                   std::vector<Turn>& found) {
  for (const double side_a : {1.0, -1.0}) {
    for (const double side_b : {1.0, -1.0}) {
      const Eigen::Vector2d between =
          circle_centre(to, side_b, radius_m) - circle_centre(from, side_a, radius_m);
      const double across_m = (side_b - side_a) * radius_m;
      const double squared_m2 = between.squaredNorm() - across_m * across_m;
      if (squared_m2 < 0.0) continue;
      const double line_m = std::sqrt(squared_m2);
      const double heading_rad =
          angle_of(between) - std::atan2(across_m, sign_of(gears[1]) * line_m);
      auto turn = checked(from, to,
                          {turning_arc(from.heading_rad, heading_rad, side_a, gears[0], radius_m),
                           {line_m, 0.0, gears[1]},
                           turning_arc(heading_rad, to.heading_rad, side_b, gears[2], radius_m)});
      if (turn) found.push_back(std::move(*turn));
    }
  }
}

// Three arcs: the middle circle touches the outer ones, which lie on the same side.
void add_with_circle(const Pose& from, const Pose& to, double radius_m, const GearsOfArcs& gears,
                     std::vector<Turn>& found) {
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d centre_a = circle_centre(from, side, radius_m);
    const Eigen::Vector2d centre_b = circle_centre(to, side, radius_m);
    const Eigen::Vector2d between = centre_b - centre_a;
    const double distance_m = between.norm();
    if (distance_m > 4.0 * radius_m || distance_m < kZeroLength_m) continue;
    const double apex_rad = std::acos(distance_m / (4.0 * radius_m));
    for (const double apex_side : {1.0, -1.0}) {
      const Eigen::Vector2d middle =
          centre_a + 2.0 * radius_m * direction_of(angle_of(between) + apex_side * apex_rad);
      // On a circle to the left the heading is a quarter turn ahead of the spoke.
      const double quarter_rad = side * std::numbers::pi / 2.0;
      const double first_rad = angle_of(middle - centre_a) + quarter_rad;
      const double second_rad = angle_of(middle - centre_b) + quarter_rad;
      auto turn = checked(from, to,
                          {turning_arc(from.heading_rad, first_rad, side, gears[0], radius_m),
                           turning_arc(first_rad, second_rad, -side, gears[1], radius_m),
                           turning_arc(second_rad, to.heading_rad, side, gears[2], radius_m)});
      if (turn) found.push_back(std::move(*turn));
    }
  }
}

struct FreeState {
  const ob::ReedsSheppStateSpace* space;
  void operator()(ob::State* state) const { space->freeState(state); }
};

std::unique_ptr<ob::State, FreeState> state_of(const ob::ReedsSheppStateSpace& space,
                                               const Pose& pose, double radius_m) {
  std::unique_ptr<ob::State, FreeState> state(space.allocState(), FreeState{&space});
  auto* se2 = state->as<ob::SE2StateSpace::StateType>();
  se2->setXY(pose.p_W.x() / radius_m, pose.p_W.y() / radius_m);
  se2->setYaw(pose.heading_rad);
  return state;
}

// Lengths in radii.
ob::ReedsSheppStateSpace::ReedsSheppPath reeds_shepp_path(const Pose& from, const Pose& to,
                                                          double radius_m) {
  // Making one takes as long as finding the path; it knows nothing but its radius.
  static const ob::ReedsSheppStateSpace kSpace(1.0);
  const Pose from_here{from.p_W - to.p_W, from.heading_rad};
  const Pose to_here{Eigen::Vector2d::Zero(), to.heading_rad};
  return kSpace.reedsShepp(state_of(kSpace, from_here, radius_m).get(),
                           state_of(kSpace, to_here, radius_m).get());
}

void sort_by_cost(std::vector<Turn>& found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Turn& a, const Turn& b) { return a.cost_m < b.cost_m; });
}

void keep_distinct(std::vector<Turn>& found) {
  std::erase_if(found, [](const Turn& turn) { return has_odd_run(turn.arcs, true); });
  sort_by_cost(found);
  const auto same_arc = [](const Arc& a, const Arc& b) {
    return a.gear == b.gear && std::abs(a.curvature_per_m - b.curvature_per_m) < kZeroLength_m &&
           std::abs(a.length_m - b.length_m) < kEndTolerance;
  };
  const auto same = [&](const Turn& a, const Turn& b) {
    return std::equal(a.arcs.begin(), a.arcs.end(), b.arcs.begin(), b.arcs.end(), same_arc);
  };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
}

void add_closed_forms(const Pose& from, const Pose& to, double radius_m, Gears gears,
                      std::vector<Turn>& found) {
  for (const GearsOfArcs& of_arcs : kGears) {
    add_with_line(from, to, radius_m, of_arcs, found);
    add_with_circle(from, to, radius_m, of_arcs, found);
    if (gears == Gears::kForwardOnly) return;
  }
}

// Ways to leave a pose straight in `gear` and then, gently, forwards to one side; `meet_m` is where
// an arc begins that leads on, if it is reached that way.
std::vector<std::vector<Arc>> leads(Gear gear, double meet_m, double side, double radius_m) {
  std::vector<double> lengths_m = {0.0, 0.7 * radius_m, 1.5 * radius_m, 2.5 * radius_m};
  if (meet_m > 0.0 && meet_m < kMaxLevelling * radius_m) lengths_m.push_back(meet_m);
  std::vector<std::vector<Arc>> found;
  for (const double length_m : lengths_m) {
    std::vector<Arc> lead;
    if (length_m > 0.0) lead.push_back({length_m, 0.0, gear});
    found.push_back(lead);
    lead.push_back({kGentleLength * radius_m, side / (kGentleRadius * radius_m), F});
    found.push_back(std::move(lead));
  }
  return found;
}

// How far ahead of a pose its line meets that of another one; 0 where they hardly cross.
double meeting_m(const Pose& at, const Pose& other) {
  const Eigen::Vector2d across = left_of(other.heading_rad);
  const double rate = direction_of(at.heading_rad).dot(across);
  constexpr double kHardly = 0.1;
  return std::abs(rate) < kHardly ? 0.0 : (other.p_W - at.p_W).dot(across) / rate;
}

// None, some fractions of the radius, and what brings this end level with the other one.
std::vector<double> run_outs_m(double level_m, double radius_m) {
  std::vector<double> lengths_m = {0.0, 0.5 * radius_m, radius_m, 2.0 * radius_m};
  if (level_m > 0.0 && level_m < kMaxLevelling * radius_m) lengths_m.push_back(level_m);
  return lengths_m;
}

}  // namespace

double cost_m(const std::vector<Arc>& arcs) {
  return length_m(arcs) + (kReverseMetreCost - 1.0) * reverse_length_m(arcs) +
         kCuspCost_m * cusp_count(arcs);
}

double longest_backing_m(const std::vector<Arc>& arcs) {
  double longest_m = 0.0;
  double run_m = 0.0;
  for (const Arc& arc : arcs) {
    run_m = arc.gear == B ? run_m + arc.length_m : 0.0;
    longest_m = std::max(longest_m, run_m);
  }
  return longest_m;
}

bool has_odd_run(const std::vector<Arc>& arcs, bool alone) {
  double run_m = 0.0;
  bool first = true;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    run_m += arcs[i].length_m;
    const bool last = i + 1 == arcs.size();
    if (!last && arcs[i + 1].gear == arcs[i].gear) continue;
    const bool goes_on = alone && (first || last) && arcs[i].gear == F;
    if (run_m < kLeastRun_m && !goes_on) return true;
    if (run_m > kLongestBacking_m && arcs[i].gear == B) return true;
    first = false;
    run_m = 0.0;
  }
  return false;
}

std::optional<Turn> reeds_shepp(const Pose& from, const Pose& to, double radius_m) {
  const auto path = reeds_shepp_path(from, to, radius_m);
  std::vector<Arc> arcs;
  for (int i = 0; i < 5; ++i) {
    if (path.type_[i] == ob::ReedsSheppStateSpace::RS_NOP) break;
    double side = 0.0;
    if (path.type_[i] == ob::ReedsSheppStateSpace::RS_LEFT) side = 1.0;
    if (path.type_[i] == ob::ReedsSheppStateSpace::RS_RIGHT) side = -1.0;
    const Gear gear = path.length_[i] < 0.0 ? Gear::kReverse : Gear::kForward;
    arcs.push_back({std::abs(path.length_[i]) * radius_m, side / radius_m, gear});
  }
  if (has_odd_run(arcs, true)) return std::nullopt;
  return checked(from, to, std::move(arcs));
}

double reeds_shepp_length_m(const Pose& from, const Pose& to, double radius_m) {
  return reeds_shepp_path(from, to, radius_m).length() * radius_m;
}

double forward_length_m(const Pose& from, const Pose& to, double radius_m) {
  std::vector<Turn> found;
  add_with_line(from, to, radius_m, kGears[0], found);
  add_with_circle(from, to, radius_m, kGears[0], found);
  double shortest_m = std::numeric_limits<double>::max();
  for (const Turn& turn : found) shortest_m = std::min(shortest_m, turn.cost_m);
  return shortest_m;
}

std::vector<Turn> turns(const Pose& from, const Pose& to, double radius_m, Gears gears) {
  std::vector<Turn> found;
  add_closed_forms(from, to, radius_m, gears, found);
  if (gears == Gears::kBoth) {
    if (auto turn = reeds_shepp(from, to, radius_m)) found.push_back(std::move(*turn));
  }
  keep_distinct(found);
  return found;
}

std::vector<Turn> turns_with_run_outs(const Pose& from, const Pose& to, double radius_m,
                                      Gears gears) {
  const double level_out_m = direction_of(from.heading_rad).dot(to.p_W - from.p_W);
  const double level_in_m = direction_of(to.heading_rad).dot(to.p_W - from.p_W);
  std::vector<Turn> found = turns(from, to, radius_m, gears);
  std::vector<Turn> between;
  for (const double out_m : run_outs_m(level_out_m, radius_m)) {
    for (const double in_m : run_outs_m(level_in_m, radius_m)) {
      const Pose start = pose_along(from, {out_m, 0.0, F}, out_m);
      const Pose finish = pose_along(to, {in_m, 0.0, B}, in_m);
      between.clear();
      add_closed_forms(start, finish, radius_m, gears, between);
      for (Turn& turn : between) {
        std::vector<Arc>& arcs = turn.arcs;
        if (in_m > 0.0) arcs.push_back({in_m, 0.0, F});
        if (out_m > 0.0) arcs.insert(arcs.begin(), {out_m, 0.0, F});
        turn.cost_m = cost_m(arcs);
        found.push_back(std::move(turn));
      }
    }
  }
  keep_distinct(found);
  return found;
}

std::vector<Turn> backing_turns(const Pose& from, const Pose& to, double radius_m,
                                const Aside& aside) {
  const double turned_rad = std::abs(wrap_angle(to.heading_rad - from.heading_rad));
  const double tangent_m = radius_m * std::tan(0.5 * std::min(turned_rad, 0.9 * std::numbers::pi));
  std::vector<Turn> found;
  std::vector<Turn> between;
  for (const auto& out : leads(B, tangent_m - meeting_m(from, to), aside.from, radius_m)) {
    const Pose start = end_of(from, out);
    // Ways away from `to`, driven back.
    for (const auto& away : leads(F, tangent_m + meeting_m(to, from), aside.to, radius_m)) {
      const std::vector<Arc> in = driven_back(away);
      between.clear();
      add_closed_forms(start, end_of(to, away), radius_m, Gears::kBoth, between);
      for (Turn& turn : between) {
        turn.arcs.insert(turn.arcs.begin(), out.begin(), out.end());
        turn.arcs.insert(turn.arcs.end(), in.begin(), in.end());
        turn.cost_m = cost_m(turn.arcs);
        found.push_back(std::move(turn));
      }
    }
  }
  keep_distinct(found);
  return found;
}

}  // namespace headland

#include "planner/continuous_turns.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace headland {
namespace {

constexpr int kMostSteps = 25;
constexpr double kDifference = 1e-6;  // m and rad, of the quotients that Newton's steps are made of
constexpr double kLongestStep = 1.0;  // m and rad, beyond which the linear model leads astray
// Shorter pieces are left out, and smaller jumps of curvature are none.
constexpr double kNothing_m = 1e-9;
constexpr double kNoJump_per_m = 1e-6;
// Lines that turn less than this against each other, or about, meet in no corner.
constexpr double kNoTurn_rad = 1e-6;
// Curvature for angles as small as these is taken to be that of a line.
constexpr double kStraight_per_m = 1e-9;

// A piece of a turn with one unknown: the length of a line, the angle of an arc.
struct Piece {
  double curvature_per_m = 0.0;
  Gear gear = Gear::kForward;
  bool ramps_in = false;
  bool ramps_out = false;
};

using Unknowns = Eigen::VectorXd;

bool is_line(const Piece& piece) { return std::abs(piece.curvature_per_m) < kStraight_per_m; }

void append_piece(const Piece& piece, double unknown, double sharpness_per_m2,
                  std::vector<Arc>& arcs) {
  const auto add = [&](double length_m, double curvature_per_m, double sharpness) {
    if (length_m > kNothing_m) arcs.push_back({length_m, curvature_per_m, piece.gear, sharpness});
  };
  if (is_line(piece)) {
    add(unknown, 0.0, 0.0);
    return;
  }
  const double side = piece.curvature_per_m > 0.0 ? 1.0 : -1.0;
  const int ramps = (piece.ramps_in ? 1 : 0) + (piece.ramps_out ? 1 : 0);
  double most_per_m = std::abs(piece.curvature_per_m);
  const double in_ramps_rad = 0.5 * ramps * most_per_m * most_per_m / sharpness_per_m2;
  double arc_m = (unknown - in_ramps_rad) / most_per_m;
  if (ramps > 0 && arc_m < 0.0) {
    most_per_m = std::sqrt(2.0 * std::max(0.0, unknown) * sharpness_per_m2 / ramps);
    arc_m = 0.0;
  }
  const double ramp_m = most_per_m / sharpness_per_m2;
  if (piece.ramps_in) add(ramp_m, 0.0, side * sharpness_per_m2);
  add(arc_m, side * most_per_m, 0.0);
  if (piece.ramps_out) add(ramp_m, side * most_per_m, -side * sharpness_per_m2);
}

std::vector<Arc> arcs_of(const std::vector<Piece>& pieces, const Unknowns& unknowns,
                         double sharpness_per_m2) {
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    append_piece(pieces[i], unknowns[static_cast<Eigen::Index>(i)], sharpness_per_m2, arcs);
  }
  return arcs;
}

Eigen::Vector3d miss(const Pose& from, const Pose& to, const std::vector<Arc>& arcs) {
  const Pose end = end_of(from, arcs);
  const Eigen::Vector2d off = end.p_W - to.p_W;
  return {off.x(), off.y(), wrap_angle(end.heading_rad - to.heading_rad)};
}

// Neighbours of the same bend and gear are one piece.
void split(const std::vector<Arc>& arcs, double tightened, std::vector<Piece>& pieces,
           std::vector<double>& unknowns) {
  for (const Arc& arc : arcs) {
    const double curvature_per_m = tightened * arc.curvature_per_m;
    const bool line = std::abs(curvature_per_m) < kStraight_per_m;
    const double unknown = line ? arc.length_m : arc.length_m * std::abs(arc.curvature_per_m);
    const bool same = !pieces.empty() && pieces.back().gear == arc.gear &&
                      std::abs(pieces.back().curvature_per_m - curvature_per_m) < kNoJump_per_m;
    if (same) {
      unknowns.back() += unknown;
    } else {
      pieces.push_back({line ? 0.0 : curvature_per_m, arc.gear});
      unknowns.push_back(unknown);
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Gear before = i == 0 ? Gear::kForward : pieces[i - 1].gear;
    const Gear after = i + 1 == pieces.size() ? Gear::kForward : pieces[i + 1].gear;
    pieces[i].ramps_in = before == pieces[i].gear;
    pieces[i].ramps_out = after == pieces[i].gear;
  }
}

}  // namespace

double turning_sharpness_per_m2(const Vehicle& vehicle) {
  if (vehicle.steering.kind == SteeringKind::kSkid) return 0.0;
  constexpr double kSmall_rad = 1e-4;
  const double per_rad = curvature_of(vehicle, kSmall_rad) / kSmall_rad;
  return per_rad * vehicle.steering.max_rate_rad_per_s / vehicle.driver.turn_speed_mps;
}

std::optional<Turn> continuous_turn(const Pose& from, const Pose& to, const std::vector<Arc>& arcs,
                                    double sharpness_per_m2, double tightened) {
  std::vector<Piece> pieces;
  std::vector<double> first;
  split(arcs, tightened, pieces, first);
  if (pieces.empty()) return std::nullopt;
  Unknowns unknowns =
      Eigen::Map<const Unknowns>(first.data(), static_cast<Eigen::Index>(first.size()));
  Eigen::Matrix<double, 3, Eigen::Dynamic> slopes(3, unknowns.size());
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Vector3d off = miss(from, to, arcs_of(pieces, unknowns, sharpness_per_m2));
    if (off.cwiseAbs().maxCoeff() < kContinuousEnd) {
      Turn turn{arcs_of(pieces, unknowns, sharpness_per_m2), 0.0};
      if (has_odd_run(turn.arcs, true)) return std::nullopt;
      turn.cost_m = cost_m(turn.arcs);
      return turn;
    }
    for (Eigen::Index i = 0; i < unknowns.size(); ++i) {
      Unknowns moved = unknowns;
      moved[i] += kDifference;
      slopes.col(i) =
          (miss(from, to, arcs_of(pieces, moved, sharpness_per_m2)) - off) / kDifference;
    }
    // Of more unknowns than three the nearest solution.
    Unknowns by = slopes.completeOrthogonalDecomposition().solve(-off);
    const double most = by.cwiseAbs().maxCoeff();
    if (!std::isfinite(most)) return std::nullopt;
    if (most > kLongestStep) by *= kLongestStep / most;
    unknowns = (unknowns + by).cwiseMax(0.0);
  }
  return std::nullopt;
}

double ramped_radius_m(double radius_m, double sharpness_per_m2) {
  const double curvature_per_m = 1.0 / radius_m;
  const Arc ramp{curvature_per_m / sharpness_per_m2, 0.0, Gear::kForward, sharpness_per_m2};
  const Pose end = end_of({}, {ramp});
  return (end.p_W + radius_m * left_of(end.heading_rad)).norm();
}

std::vector<Arc> with_ramps(const std::vector<Arc>& arcs, double sharpness_per_m2) {
  std::vector<Arc> ramped = arcs;
  const auto is_line = [&](std::size_t i) {
    return i < arcs.size() && arcs[i].curvature_per_m == 0.0 && arcs[i].sharpness_per_m2 == 0.0;
  };
  std::vector<std::vector<Arc>> bends(arcs.size());  // in place of arcs
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const double turn_rad = std::abs(arcs[i].length_m * arcs[i].curvature_per_m);
    if (i == 0 || !is_line(i - 1) || !is_line(i + 1)) continue;
    if (!(turn_rad > kNoTurn_rad && turn_rad < std::numbers::pi - kNoTurn_rad)) continue;
    const double side = arcs[i].curvature_per_m > 0.0 ? 1.0 : -1.0;
    const double curvature_per_m =
        std::min(std::abs(arcs[i].curvature_per_m), std::sqrt(turn_rad * sharpness_per_m2));
    const double ramp_m = curvature_per_m / sharpness_per_m2;
    const std::vector<Arc> bend = {
        {ramp_m, 0.0, Gear::kForward, side * sharpness_per_m2},
        {std::max(0.0, turn_rad / curvature_per_m - ramp_m), side * curvature_per_m},
        {ramp_m, side * curvature_per_m, Gear::kForward, -side * sharpness_per_m2}};
    // From where either bend begins to the corner of the lines.
    const auto to_corner_m = [&](const std::vector<Arc>& of) {
      const Pose end = end_of({}, of);
      return end.p_W.x() - end.p_W.y() / std::tan(end.heading_rad);
    };
    const double earlier_m = to_corner_m(bend) - to_corner_m({arcs[i]});
    if (!(std::min(ramped[i - 1].length_m, ramped[i + 1].length_m) >= earlier_m)) continue;
    ramped[i - 1].length_m -= earlier_m;
    ramped[i + 1].length_m -= earlier_m;
    bends[i] = bend;
  }
  std::vector<Arc> result;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (bends[i].empty()) {
      result.push_back(ramped[i]);
    } else {
      result.insert(result.end(), bends[i].begin(), bends[i].end());
    }
  }
  return result;
}

bool is_continuous(const std::vector<Arc>& arcs) {
  double curvature_per_m = 0.0;
  Gear gear = Gear::kForward;
  for (const Arc& arc : arcs) {
    const bool stops = arc.gear != gear;
    if (!stops && std::abs(arc.curvature_per_m - curvature_per_m) > kNoJump_per_m) return false;
    curvature_per_m = end_curvature_per_m(arc);
    gear = arc.gear;
  }
  return gear == Gear::kReverse || std::abs(curvature_per_m) <= kNoJump_per_m;
}

int abrupt_joints(const std::vector<Arc>& arcs, double before_per_m, double after_per_m) {
  if (arcs.empty()) return 0;
  const auto jumps = [](const Arc& arc, double arc_per_m, double pass_per_m) {
    return arc.gear == Gear::kForward && std::abs(arc_per_m - pass_per_m) > kJointJump_per_m;
  };
  const Arc& first = arcs.front();
  const Arc& last = arcs.back();
  return (jumps(first, first.curvature_per_m, before_per_m) ? 1 : 0) +
         (jumps(last, end_curvature_per_m(last), after_per_m) ? 1 : 0);
}

}  // namespace headland

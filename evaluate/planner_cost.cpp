#include "evaluate/planner_cost.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "sim/run_record.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr double kSame = 1e-6;  // relative, of speeds that are written with 7 digits
constexpr double kTold = 0.01;  // relative difference of a width or radius that is told
constexpr double kJ = 1.0 / kJoulePerWattHour;

bool finished(const MeasuredCost& cost) { return cost.outcome == Outcome::kFinished; }

bool is_straight(const MeasuredCost& cost, bool down) {
  return cost.manoeuvre.kind == ManoeuvreKind::kStraight && cost.manoeuvre.implement_down == down &&
         finished(cost) && cost.distance_m.mean > 0.0;
}

double straight_wh_per_m(const MeasuredCost& cost) {
  return kJ * cost.energy_j.mean / cost.distance_m.mean;
}

// Between the speeds measured linear, beyond as at the nearest.
double at_speed(const std::map<double, double>& by_speed, double speed_mps) {
  const auto above = by_speed.lower_bound(speed_mps * (1.0 - kSame));
  if (above == by_speed.end()) return by_speed.rbegin()->second;
  if (above == by_speed.begin() || above->first <= speed_mps * (1.0 + kSame)) return above->second;
  const auto below = std::prev(above);
  const double share = (speed_mps - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

SlopeCost slope_cost(const CostTable& table, bool down, double speed_mps,
                     const std::string& source) {
  std::map<double, std::map<double, double>> by_slope;
  for (const MeasuredCost& cost : table.costs) {
    if (!is_straight(cost, down) || cost.manoeuvre.slope_across != 0.0) continue;
    by_slope[cost.manoeuvre.slope_along][cost.manoeuvre.speed_mps] = straight_wh_per_m(cost);
  }
  SlopeCost slopes;
  for (const auto& [slope, by_speed] : by_slope) {
    slopes.slope.push_back(slope);
    slopes.wh_per_m.push_back(at_speed(by_speed, speed_mps));
  }
  if (!by_slope.contains(0.0)) {
    throw InputError(source, "costs", "",
                     fmt::format("a finished straight on the flat with the implement {} is needed",
                                 down ? "down" : "raised"));
  }
  // Least squares through the flat: over a side slope of s costs grow by across s^2.
  double above = 0.0;
  double below = 0.0;
  for (const MeasuredCost& cost : table.costs) {
    const double across = cost.manoeuvre.slope_across;
    if (!is_straight(cost, down) || across == 0.0 || cost.manoeuvre.slope_along != 0.0) continue;
    const double flat = at_speed(by_slope[0.0], cost.manoeuvre.speed_mps);
    above += (straight_wh_per_m(cost) - flat) * across * across;
    below += across * across * across * across;
  }
  slopes.across_wh_per_m = below > 0.0 ? std::max(above / below, 0.0) : 0.0;
  return slopes;
}

std::optional<MeasuredCost> find(const CostTable& table, ManoeuvreKind kind, bool down) {
  for (const MeasuredCost& cost : table.costs) {
    if (cost.manoeuvre.kind == kind && cost.manoeuvre.implement_down == down && finished(cost)) {
      return cost;
    }
  }
  return std::nullopt;
}

MeasuredCost needed(const CostTable& table, ManoeuvreKind kind, bool down,
                    const std::string& source) {
  if (const auto cost = find(table, kind, down)) return *cost;
  throw InputError(source, "costs", "",
                   fmt::format("a finished {} with the implement {} is needed",
                               manoeuvre_name(kind), down ? "down" : "raised"));
}

std::optional<RowTurn> row_turn_of(ManoeuvreKind kind) {
  switch (kind) {
    case ManoeuvreKind::kUTurn:
      return RowTurn::kU;
    case ManoeuvreKind::kOmegaTurn:
      return RowTurn::kOmega;
    case ManoeuvreKind::kThreePointTurn:
      return RowTurn::kThreePoint;
    case ManoeuvreKind::kPivotTurn:
      return RowTurn::kPivot;
    default:
      return std::nullopt;
  }
}

// Cycles, quarters of circles, cusps and quarters on the spot of a turn, as predicted_energy counts
// them.
Eigen::RowVector4d parts_of(const RowTurnCost& turn, double radius_m) {
  constexpr double kHalf = 2.0;  // quarters
  switch (turn.kind) {
    case RowTurn::kU:
      return {1.0, kHalf, 0.0, 0.0};
    case RowTurn::kOmega: {
      const double out_rad = std::acos((radius_m + 0.5 * turn.row_spacing_m) / (2.0 * radius_m));
      return {1.0, kHalf + 4.0 * out_rad / (0.5 * M_PI), 0.0, 0.0};
    }
    case RowTurn::kThreePoint:
      return {1.0, kHalf, 2.0, 0.0};
    case RowTurn::kPivot:
      break;
  }
  return {1.0, 0.0, 0.0, kHalf};
}

// Least squares over all that was measured with the implement raised between; parts that nothing
// tells of cost nothing, and so do those that come out below it.
MovementCost fitted(const DriveCost& cost, double cycle_wh, double quarter_wh) {
  const auto rows = static_cast<Eigen::Index>(cost.row_turns.size()) + 2;
  Eigen::MatrixX4d parts(rows, 4);
  Eigen::VectorXd wh(rows);
  parts.row(0) = Eigen::RowVector4d(1.0, 0.0, 0.0, 0.0);
  wh(0) = cycle_wh;
  parts.row(1) = Eigen::RowVector4d(0.0, 1.0, 0.0, 0.0);
  wh(1) = quarter_wh;
  for (Eigen::Index i = 2; i < rows; ++i) {
    const RowTurnCost& turn = cost.row_turns[static_cast<std::size_t>(i - 2)];
    parts.row(i) = parts_of(turn, cost.turning_radius_m);
    wh(i) = turn.extra_wh;
  }
  const Eigen::Vector4d fit = parts.completeOrthogonalDecomposition().solve(wh).cwiseMax(0.0);
  return {fit(0), fit(1), fit(2), fit(3)};
}

// Of a stop, beyond driving as far in the same state; the table has it beyond driving raised.
double extra_of_stop(const MeasuredCost& stop, const DriveCost& cost) {
  const SlopeCost& steady = stop.manoeuvre.implement_down ? cost.working : cost.raised;
  return kJ * stop.energy_j.mean - stop.distance_m.mean * wh_per_m(steady, 0.0);
}

bool all_finite(const DriveCost& cost) {
  double sum = cost.bend_wh + cost.stop_working_wh + cost.stop_raised_wh;
  for (const SlopeCost* slopes : {&cost.working, &cost.raised, &cost.transit}) {
    for (const double wh : slopes->wh_per_m) sum += wh;
  }
  for (const RowTurnCost& turn : cost.row_turns) sum += turn.extra_wh + turn.length_m;
  return std::isfinite(sum);
}

}  // namespace

DriveCost drive_cost_of(const CostTable& table, const Vehicle& vehicle, const std::string& source) {
  DriveCost cost;
  cost.turning_radius_m = table.turning_radius_m;
  cost.implement_x_m = vehicle.implement.x_B_m;
  cost.forward_only = vehicle.implement.trailing.has_value();
  cost.working = slope_cost(table, true, table.work_speed_mps, source);
  cost.raised = slope_cost(table, false, table.work_speed_mps, source);
  cost.transit = slope_cost(table, false, vehicle.driver.transit_speed_mps, source);
  const MeasuredCost bend = needed(table, ManoeuvreKind::kTurn90, true, source);
  cost.bend_wh =
      std::max(0.0, kJ * bend.energy_j.mean - bend.distance_m.mean * wh_per_m(cost.working, 0.0));
  for (const bool down : {true, false}) {
    const auto stop = find(table, ManoeuvreKind::kStopStart, down);
    if (!stop) continue;
    (down ? cost.stop_working_wh : cost.stop_raised_wh) = std::max(0.0, extra_of_stop(*stop, cost));
  }
  for (const MeasuredCost& turn : table.costs) {
    const auto kind = row_turn_of(turn.manoeuvre.kind);
    if (!kind || !finished(turn)) continue;
    cost.row_turns.push_back({*kind, turn.manoeuvre.row_spacing_m, turn.distance_m.mean,
                              kJ * turn.marginal_energy_j.mean});
  }
  cost.movement = fitted(
      cost, kJ * needed(table, ManoeuvreKind::kImplementCycle, true, source).marginal_energy_j.mean,
      kJ * needed(table, ManoeuvreKind::kTurn90, false, source).marginal_energy_j.mean);
  if (all_finite(cost)) return cost;
  throw InputError(source, "costs", "", "costs that are finite numbers are needed");
}

DriveCost read_drive_cost(const std::filesystem::path& file, const Vehicle& vehicle,
                          const std::string& soil, std::vector<std::string>& notes) {
  const CostTable table = read_cost_table(file);
  if (table.vehicle != vehicle.name) {
    throw InputError(file.string(), "vehicle", table.vehicle,
                     fmt::format("costs of {} are needed: headland measure --vehicle {}",
                                 vehicle.name, vehicle.name));
  }
  const auto differ = [](double one, double other) {
    return std::abs(one - other) > kTold * std::abs(other);
  };
  if (differ(table.working_width_m, vehicle.implement.working_width_m)) {
    notes.push_back(fmt::format("costs: measured with {:g} m, planned with {:g} m",
                                table.working_width_m, vehicle.implement.working_width_m));
  }
  if (differ(table.turning_radius_m, planning_turning_radius_m(vehicle))) {
    notes.push_back(
        fmt::format("costs: measured with turns of {:.2f} m radius, planned with {:.2f} m",
                    table.turning_radius_m, planning_turning_radius_m(vehicle)));
  }
  if (table.soil != soil) {
    notes.push_back(fmt::format("costs: measured on {}, planned for {}", table.soil, soil));
  }
  return drive_cost_of(table, vehicle, file.string());
}

}  // namespace headland

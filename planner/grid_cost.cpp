#include "planner/grid_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "planner/grid_prices.h"
#include "terrains/input_error.h"
#include "terrains/parameter.h"

namespace headland {
namespace {

constexpr double kSecondsPerHour = 3600.0;

using NamedValue = std::pair<std::string_view, double>;

void check_weights(const std::array<NamedValue, 3>& weights, const std::string& source,
                   const std::string& where) {
  double sum = 0.0;
  for (const auto& [name, value] : weights) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw InputError(source, key_path(where, std::string(name)), fmt::format("{}", value),
                       "a weight, a finite number from 0 up");
    }
    sum += value;
  }
  if (!(sum > 0.0)) {
    throw InputError(source, key_path(where, std::string(weights.front().first)), "0",
                     fmt::format("more than 0, or {} or {} is: all are zero", weights[1].first,
                                 weights[2].first));
  }
}

// Q of Eq (18) with the quarter circle's time of Eq (19).
double energy_of_turn(const TractorEnergy& tractor, double cell_m) {
  const double time_s = std::numbers::pi * cell_m / (2.0 * tractor.turn_speed_m_s);
  return tractor.voltage_v * tractor.turn_current_a / kSecondsPerHour * time_s;
}

// What the terms of each objective take where costs were measured.
CostShares measured_shares(const GridCost& cost, int cells, double cell_m) {
  const GridPrices prices = grid_prices(*cost.measured, cell_m);
  CostShares shares;
  shares.turn = prices.turn;
  shares.u_turn = prices.u_turn;
  switch (cost.objective) {
    case GridObjective::kLength:
      shares = {};
      shares.step = 1.0;
      return shares;
    case GridObjective::kWeighted:
      shares.step = prices.step;
      shares.constant = -prices.step * (cells - 1);
      return shares;
    case GridObjective::kTractor:
      shares.level = prices.level_wh_per_m;
      shares.climb = prices.climb_wh_per_m;
      shares.u_turn = 2.0 * prices.turn;
      return shares;
    case GridObjective::kMeasured:
      break;
  }
  shares.step = prices.step;
  shares.constant = prices.cell * cells;
  // Two turns into the next row are one movement.
  shares.turn = prices.corner;
  shares.row_change = std::min(2.0 * (prices.turn - prices.corner), 0.0);
  return shares;
}

double least_price(const GridGraph& graph) {
  double least = std::numeric_limits<double>::infinity();
  for (int node = 0; node < graph.size(); ++node) {
    for (int direction = 0; direction < kDirections; ++direction) {
      if (at(at(graph.beside, node), direction) < 0) continue;
      least = std::min(least, at(at(graph.step_wh, node), direction));
    }
  }
  return std::isfinite(least) ? least : 0.0;  // a single cell has no steps
}

}  // namespace

std::string_view grid_objective_name(GridObjective objective) {
  switch (objective) {
    case GridObjective::kLength:
      return "length";
    case GridObjective::kWeighted:
      return "weighted";
    case GridObjective::kTractor:
      return "tractor";
    case GridObjective::kMeasured:
      break;
  }
  return "measured";
}

GridWeights weights_of(const GridCost& cost, double cell_m) {
  if (!cost.measured) return cost.weights;
  const GridPrices prices = grid_prices(*cost.measured, cell_m);
  return {prices.step, prices.turn, prices.u_turn};
}

void check_grid_cost(const GridCost& cost, const std::string& source, const std::string& where) {
  if (cost.objective == GridObjective::kMeasured && !cost.measured) {
    throw InputError(source, key_path(where, "objective"), "measured",
                     "a file with measured costs is needed for it (headland measure writes one)");
  }
  const TractorEnergy& tractor = cost.tractor;
  check_weights({NamedValue{"repeat", cost.weights.repeat}, NamedValue{"turn", cost.weights.turn},
                 NamedValue{"u_turn", cost.weights.u_turn}},
                source, where);
  check_weights({NamedValue{"tractor.length_weight", tractor.length_weight},
                 NamedValue{"tractor.height_weight", tractor.height_weight},
                 NamedValue{"tractor.turn_weight", tractor.turn_weight}},
                source, where);
  for (const auto& [name, value] : {NamedValue{"tractor.mass_kg", tractor.mass_kg},
                                    NamedValue{"tractor.friction", tractor.friction},
                                    NamedValue{"tractor.gravity_m_s2", tractor.gravity_m_s2},
                                    NamedValue{"tractor.turn_speed_m_s", tractor.turn_speed_m_s},
                                    NamedValue{"tractor.voltage_v", tractor.voltage_v},
                                    NamedValue{"tractor.turn_current_a", tractor.turn_current_a}}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw InputError(source, key_path(where, std::string(name)), fmt::format("{}", value),
                     "a positive number");
  }
}

CostShares cost_shares(const GridCost& cost, const GridGraph& graph) {
  CostShares shares;
  if (cost.measured) {
    shares = measured_shares(cost, graph.size(), graph.cell_m);
    if (!graph.step_wh.empty()) shares.step = least_price(graph);
    // Without heights the slope's share is a step's.
    if (graph.height_m.empty()) shares.step += graph.cell_m * std::exchange(shares.level, 0.0);
    if (graph.height_m.empty()) shares.climb = 0.0;
  } else if (cost.objective == GridObjective::kLength) {
    shares.step = 1.0;
  } else if (cost.objective == GridObjective::kWeighted) {
    shares.step = cost.weights.repeat;
    shares.constant = -cost.weights.repeat * (graph.size() - 1);
    shares.turn = cost.weights.turn;
    shares.u_turn = cost.weights.u_turn;
  } else {
    const TractorEnergy& tractor = cost.tractor;
    const double weight_n = tractor.mass_kg * tractor.gravity_m_s2;
    const double per_metre = tractor.length_weight * tractor.friction * weight_n;
    if (graph.height_m.empty()) {
      shares.step = per_metre * graph.cell_m;
    } else {
      shares.level = per_metre;
      shares.climb = tractor.height_weight * weight_n;
    }
    shares.turn = tractor.turn_weight * energy_of_turn(tractor, graph.cell_m);
    shares.u_turn = 2.0 * shares.turn;
  }
  return shares;
}

double cost_of(const GridCost& cost, const GridCounts& counts, double cell_m) {
  if (cost.measured) {
    const CostShares shares = measured_shares(cost, counts.distinct_cells, cell_m);
    const double steps =
        cost.objective == GridObjective::kMeasured ? counts.step_wh : shares.step * counts.steps;
    return shares.constant + steps + shares.level * counts.level_m + shares.climb * counts.climb_m +
           shares.turn * counts.turns + shares.u_turn * counts.u_turns +
           shares.row_change * counts.row_changes;
  }
  const TractorEnergy& tractor = cost.tractor;
  switch (cost.objective) {
    case GridObjective::kLength:
      return counts.steps;
    case GridObjective::kWeighted:
      return cost.weights.repeat * counts.repeats + cost.weights.turn * counts.turns +
             cost.weights.u_turn * counts.u_turns;
    case GridObjective::kTractor:
    case GridObjective::kMeasured:  // refused without measured costs
      break;
  }
  const double weight_n = tractor.mass_kg * tractor.gravity_m_s2;
  return tractor.length_weight * tractor.friction * weight_n * counts.level_m +
         tractor.height_weight * weight_n * counts.climb_m +
         tractor.turn_weight * energy_of_turn(tractor, cell_m) *
             (counts.turns + 2 * counts.u_turns);
}

double fitness_of(double cost) { return 1.0 / std::max(cost, kLeastCost); }

}  // namespace headland

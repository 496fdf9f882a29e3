#include "planner/grid_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kSecondsPerHour = 3600.0;

using NamedValue = std::pair<std::string_view, double>;

void check_weights(const std::array<NamedValue, 3>& weights, const std::string& source) {
  double sum = 0.0;
  for (const auto& [name, value] : weights) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw InputError(source, std::string(name), fmt::format("{}", value),
                       "a weight, a finite number from 0 up");
    }
    sum += value;
  }
  if (!(sum > 0.0)) {
    throw InputError(source, std::string(weights.front().first), "0",
                     fmt::format("more than 0, or {} or {} is: all are zero", weights[1].first,
                                 weights[2].first));
  }
}

// Q of Eq (18) with the quarter circle's time of Eq (19).
double energy_of_turn(const TractorEnergy& tractor, double cell_m) {
  const double time_s = std::numbers::pi * cell_m / (2.0 * tractor.turn_speed_m_s);
  return tractor.voltage_v * tractor.turn_current_a / kSecondsPerHour * time_s;
}

}  // namespace

void check_grid_cost(const GridCost& cost, const std::string& source) {
  const TractorEnergy& tractor = cost.tractor;
  check_weights({NamedValue{"weights.repeat", cost.weights.repeat},
                 NamedValue{"weights.turn", cost.weights.turn},
                 NamedValue{"weights.u_turn", cost.weights.u_turn}},
                source);
  check_weights({NamedValue{"tractor.length_weight", tractor.length_weight},
                 NamedValue{"tractor.height_weight", tractor.height_weight},
                 NamedValue{"tractor.turn_weight", tractor.turn_weight}},
                source);
  for (const auto& [name, value] : {NamedValue{"tractor.mass_kg", tractor.mass_kg},
                                    NamedValue{"tractor.friction", tractor.friction},
                                    NamedValue{"tractor.gravity_m_s2", tractor.gravity_m_s2},
                                    NamedValue{"tractor.turn_speed_m_s", tractor.turn_speed_m_s},
                                    NamedValue{"tractor.voltage_v", tractor.voltage_v},
                                    NamedValue{"tractor.turn_current_a", tractor.turn_current_a}}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw InputError(source, std::string(name), fmt::format("{}", value), "a positive number");
  }
}

CostShares cost_shares(const GridCost& cost, const GridGraph& graph) {
  CostShares shares;
  if (cost.objective == GridObjective::kLength) {
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
  const TractorEnergy& tractor = cost.tractor;
  switch (cost.objective) {
    case GridObjective::kLength:
      return counts.steps;
    case GridObjective::kWeighted:
      return cost.weights.repeat * counts.repeats + cost.weights.turn * counts.turns +
             cost.weights.u_turn * counts.u_turns;
    case GridObjective::kTractor:
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

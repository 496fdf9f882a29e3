// What `headland tune` does: fits the weights of fitnesses to driven energies on training fields,
// and proves on held-out fields what plans made by them save.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/sweep.h"

namespace headland {

// A way to plan, under the label that its runs have.
struct TunedMethod {
  std::string label;
  PlannerChoice planner;
};

struct Tuning {
  std::filesystem::path file;  // it was read from
  std::string name;
  Sweep training;                           // each with one planner, which stands for any
  std::string training_place = "training";  // line and key, for messages
  Sweep held_out;
  std::filesystem::path costs;  // measured ones; empty: to be measured
  PlannerChoice planner;        // on grid maps, whose weights are tuned; its cost is the methods'
  std::vector<GridObjective> forms;
  // Training plans: of each of these planners on grid maps so many, by weights drawn at random.
  std::vector<std::string> plan_planners;
  int variations = 4;
  int plan_iterations = 10;
  int perturbed = 4;    // further plans, made of those
  int evaluations = 0;  // of the search by driven energy, for each form with weights
  int bootstrap_draws = 1000;
  int shuffles = 19;  // fits to shuffled energies
  std::uint64_t seed = 1;
};

// Every key: docs/tune.md. Throws InputError as read_sweep, without a training or a held-out set,
// and when a field of one is in the other under whatever label.
Tuning read_tuning(const std::filesystem::path& file);

// The runs of a set by these methods.
Sweep sweep_by(const Sweep& set, const std::string& name, const std::vector<TunedMethod>& methods);

// What a planner of the tuning plans by: a cost with the weights given, or as measured. The energy
// of all is told by the same measured costs.
PlannerChoice planner_with(const Tuning& tuning, const GridCost& cost);

// The plans that are fitted to: every planner by boustrophedon order or search, each with weights
// drawn from the tuning's seed; and of these so many drawn, perturbed (perturbed_plan.h).
std::vector<TunedMethod> training_methods(const Tuning& tuning);

std::vector<std::string> tuning_key_paths();

}  // namespace headland

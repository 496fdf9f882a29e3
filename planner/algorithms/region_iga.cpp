#include "planner/algorithms/region_iga.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "planner/indexed.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

struct IgaFactors {
  double mutation = 0.0;   // F
  double crossover = 0.0;  // C
};

RegionGenes iga_child(RegionTask& task, const RegionGenes& parent, const IgaFactors& factors) {
  RegionGenes child = parent;
  for (int gene = 0; gene < static_cast<int>(parent.size()); ++gene) {
    const double mutant = mutated_gene(task, gene, at(parent, gene), factors.mutation);
    if (draw_unit(task.random) <= factors.crossover) at(child, gene) = mutant;
  }
  repair(child);
  return child;
}

}  // namespace

double mutated_gene(RegionTask& task, int gene, double value, double mutation) {
  if (draw_unit(task.random) > mutation) return value;
  return std::round(draw_unit(task.random) * (most_of_gene(task, gene) - 1.0)) + 1.0;
}

std::span<const ParameterSpec> region_iga_parameters() {
  static const std::array kSpecs{
      region_population_spec(),
      ParameterSpec{"least_population",
                    4.0,
                    1.0,
                    5000.0,
                    {},
                    "what the population shrinks to (Np_min)",
                    true},
      ParameterSpec{"mutation", 0.1, 0.0, 1.0, {}, "probability that a gene mutates (F)"},
      ParameterSpec{"crossover", 0.1, 0.0, 1.0, {}, "probability that a child takes it (C)"}};
  return kSpecs;
}

void check_region_iga(const Parameters& parameters, const std::string& source,
                      const std::string& where) {
  const double first = number(parameters, "population");
  const double least = number(parameters, "least_population");
  if (least <= first) return;
  throw InputError(source, key_path(where, "least_population"), fmt::format("{}", least),
                   fmt::format("at most {}, the population", first));
}

RegionPlan plan_region_iga(const RegionRequest& request) {
  check_region_iga(request.parameters, kRegionPlanSource, "");
  RegionTask task(request);
  const double first = region_population(request);
  const double least = number(request.parameters, "least_population");
  const IgaFactors factors{number(request.parameters, "mutation"),
                           number(request.parameters, "crossover")};
  std::vector<RegionIndividual> population = random_individuals(task, static_cast<int>(first));
  while (next_iteration(task.search)) {
    const double size = std::round(first - (first - least) * share_over(task.search));  // Eq (6)
    std::ranges::stable_sort(population, {}, &RegionIndividual::cost);
    population.resize(std::min(population.size(), static_cast<std::size_t>(size)));
    for (RegionIndividual& parent : population) {
      if (!goes_on(task.search)) break;
      RegionIndividual child = individual_of(task, iga_child(task, parent.genes, factors));
      if (child.cost < parent.cost) parent = std::move(child);
    }
  }
  return finished_plan(task, "region_iga");
}

}  // namespace headland

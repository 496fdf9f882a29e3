#include "planner/algorithms/region_ga.h"

#include <array>
#include <utility>

#include "planner/algorithms/region_iga.h"
#include "planner/indexed.h"

namespace headland {
namespace {

std::vector<double> fitness_sums(const std::vector<RegionIndividual>& population) {
  std::vector<double> sums;
  sums.reserve(population.size());
  double sum = 0.0;
  for (const RegionIndividual& one : population) {
    sum += 1.0 / (one.cost + kNoChange);
    sums.push_back(sum);
  }
  return sums;
}

RegionGenes ga_child(RegionTask& task, const std::vector<RegionIndividual>& population,
                     const std::vector<double>& sums, double crossover, double mutation) {
  RegionGenes child = at(population, draw_by_sums(task.random, sums)).genes;
  if (draw_unit(task.random) < crossover) {
    const RegionGenes& other = at(population, draw_by_sums(task.random, sums)).genes;
    for (int i = draw_below(task.random, task.parts); i < task.parts; ++i) {
      at(child, i) = at(other, i);
      at(child, task.parts + i) = at(other, task.parts + i);
    }
  }
  for (int gene = 0; gene < static_cast<int>(child.size()); ++gene) {
    at(child, gene) = mutated_gene(task, gene, at(child, gene), mutation);
  }
  repair(child);
  return child;
}

}  // namespace

std::span<const ParameterSpec> region_ga_parameters() {
  static const std::array kSpecs{
      region_population_spec(),
      ParameterSpec{"mutation", 0.1, 0.0, 1.0, {}, "probability that a gene mutates (F)"},
      ParameterSpec{"crossover", 0.1, 0.0, 1.0, {}, "probability of a second parent (C)"}};
  return kSpecs;
}

RegionPlan plan_region_ga(const RegionRequest& request) {
  RegionTask task(request);
  const double mutation = number(request.parameters, "mutation");
  const double crossover = number(request.parameters, "crossover");
  std::vector<RegionIndividual> population = random_individuals(task, region_population(request));
  while (next_iteration(task.search)) {
    const std::vector<double> sums = fitness_sums(population);
    std::vector<RegionIndividual> next = {cheapest(population)};
    while (next.size() < population.size() && goes_on(task.search)) {
      next.push_back(individual_of(task, ga_child(task, population, sums, crossover, mutation)));
    }
    population = std::move(next);
  }
  return finished_plan(task, "region_ga");
}

}  // namespace headland

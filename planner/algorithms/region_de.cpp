#include "planner/algorithms/region_de.h"

#include <algorithm>
#include <array>
#include <utility>

#include "planner/indexed.h"

namespace headland {
namespace {

RegionGenes de_child(RegionTask& task, const std::vector<RegionIndividual>& population, int own,
                     double scaling, double crossover) {
  const int count = static_cast<int>(population.size());
  const int a = draw_another(task.random, count, {own});
  const int b = draw_another(task.random, count, {own, a});
  const int c = draw_another(task.random, count, {own, a, b});
  const auto genes_of = [&](int i) -> const RegionGenes& { return at(population, i).genes; };
  RegionGenes child = genes_of(own);
  const int always = draw_below(task.random, static_cast<int>(child.size()));
  for (int i = 0; i < static_cast<int>(child.size()); ++i) {
    if (draw_unit(task.random) >= crossover && i != always) continue;
    const double mutant = at(genes_of(a), i) + scaling * (at(genes_of(b), i) - at(genes_of(c), i));
    at(child, i) = std::clamp(mutant, 1.0, most_of_gene(task, i));
  }
  return child;
}

}  // namespace

int draw_another(SeededRandom& random, int count, std::initializer_list<int> taken) {
  int drawn = 0;
  do {
    drawn = draw_below(random, count);
  } while (std::ranges::find(taken, drawn) != taken.end());
  return drawn;
}

std::span<const ParameterSpec> region_de_parameters() {
  static const std::array kSpecs{
      region_population_spec(),
      ParameterSpec{"scaling", 0.1, 0.0, 2.0, {}, "of the difference of two (F)"},
      ParameterSpec{"crossover", 0.1, 0.0, 1.0, {}, "probability that a child takes a gene (C)"}};
  return kSpecs;
}

RegionPlan plan_region_de(const RegionRequest& request) {
  RegionTask task(request);
  const double scaling = number(request.parameters, "scaling");
  const double crossover = number(request.parameters, "crossover");
  std::vector<RegionIndividual> population = random_individuals(task, region_population(request));
  while (next_iteration(task.search)) {
    std::vector<RegionIndividual> next = population;
    for (int i = 0; i < static_cast<int>(population.size()) && goes_on(task.search); ++i) {
      RegionIndividual child =
          individual_of(task, de_child(task, population, i, scaling, crossover));
      if (child.cost <= at(population, i).cost) at(next, i) = std::move(child);
    }
    population = std::move(next);
  }
  return finished_plan(task, "region_de");
}

}  // namespace headland

#include "planner/algorithms/region_shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "planner/algorithms/region_de.h"
#include "planner/indexed.h"

namespace headland {
namespace {

constexpr double kSpread = 0.1;        // of the distributions of F and CR
constexpr double kLargestShare = 0.2;  // of the population among which pbest is drawn

double draw_normal(SeededRandom& random, double mean, double deviation) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - draw_unit(random)));
  return mean + deviation * radius * std::cos(2.0 * std::numbers::pi * draw_unit(random));
}

double draw_cauchy(SeededRandom& random, double middle, double scale) {
  return middle + scale * std::tan(std::numbers::pi * (draw_unit(random) - 0.5));
}

struct Factors {
  double scaling = 0.0;    // F
  double crossover = 0.0;  // CR
};

struct Success {
  Factors factors;
  double gain = 0.0;
};

struct History {
  std::vector<Factors> remembered;
  int next = 0;
};

Factors drawn_factors(RegionTask& task, const History& history) {
  const int slots = static_cast<int>(history.remembered.size());
  const Factors& around = at(history.remembered, draw_below(task.random, slots));
  Factors factors;
  factors.crossover = std::clamp(draw_normal(task.random, around.crossover, kSpread), 0.0, 1.0);
  do {
    factors.scaling = std::min(1.0, draw_cauchy(task.random, around.scaling, kSpread));
  } while (factors.scaling <= 0.0);
  return factors;
}

// Means weighted by what was gained: Lehmer's of F, the arithmetic one of CR.
void remember(History& history, const std::vector<Success>& successes) {
  if (successes.empty()) return;
  double weights = 0.0;
  double scaling = 0.0;
  double squares = 0.0;
  double crossover = 0.0;
  for (const auto& [factors, gain] : successes) {
    weights += gain;
    scaling += gain * factors.scaling;
    squares += gain * factors.scaling * factors.scaling;
    crossover += gain * factors.crossover;
  }
  at(history.remembered, history.next) = {squares / scaling, crossover / weights};
  history.next = (history.next + 1) % static_cast<int>(history.remembered.size());
}

struct ShadePopulation {
  std::vector<RegionIndividual> individuals;
  std::vector<int> by_length;
  std::vector<RegionGenes> archive;
};

RegionGenes shade_child(RegionTask& task, const ShadePopulation& population, int own,
                        const Factors& factors) {
  const int count = static_cast<int>(population.individuals.size());
  const double least_share = 2.0 / count;
  const double share = least_share + draw_unit(task.random) * (kLargestShare - least_share);
  const int among = std::max(1, static_cast<int>(std::lround(share * count)));
  const auto genes_of = [&](int i) -> const RegionGenes& {
    return i < count ? at(population.individuals, i).genes : at(population.archive, i - count);
  };
  const RegionGenes& best = genes_of(at(population.by_length, draw_below(task.random, among)));
  const int one = draw_another(task.random, count, {own});
  const int all = count + static_cast<int>(population.archive.size());
  const int other = draw_another(task.random, all, {own, one});
  const RegionGenes& parent = genes_of(own);
  RegionGenes child = parent;
  const int always = draw_below(task.random, static_cast<int>(child.size()));
  for (int i = 0; i < static_cast<int>(child.size()); ++i) {
    if (draw_unit(task.random) >= factors.crossover && i != always) continue;
    const double mutant =
        at(parent, i) + factors.scaling * (at(best, i) - at(parent, i) + at(genes_of(one), i) -
                                           at(genes_of(other), i));
    const double most = most_of_gene(task, i);
    at(child, i) = mutant < 1.0    ? (1.0 + at(parent, i)) / 2.0
                   : mutant > most ? (most + at(parent, i)) / 2.0
                                   : mutant;
  }
  return child;
}

void archive_parent(RegionTask& task, ShadePopulation& population, RegionGenes genes) {
  if (population.archive.size() < population.individuals.size()) {
    population.archive.push_back(std::move(genes));
    return;
  }
  const int size = static_cast<int>(population.archive.size());
  at(population.archive, draw_below(task.random, size)) = std::move(genes);
}

}  // namespace

std::span<const ParameterSpec> region_shade_parameters() {
  static const std::array kSpecs{
      region_population_spec(),
      ParameterSpec{"history", 6.0, 1.0, 1000.0, {}, "pairs remembered (H)", true},
      ParameterSpec{"scaling", 0.5, 0.01, 1.0, {}, "F to begin with"},
      ParameterSpec{"crossover", 0.7, 0.0, 1.0, {}, "C to begin with"}};
  return kSpecs;
}

RegionPlan plan_region_shade(const RegionRequest& request) {
  RegionTask task(request);
  const Factors first{number(request.parameters, "scaling"),
                      number(request.parameters, "crossover")};
  const auto slots = static_cast<std::size_t>(number(request.parameters, "history"));
  History history{std::vector<Factors>(slots, first), 0};
  ShadePopulation population{random_individuals(task, region_population(request)), {}, {}};
  population.by_length.resize(population.individuals.size());
  std::iota(population.by_length.begin(), population.by_length.end(), 0);
  while (next_iteration(task.search)) {
    std::ranges::stable_sort(population.by_length, {},
                             [&](int i) { return at(population.individuals, i).cost; });
    std::vector<RegionIndividual> next = population.individuals;
    std::vector<Success> successes;
    for (int i = 0; i < static_cast<int>(next.size()) && goes_on(task.search); ++i) {
      const Factors factors = drawn_factors(task, history);
      RegionIndividual child = individual_of(task, shade_child(task, population, i, factors));
      const double gain = at(population.individuals, i).cost - child.cost;
      if (gain < 0.0) continue;
      at(next, i) = std::move(child);
      if (gain <= kNoChange) continue;
      archive_parent(task, population, at(population.individuals, i).genes);
      successes.push_back({factors, gain});
    }
    population.individuals = std::move(next);
    remember(history, successes);
  }
  return finished_plan(task, "region_shade");
}

}  // namespace headland

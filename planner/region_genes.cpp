#include "planner/region_genes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "planner/indexed.h"

namespace headland {
namespace {

// Places of I by size, ties by place.
std::vector<int> places_by_size(const RegionGenes& genes, int parts) {
  std::vector<int> places(static_cast<std::size_t>(parts));
  std::iota(places.begin(), places.end(), 0);
  std::ranges::stable_sort(places, {}, [&](int place) { return at(genes, place); });
  return places;
}

}  // namespace

RegionTask::RegionTask(const RegionRequest& asked)
    : request(asked),
      parts(asked.problem.size()),
      variants(most_variants(asked.problem)),
      random(asked.seed),
      search(begun_search(asked)) {}

void repair(RegionGenes& genes) {
  const int parts = static_cast<int>(genes.size() / 2);
  double rank = 1.0;
  for (const int place : places_by_size(genes, parts)) at(genes, place) = rank++;
}

std::vector<RegionVisit> visits_of(const RegionProblem& problem, const RegionGenes& genes) {
  const int parts = problem.size();
  const int most = most_variants(problem);
  std::vector<RegionVisit> visits(static_cast<std::size_t>(parts));
  int rank = 0;
  for (const int place : places_by_size(genes, parts)) at(visits, place).part = rank++;
  for (int place = 0; place < parts; ++place) {
    RegionVisit& visit = at(visits, place);
    const int own = static_cast<int>(at(problem.parts, visit.part).size());
    const int number = static_cast<int>(std::lround(at(genes, parts + place))) - 1;
    visit.variant = std::clamp(number, 0, most - 1) * own / most;
  }
  return visits;
}

RegionIndividual individual_of(RegionTask& task, RegionGenes genes) {
  std::vector<RegionVisit> visits = visits_of(task.request.problem, genes);
  const double own = plan_cost(task.request.problem, visits);
  ++task.search.evaluations;
  if (note_cost(task.search, own)) task.best = std::move(visits);
  return {std::move(genes), own};
}

RegionGenes random_genes(RegionTask& task) {
  RegionGenes genes(2 * static_cast<std::size_t>(task.parts));
  std::iota(genes.begin(), genes.begin() + task.parts, 1.0);
  shuffle(task.random, genes, 0, task.parts);
  for (int i = task.parts; i < 2 * task.parts; ++i) {
    at(genes, i) = 1.0 + draw_below(task.random, task.variants);
  }
  return genes;
}

std::vector<RegionIndividual> random_individuals(RegionTask& task, int count) {
  std::vector<RegionIndividual> individuals;
  do {
    individuals.push_back(individual_of(task, random_genes(task)));
  } while (static_cast<int>(individuals.size()) < count && goes_on(task.search));
  return individuals;
}

const RegionIndividual& cheapest(const std::vector<RegionIndividual>& individuals) {
  return *std::ranges::min_element(individuals, {}, &RegionIndividual::cost);
}

RegionPlan finished_plan(RegionTask& task, const std::string& planner) {
  return finished_plan(task.request, planner, std::move(task.best), task.search);
}

const ParameterSpec& region_population_spec() {
  static const ParameterSpec kSpec{"population", 96.0, 4.0, 5000.0, {}, "individuals (Np)", true};
  return kSpec;
}

int region_population(const RegionRequest& request) {
  return static_cast<int>(number(request.parameters, "population"));
}

}  // namespace headland

// The chromosome of IGA-CPP, which GA, PSO, DE and SHADE share, and what they search with.
#pragma once

#include <string>
#include <vector>

#include "planner/region_plan.h"

namespace headland {

// For N parts 2 N numbers: I, in [1, N], whose ranks are the order of the parts, and J, in [1, M],
// the variant at each place of that order; M is the most variants of any part. A part with fewer
// takes its share of the range: with four each, as in the paper, J is the variant's number.
using RegionGenes = std::vector<double>;

struct RegionIndividual {
  RegionGenes genes;
  double cost = 0.0;  // [m], or W h by measured costs
};

// What a search over individuals has besides them.
struct RegionTask {
  // Throws InputError as begun_search.
  explicit RegionTask(const RegionRequest& request);
  RegionTask(const RegionTask&) = delete;
  RegionTask& operator=(const RegionTask&) = delete;

  const RegionRequest& request;  // not owned
  int parts = 0;
  int variants = 0;  // the most of any part
  SeededRandom random;
  PlanSearch search;
  std::vector<RegionVisit> best;  // of all measured
};

// The largest value of a gene; the least is 1.
inline double most_of_gene(const RegionTask& task, int gene) {
  return gene < task.parts ? task.parts : task.variants;
}

// Replaces I by its ranks, 1 for the smallest, ties by place: the paper's repair, which leaves an
// order as it is.
void repair(RegionGenes& genes);

// J is rounded.
std::vector<RegionVisit> visits_of(const RegionProblem& problem, const RegionGenes& genes);

// Measured: its cost counted as an evaluation and noted.
RegionIndividual individual_of(RegionTask& task, RegionGenes genes);

// Every order and variant as likely, repaired.
RegionGenes random_genes(RegionTask& task);

// As many as wanted, fewer where the search ends before, at least one.
std::vector<RegionIndividual> random_individuals(RegionTask& task, int count);

const RegionIndividual& cheapest(const std::vector<RegionIndividual>& individuals);

// The best of all.
RegionPlan finished_plan(RegionTask& task, const std::string& planner);

// `population`: 96 is what the paper's tuning comes to.
const ParameterSpec& region_population_spec();
int region_population(const RegionRequest& request);

}  // namespace headland

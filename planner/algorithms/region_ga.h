// A plain genetic algorithm on IGA-CPP's chromosomes.
#pragma once

#include <span>

#include "planner/region_genes.h"

namespace headland {

std::span<const ParameterSpec> region_ga_parameters();

// What 'IGA-CPP' compares with, by its parameters: Np = 96, F = 0.1, C = 0.1. The paper tells no
// more. Reading: each generation keeps the best individual and fills up with children of parents
// drawn by roulette (fitness 1 / length); with probability C a child takes what follows a random
// place, of I and of J alike, from a second parent; then each gene mutates with probability F as
// in Eqs (1) and (2), and the child is repaired by ranking. Throws InputError as begun_search;
// Cancelled.
RegionPlan plan_region_ga(const RegionRequest& request);

}  // namespace headland

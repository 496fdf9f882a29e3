// Differential evolution on IGA-CPP's chromosomes.
#pragma once

#include <span>

#include "planner/region_genes.h"

namespace headland {

std::span<const ParameterSpec> region_de_parameters();

// Storn and Price, 'Differential evolution', 1997, DE/rand/1/bin, with what 'IGA-CPP' gives:
// Np = 96, scaling factor F = 0.1, crossover probability C = 0.1. Reading: genes as real numbers,
// cut off at the ends of their ranges. Throws InputError as begun_search; Cancelled.
RegionPlan plan_region_de(const RegionRequest& request);

// An index below `count` that is none of those given; there are more than those.
int draw_another(SeededRandom& random, int count, std::initializer_list<int> taken);

}  // namespace headland

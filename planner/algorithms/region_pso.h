// Particle swarm optimization on IGA-CPP's chromosomes.
#pragma once

#include <span>

#include "planner/region_genes.h"

namespace headland {

std::span<const ParameterSpec> region_pso_parameters();

// Shi and Eberhart, 'A modified particle swarm optimizer', 1998, with what 'IGA-CPP' gives:
// Np = 96, inertia w = 0.8, greatest velocity 0.8, c = 2. Reading: positions are the genes as real
// numbers, which stay in their ranges, velocities are bounded gene by gene and begin at random, and
// all particles know the best of all. Throws InputError as begun_search; Cancelled.
RegionPlan plan_region_pso(const RegionRequest& request);

}  // namespace headland

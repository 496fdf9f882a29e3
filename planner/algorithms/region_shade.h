// Success-history based adaptive differential evolution on IGA-CPP's chromosomes.
#pragma once

#include <span>

#include "planner/region_genes.h"

namespace headland {

std::span<const ParameterSpec> region_shade_parameters();

// Tanabe and Fukunaga, 'Success-history based parameter adaptation for differential evolution',
// 2013: current-to-pbest/1/bin with an archive as large as the population, F from a Cauchy and CR
// from a normal distribution around one of H remembered pairs, which successes renew by weighted
// Lehmer and arithmetic means; with what 'IGA-CPP' gives: Np = 96, H = 6, F = 0.5 and C = 0.7 to
// begin with. Reading: genes as real numbers; one that leaves its range is set midway between the
// parent's and the end. Throws InputError as begun_search; Cancelled.
RegionPlan plan_region_shade(const RegionRequest& request);

}  // namespace headland

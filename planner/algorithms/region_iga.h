// IGA-CPP: the improved genetic algorithm with order and ways evolving together.
#pragma once

#include <span>

#include <string>

#include "planner/region_genes.h"

namespace headland {

std::span<const ParameterSpec> region_iga_parameters();

// 'IGA-CPP', sections 'Improved genetic algorithm' and 'Optimized control parameters of IGA'. One
// population of pairs I and J (region_genes.h). In each iteration every individual is mutated gene
// by gene with probability F (Eqs 1 and 2), its mutant crossed into it gene by gene with
// probability C (Eqs 3 and 4), the child repaired by ranking; the shorter of parent and child stays
// (Eq 5). The population shrinks linearly to Np_min (Eq 6), the longest go.
// Readings: round(rand (N - 1)) + 1 gives the end values half as often as the others, as printed;
// `rand` is drawn for each gene anew; I_m lies in [1, N] (the text says 4 at the wrong place);
// Np_min is 4 ('428' is 4 and a footnote); where evaluations or seconds limit the search instead of
// iterations, Eq (6) goes by the share that is over. A child as long as its parent is not kept.
// Throws InputError as begun_search and check_region_iga; Cancelled.
RegionPlan plan_region_iga(const RegionRequest& request);

// Throws InputError(source, "where.least_population", ...) for Np_min above Np0.
void check_region_iga(const Parameters& parameters, const std::string& source,
                      const std::string& where);

// Eqs (1) and (2) for one gene: a new value with probability F. GA mutates so too.
double mutated_gene(RegionTask& task, int gene, double value, double mutation);

}  // namespace headland

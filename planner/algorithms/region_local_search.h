// Ruin and recreate over order, variants and directions of sweep together: our own.
#pragma once

#include <span>

#include "planner/region_plan.h"

namespace headland {

std::span<const ParameterSpec> region_local_search_parameters();

// The problem is a generalised travelling salesman's: a part is a set of variants, whatever their
// number, of which one is visited. One plan is changed again and again: up to `most_removed` parts
// that lie beside each other, in the plan or on the ground, are taken out, and each is put back
// where and in the variant it makes the plan longer by least, looking at places beside parts near
// it, of which one is overlooked now and then (`blink`). The variants around it are chosen anew, by
// dynamic programming along the order. A change is kept if the plan is not longer, or, with a
// probability that falls over the search, if it is a little longer (simulated annealing). An
// iteration is 100 changes and one more a part.
// After Smith and Imeson, 'GLNS: an effective large neighborhood search heuristic for the
// generalized traveling salesman problem', 2017, and Christiaens and Vanden Berghe, 'Slack
// induction by string removals', 2020. Throws InputError as begun_search; Cancelled.
RegionPlan plan_region_local_search(const RegionRequest& request);

// Of all choices of variants for the visits at places `first` to `last`, 0 <= first <= last, the
// others as they are, those that make the plan shortest.
void choose_variants(const RegionProblem& problem, std::vector<RegionVisit>& visits, int first,
                     int last);

}  // namespace headland

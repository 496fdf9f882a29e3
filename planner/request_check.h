// What every planner on fields asks of its request.
#pragma once

#include "planner/plan.h"

namespace headland {

// The request with its field as simplified() gives it. Throws InputError for a working width or
// radius that is not a positive number, an implement or vehicle wider than the field;
// PlanInfeasible for an outline that is all teeth.
PlanRequest checked(const PlanRequest& asked_for);

}  // namespace headland

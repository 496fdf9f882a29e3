// What a run came to, for people.
#pragma once

#include <string>

#include "apps/stages.h"

namespace headland {

// A headline with what was evaluated, one aligned figure a line with its unit, where the energy
// went, what each kind of movement cost, and the verdict with its reasons.
std::string run_summary(const Job& job, const DriveResult& result);

// What `delta_soc` used (negative: won back, downhill) did to the state of charge: "-2.3 %",
// "+0.1 %", and "+0.0 %" for either sign of nothing.
std::string charge_change_text(double delta_soc);

}  // namespace headland

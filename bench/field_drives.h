// Made-up fields planned and driven in physics on rolling terrain.
#pragma once

#include <string>
#include <vector>

#include "terrains/parameter.h"

namespace headland::bench {

struct DrivesAsked {
  int fields = 20;
  double most_ha = 3.0;  // larger ones of the suite are left out
  int jobs = 1;
  std::vector<std::string> vehicles = {"transplanter", "utility_tractor"};
  Parameters parameters;
  double clearance_m = 0.1;  // of hull and implement; leaning on a slope takes some of it
  bool json = false;
};

// One row a field and vehicle: outcome, what of the reachable ground the path covers and what the
// drive did, places where the hull left the field.
void print_drives(const DrivesAsked& asked);

}  // namespace headland::bench

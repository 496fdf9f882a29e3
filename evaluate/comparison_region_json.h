// A comparison's fields and their plans for compare.json. Keys: docs/compare.md.
#pragma once

#include <nlohmann/json.hpp>

#include "evaluate/comparison.h"

namespace headland {

// The field as it was divided: options, parts with their outlines and directions, what was dropped.
nlohmann::ordered_json region_json(const ComparedMap& field);

// The parts in their order, each with the sweep and way it is worked in and the ends of that way.
nlohmann::ordered_json visits_json(const ComparedRegion& region, PartSweeps sweeps,
                                   const RegionPlan& plan);

}  // namespace headland

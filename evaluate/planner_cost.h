// Measured costs as planners use them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/cost_table.h"
#include "planner/drive_cost.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// `source` names the table in messages. Speeds that were not measured are taken between or as the
// nearest ones. Throws InputError for a table without the straights on the flat, the implement's
// cycle and the 90-degree turns (not measured, or not finished), or with costs that are not finite.
DriveCost drive_cost_of(const CostTable& table, const Vehicle& vehicle, const std::string& source);

// The costs in `file` for this vehicle. Throws InputError as read_cost_table and drive_cost_of, and
// for a table of another vehicle. Notes tell of other widths, radii and soils than are planned for.
DriveCost read_drive_cost(const std::filesystem::path& file, const Vehicle& vehicle,
                          const std::string& soil, std::vector<std::string>& notes);

}  // namespace headland

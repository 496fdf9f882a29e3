// Weights of fitnesses in a file: the section `planner.cost` of a scenario, as `headland tune`
// writes it.
#pragma once

#include <filesystem>
#include <string>

#include "evaluate/scenario.h"

namespace headland {

// `comment` is one or several lines that say where they are from.
std::string weights_yaml(const GridCost& cost, const std::string& comment);

// Plans by these weights instead of whatever the planner would. Throws InputError with line and key
// as read_scenario for what stands in the file, for one that names measured costs, and when the
// planner is not one on grid maps.
void plan_by_weights(const std::filesystem::path& file, PlannerChoice& planner);

}  // namespace headland

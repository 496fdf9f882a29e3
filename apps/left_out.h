// Passes that a plan leaves out, told so that nobody takes it for a whole one.
#pragma once

#include <string>
#include <vector>

#include "apps/stages.h"
#include "evaluate/coverage.h"
#include "evaluate/scenario.h"
#include "planner/path.h"

namespace headland {

// Plans that leave out passes for more ground than this share of what is to be worked are warned
// of.
inline constexpr double kLeftOutWarned = 0.01;

// Ground that they would have worked, by `coverage` of the path no more than is unworked: the
// planner counts in cells of its own.
struct LeftOutGround {
  double area_m2 = 0.0;
  double ratio = 0.0;  // of what is to be worked
};
LeftOutGround left_out_ground(const Path& path, const CoverageFigures& coverage);

// A summary's row on all of them with the largest below, a line each; empty where there are none.
std::string left_out_rows(const Path& path, const CoverageFigures& coverage,
                          const PathOptions& options);

struct PlannedField {
  std::string name;  // empty: the only one
  PlannerChoice planner;
};

// One line: how much, where most, and what may help of what `fields` and `options` leave to choose.
// Empty up to kLeftOutWarned.
std::string left_out_warning(const Path& path, const CoverageFigures& coverage,
                             const std::vector<PlannedField>& fields, const PathOptions& options);

// Likewise of cells of a grid plan that cannot be worked; `field` is the scenario's.
std::string unworked_cells_warning(const GridDrive& drive, const FieldSource& field);

// Prints it, "headland: warning: ...", on stderr, whether asked to be quiet or not: nothing else
// tells who runs it from a script.
void print_warning(const std::string& text);  // nothing of an empty one
void warn_of_left_out(const Job& job, const PlanResult& result, const CoverageFigures& coverage);

}  // namespace headland

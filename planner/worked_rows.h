// Ground of swaths that are driven already, which wheels keep off between swaths.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/arcs.h"
#include "planner/path.h"
#include "planner/work_line.h"
#include "planner/worked_ground.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// A swath counts as worked in the middle of its width, by this share: neighbours overlap, and the
// wheels on one come near the other's edge.
inline constexpr double kRowShare = 0.8;

// Works the rows of `line` from edge `from` to edge `to` of its points, run-ins left out; nothing
// of lines that are no swaths or `optional`. The cells that no row had worked before: unwork
// (worked_ground.h) takes them back.
std::vector<std::size_t> work_rows(WorkedGround& ground, const WorkLine& line, std::size_t from,
                                   std::size_t to, const Vehicle& vehicle);

// Rows of the swaths of a path, as a vehicle finds them that stands at its end: what is under its
// wheels there is none yet.
WorkedGround rows_behind(const Field& field, const Vehicle& vehicle, const Path& path);

// So many edges at the end of a swath are no row yet for the turn that begins there: wheels that
// stand behind the implement stand on them, and swath ends may be cut back by `cut_m`.
std::size_t tail_edges(const WorkLine& line, const Vehicle& vehicle, double cut_m);

// Where wheels run, implement up, on ground that has been worked.
struct DrivenOverWorked {
  double length_m = 0.0;
  int stretches = 0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // where the longest of them begins
};

// A place of a path.
struct WorkState {
  enum class Does { kWork, kWorkThatDoesNotCount, kDrive };
  Pose pose;
  double step_m = 0.0;  // of way from the place before
  Does does = Does::kDrive;
};

DrivenOverWorked driven_over_worked(const Field& field, const Vehicle& vehicle,
                                    const std::vector<WorkState>& states);

// Of a path of ours over its swaths; headland passes and optional ones, which fill what is left, do
// not count.
DrivenOverWorked driven_over_worked(const Field& field, const Vehicle& vehicle, const Path& path);

}  // namespace headland

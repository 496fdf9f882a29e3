// What the joining of work lines into a path knows and has made so far, and the names of its
// places.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "planner/connection.h"
#include "planner/join_lines.h"
#include "planner/worked_rows.h"

namespace headland {

struct LineJoining {
  const Field& field;
  const Vehicle& vehicle;
  std::vector<WorkLine> lines;
  const PathOptions& options;
  const FreeSpace& space;
  const CancelAsked& cancelled;
  double radius_m = 0.0;
  int node_budget = 0;
  int manoeuvre = 0;
  Path path{};
  TurnRemedies remedies{};
  WorkedGround* worked = nullptr;  // rows that wheels keep off, as `space` knows them; null: none
};

ConnectionOptions connection_options(const LineJoining& joining, double clearance_m);

// As connect (connection.h), with at most `most_nodes` of the node budget, which they are taken
// off.
std::optional<std::vector<Arc>> connect_within(LineJoining& joining, const Pose& from,
                                               const Pose& to, double clearance_m, int most_nodes);

// The implement's middle where the axle is there.
Eigen::Vector2d implement_at(const LineJoining& joining, const PathPoint& axle);

// "(x, y) m", with longitude and latitude where the field lies on the Earth.
std::string place_name(const Field& field, const Eigen::Vector2d& p_W);

// "pass 3 (swath)"
std::string line_name(const std::vector<WorkLine>& lines, std::size_t index);

// Throws PlanInfeasible: why nothing fits between two lines, and what would help.
[[noreturn]] void refuse_connection(const LineJoining& joining, std::size_t before,
                                    std::size_t next);

}  // namespace headland

#include "planner/grid_drivable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planner/connection.h"
#include "planner/grid_extra_runs.h"
#include "planner/grid_joining.h"
#include "planner/grid_runs.h"
#include "planner/join_lines.h"
#include "planner/outline.h"

namespace headland {
namespace {

constexpr double kMarginStep_m = 0.1;

// Why a cell is not worked, whatever comes later.
enum class Hindrance { kNone, kLane, kRoom, kTurn, kNoTurn };

std::string_view hindrance_text(Hindrance hindrance) {
  switch (hindrance) {
    case Hindrance::kLane:
      return "the hull has no room anywhere along the run through it";
    case Hindrance::kRoom:
      return "the hull comes too near to what is blocked for the implement to reach it";
    case Hindrance::kTurn:
      return "the run through it was drawn back for the room its turn needs";
    case Hindrance::kNoTurn:
      return "no turn reaches a run through it";
    case Hindrance::kNone:
      break;
  }
  return "the plan does not visit it";
}

void note(const GridMap& map, const GridRun& run, Hindrance hindrance,
          std::vector<Hindrance>& hindrances) {
  for (int k = 0; k < run.cells; ++k) hindrances[index_of(map, cell_of(run, k))] = hindrance;
}

LeftOutRun left_out_run(const GridRun& run, Hindrance hindrance) {
  return {cell_of(run, 0), cell_of(run, run.cells - 1), std::string(hindrance_text(hindrance))};
}

// The plan's runs, as far as they can be driven one after the other. A run that no turn leaves is
// left out in favour of a longer one, or when a second one cannot be reached from it.
std::vector<GridRun> drivable_runs(GridJoining& joining, const std::vector<GridRun>& runs,
                                   std::vector<Hindrance>& hindrances,
                                   std::vector<LeftOutRun>& left_out) {
  const GridMap& map = joining.map;
  std::vector<GridRun> kept;
  int not_left = 0;  // runs in a row that the last one kept does not lead to
  for (const GridRun& whole : runs) {
    stop_if(joining.connection.cancelled);
    auto run = with_room(joining, whole);
    note(map, whole, run ? Hindrance::kRoom : Hindrance::kLane, hindrances);
    if (!run) {
      left_out.push_back(left_out_run(whole, Hindrance::kLane));
      continue;
    }
    if (kept.empty() || joined(joining, kept.back(), *run)) {
      kept.push_back(*run);
      not_left = 0;
      continue;
    }
    if (draw_back(joining, kept.back(), *run)) {
      note(map, kept.back(), Hindrance::kTurn, hindrances);
      note(map, whole, Hindrance::kTurn, hindrances);
      kept.push_back(*run);
      not_left = 0;
      continue;
    }
    ++not_left;
    const bool longer = run->end_m - run->begin_m > kept.back().end_m - kept.back().begin_m;
    if ((longer || not_left > 1) &&
        (kept.size() == 1 || joined(joining, kept[kept.size() - 2], *run))) {
      note(map, kept.back(), Hindrance::kNoTurn, hindrances);
      left_out.push_back(left_out_run(kept.back(), Hindrance::kNoTurn));
      kept.back() = *run;
      not_left = 0;
    } else {
      note(map, whole, Hindrance::kNoTurn, hindrances);
      left_out.push_back(left_out_run(whole, Hindrance::kNoTurn));
    }
  }
  return kept;
}

void tell_unworked(const GridMap& map, const std::vector<WorkedCell>& worked,
                   const std::vector<Hindrance>& hindrances, GridDrive& drive) {
  double cells = 0.0;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::size_t i = index_of(map, {column, row});
      if (map.blocked[i] != 0) continue;
      const double share = unworked_share(worked[i]);
      cells += share;
      if (share <= kUnworkedShare) continue;
      drive.unworked.push_back({{column, row}, share, std::string(hindrance_text(hindrances[i]))});
    }
  }
  drive.unworked_ratio = cells / free_cell_count(map);
}

Plan plan_of(const GridMap& map, const GridPlan& given, const std::vector<GridRun>& runs) {
  Plan plan;
  plan.planner = given.planner;
  plan.remedies.has_headland = false;
  for (const GridRun& run : runs) {
    plan.passes.push_back(pass_of(map, run));
    plan.planned_length_m += run.end_m - run.begin_m;
  }
  const Polyline& first = plan.passes.front().points_W;
  const Eigen::Vector2d along_W = first.back() - first.front();
  const double heading_rad = wrap_angle(std::atan2(along_W.y(), along_W.x()));
  plan.swath_direction_rad = heading_rad < 0.0 ? heading_rad + M_PI : heading_rad;
  return plan;
}

}  // namespace

GridDrive make_grid_path(const Field& field, const Vehicle& vehicle, const GridMap& map,
                         const GridPlan& plan, const PathOptions& options,
                         const CancelAsked& cancelled) {
  if (plan.cells.empty()) throw PlanInfeasible("the grid plan has no cells");
  const FreeSpace space = free_space(simplified(field), hull_of(vehicle));
  GridJoining joining{
      map, vehicle, space, {planning_turning_radius_m(vehicle), options.clearance_m, cancelled}};
  GridDrive drive;
  std::vector<GridRun> runs = work_runs(map, plan.cells);
  std::vector<Hindrance> hindrances(map.blocked.size(), Hindrance::kNone);
  if (!options.allow_overrun) {
    runs = drivable_runs(joining, runs, hindrances, drive.left_out);
    if (runs.empty()) {
      throw PlanInfeasible(fmt::format(
          "{} has no room on any of the {} straight pieces of the plan; larger cells, a "
          "smaller vehicle, or allow overruns (--allow-overrun)",
          vehicle.name, drive.left_out.size()));
    }
  }
  std::vector<WorkedCell> worked(map.blocked.size());
  for (const GridRun& run : runs) add_worked(map, run, worked);
  if (!options.allow_overrun) {
    const AddedRuns more = add_runs(joining, runs, worked);
    drive.added_passes = more.added;
    for (const GridRun& run : more.unreached) note(map, run, Hindrance::kNoTurn, hindrances);
  }
  drive.plan = plan_of(map, plan, runs);
  std::vector<WorkLine> lines;
  lines.reserve(runs.size());
  for (const GridRun& run : runs) lines.push_back(line_of(joining, run));
  // Every way is known to be there, and is found again by as many nodes as it took.
  const int nodes = options.allow_overrun ? kNodeBudget : std::numeric_limits<int>::max();
  drive.path =
      join_lines(field, vehicle, space, lines, options, cancelled, drive.plan.remedies, nodes);
  tell_unworked(map, worked, hindrances, drive);
  return drive;
}

double grid_margin_m(const Vehicle& vehicle, const PathOptions& options) {
  const Hull hull = hull_of(vehicle);
  const double half_width_m = std::max(hull.half_width_m, hull.bar_half_width_m);
  const double swing_m =
      std::hypot(planning_turning_radius_m(vehicle) + half_width_m, hull.front_m);
  const double least_m = swing_m + std::max(0.0, -vehicle.implement.x_B_m) + options.clearance_m;
  return std::ceil(least_m / kMarginStep_m) * kMarginStep_m;
}

}  // namespace headland

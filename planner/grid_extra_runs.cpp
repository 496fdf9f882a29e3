#include "planner/grid_extra_runs.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "planner/grid_drivable.h"
#include "planner/turns.h"

namespace headland {
namespace {

constexpr double kWholeShare = 1e-9;
// Places in the order at which a run is tried.
constexpr std::size_t kPlacesTried = 4;

using RunKey = std::tuple<GridCell, int, double, double>;

RunKey key_of(const GridRun& run) { return {run.first, run.direction, run.begin_m, run.end_m}; }

WorkedSpan missing_at(const GridMap& map, const std::vector<WorkedCell>& worked, GridCell cell,
                      int direction) {
  if (!is_free(map, cell)) return {};
  const WorkedCell& at_cell = worked[index_of(map, cell)];
  if (unworked_share(at_cell) <= kWholeShare) return {};
  return missing_along(at_cell, direction);
}

// Through the cell and on as far as cells are not wholly worked.
GridRun run_through(const GridMap& map, const std::vector<WorkedCell>& worked, GridCell first,
                    int direction) {
  GridRun run{first, direction, 1, 0.0, 0.0};
  run.begin_m = map.cell_m * missing_at(map, worked, first, direction).begin;
  while (true) {
    const WorkedSpan last = missing_at(map, worked, cell_of(run, run.cells - 1), direction);
    run.end_m = map.cell_m * (run.cells - 1 + last.end);
    const WorkedSpan next = missing_at(map, worked, cell_of(run, run.cells), direction);
    if (!(next.begin < next.end)) return run;
    ++run.cells;
  }
}

// Cells' worth of ground that the run works and others do not.
double gain_of(const GridMap& map, const std::vector<WorkedCell>& worked, const GridRun& run) {
  double gain = 0.0;
  std::vector<WorkedCell> one(1);
  for (int k = 0; k < run.cells; ++k) {
    const WorkedCell& before = worked[index_of(map, cell_of(run, k))];
    one[0] = before;
    GridMap alone = free_grid_map(1, 1);
    alone.cell_m = map.cell_m;
    add_worked(alone,
               {{0, 0}, run.direction, 1, run.begin_m - k * map.cell_m, run.end_m - k * map.cell_m},
               one);
    gain += unworked_share(before) - unworked_share(one[0]);
  }
  return gain;
}

struct BestRun {
  GridRun run;
  double worth = 0.0;  // gain a metre
};

BestRun best_run(const GridJoining& joining, const std::vector<WorkedCell>& worked,
                 const std::set<RunKey>& unreached) {
  const GridMap& map = joining.map;
  const double turns_m = 2.0 * std::numbers::pi * joining.connection.radius_m;
  BestRun best;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const GridCell cell{column, row};
      for (int direction = 0; direction < kDirections; ++direction) {
        const WorkedSpan here = missing_at(map, worked, cell, direction);
        if (!(here.begin < here.end)) continue;
        const auto run = with_room(joining, run_through(map, worked, cell, direction));
        if (!run || unreached.contains(key_of(*run))) continue;
        const double gain = gain_of(map, worked, *run);
        const double worth = gain / (run->end_m - run->begin_m + turns_m);
        if (gain >= kLeastGain && worth > best.worth) best = {*run, worth};
      }
    }
  }
  return best;
}

double way_m(const GridJoining& joining, const GridRun& from, const GridRun& to) {
  const Pose end = end_of(joining, from);
  const Pose begin = begin_of(joining, to);
  const double radius_m = joining.connection.radius_m;
  return joining.space.hull.gears == Gears::kBoth ? reeds_shepp_length_m(end, begin, radius_m)
                                                  : forward_length_m(end, begin, radius_m);
}

bool inserted(GridJoining& joining, const GridRun& run, std::vector<GridRun>& runs) {
  std::vector<std::pair<double, std::size_t>> places;  // before runs[i], or after all
  for (std::size_t i = 1; i <= runs.size(); ++i) {
    double longer_m = way_m(joining, runs[i - 1], run);
    if (i < runs.size()) {
      longer_m += way_m(joining, run, runs[i]) - way_m(joining, runs[i - 1], runs[i]);
    }
    places.emplace_back(longer_m, i);
  }
  std::ranges::sort(places);
  places.resize(std::min(places.size(), kPlacesTried));
  for (const auto& [longer_m, i] : places) {
    if (!joined(joining, runs[i - 1], run)) continue;
    if (i < runs.size() && !joined(joining, run, runs[i])) continue;
    runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(i), run);
    return true;
  }
  return false;
}

}  // namespace

AddedRuns add_runs(GridJoining& joining, std::vector<GridRun>& runs,
                   std::vector<WorkedCell>& worked) {
  AddedRuns result;
  std::set<RunKey> unreached;
  while (true) {
    stop_if(joining.connection.cancelled);
    const BestRun best = best_run(joining, worked, unreached);
    if (!(best.worth > 0.0)) return result;
    if (!inserted(joining, best.run, runs)) {
      unreached.insert(key_of(best.run));
      result.unreached.push_back(best.run);
      continue;
    }
    add_worked(joining.map, best.run, worked);
    ++result.added;
  }
}

}  // namespace headland

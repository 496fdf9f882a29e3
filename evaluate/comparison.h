// A comparison of planners: every planner on every map or field, several times.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/compared_region.h"
#include "evaluate/metrics.h"
#include "evaluate/parallel_runs.h"
#include "evaluate/scenario.h"
#include "evaluate/verdict.h"
#include "planner/grid_plan.h"
#include "planner/grid_planners.h"
#include "sim/run_record.h"
#include "terrains/grid_map.h"

namespace headland {

// A grid map, or a field for planners of the order of its parts.
struct ComparedMap {
  std::string name;
  std::optional<ComparedRegion> region;  // what follows is of grid maps alone
  GridMap map;
  std::optional<GridCell> start;  // none: the planner chooses
  std::optional<GridCell> end;
  bool closed = false;             // ends where it begins
  std::optional<Field> field;      // the map was made of, its free cells to be worked
  std::vector<std::string> notes;  // what of the field is left out
};

struct ComparedPlanner {
  std::string label;  // under which it appears; the same planner may have several
  std::string name;   // of the table of grid planners, or of that of region planners
  Parameters parameters;
  SearchStop stop;
  PartSweeps sweeps = PartSweeps::kOwn;  // of fields: the directions it may choose from
};

// The same budget for all instead of each planner's own end.
enum class Budget { kNone, kEvaluations, kSeconds };

// What tests and ranks are made of. A map's mean over the repeats lets them speak of maps in
// general, of which these are a sample; single runs let them speak of these maps alone.
enum class BlockKind { kMaps, kRuns };

struct ComparisonTests {
  std::string figure = "cost";  // of figures_of_runs()
  BlockKind blocks = BlockKind::kMaps;
  std::string control;  // label the others are compared with
  double alpha = 0.05;
};

struct Comparison {
  std::filesystem::path file;  // it was read from
  std::string name;
  std::vector<ComparedMap> maps;  // all of them grid maps, or all of them fields
  std::vector<ComparedPlanner> planners;
  int repeats = 10;
  std::uint64_t seed = 1;
  GridCost cost;
  std::filesystem::path cost_file;  // of the cost's measured ones; empty: none
  std::vector<std::string> notes;   // on them
  Budget budget = Budget::kNone;
  ComparisonTests tests;
  std::optional<Scenario> drive;  // by what and over what plans are driven; without a field
};

enum class RunState {
  kPlanned,
  kRefused,  // the planner cannot plan this map
  kNotRun    // the comparison was ended before
};
std::string_view run_state_name(RunState state);

// A plan driven in physics.
struct DrivenPlan {
  std::string refusal;  // why it cannot be made drivable; nothing below is known then
  Outcome outcome = Outcome::kFinished;
  std::string outcome_detail;
  Metrics metrics;
  Grade verdict = Grade::kPass;
};

struct ComparedRun {
  int map = 0;
  int planner = 0;
  int repeat = 0;
  std::uint64_t seed = 0;
  RunState state = RunState::kNotRun;
  std::string refusal;          // why, in one line
  int free_cells = 0;           // of the map
  GridPlan plan;                // of kPlanned, on a grid map
  RegionPlan region;            // of kPlanned, on a field
  std::optional<double> least;  // no plan of the field costs less, where that is proven
  double seconds = 0.0;
  std::optional<DrivenPlan> driven;  // of the best of its planner and map, when asked for
};

bool is_of_fields(const Comparison& comparison);

// What is known of the search for either kind of plan.
struct RunSearch {
  double cost = 0.0;  // on fields length [m], or W h by measured costs
  const std::vector<ConvergencePoint>& convergence;
  int iterations = 0;
  std::int64_t evaluations = 0;
  StopReason stopped_by = StopReason::kIterations;
};
RunSearch search_of(const ComparedRun& run);

// Seed of one run: it depends on what it is called with alone, so that other maps, planners and
// more repeats leave it as it is.
std::uint64_t seed_of_run(std::uint64_t seed, std::string_view map, std::string_view label,
                          int repeat);

// Looks for the cheapest plan of every field, for the directions of sweep that its planners choose
// from, by region_exact where that takes at most kMostProofBytes. An early end leaves it at that.
void prove_least_costs(Comparison& comparison, const ParallelOptions& options);

// Every run in the order map, planner, repeat. All but `seconds` is the same with any number of
// jobs, unless the budget is one of seconds. Runs are begun repeat by repeat, so that what an early
// end leaves is balanced.
std::vector<ComparedRun> run_comparison(const Comparison& comparison,
                                        const ParallelOptions& options);

// The runs of one planner on one map.
std::vector<const ComparedRun*> runs_of(const std::vector<ComparedRun>& runs, int map, int planner);

// Of these runs the planned one with the least cost, one without jumps before one with any; null
// where none is planned.
const ComparedRun* best_run(const std::vector<const ComparedRun*>& runs);

}  // namespace headland

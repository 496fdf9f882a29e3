#include "evaluate/sweep.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "evaluate/run_claims.h"
#include "evaluate/run_key.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::size_t kRefusalsTold = 5;
constexpr auto kLookAgain = std::chrono::milliseconds(100);

// Places of a cell in the lists of the matrix.
struct Place {
  std::size_t field = 0;
  std::size_t terrain = 0;
  std::size_t vehicle = 0;
  std::size_t planner = 0;
  std::size_t seed = 0;
  std::size_t soil = 0;
};

Place place_of_cell(const Sweep& sweep, std::size_t number) {
  const auto next = [&](std::size_t size) {
    const std::size_t place = number % size;
    number /= size;
    return place;
  };
  Place place;
  place.soil = next(sweep.soils.size());
  place.seed = next(sweep.seeds.size());
  place.planner = next(sweep.planners.size());
  place.vehicle = next(sweep.vehicles.size());
  place.terrain = next(sweep.terrains.size());
  place.field = number;
  return place;
}

std::string text_of(const SweepCell& cell) {
  return fmt::format("{}, {}, {}, {}, {}, seed {}", cell.field, cell.terrain, cell.soil,
                     cell.vehicle, cell.planner, cell.seed);
}

// A run that is to be there in the end, and one of its cells.
struct Task {
  std::size_t place = 0;
  std::string key;
};

std::vector<SweepCell> keyed_cells(const Sweep& sweep, const ParallelOptions& options) {
  std::vector<SweepCell> cells(cell_count(sweep));
  ContentDigests digests;
  run_in_parallel(cells.size(), {options.jobs, {}, options.cancelled},
                  [&](std::size_t place, const CancelAsked&) {
                    cells[place] = cell_at(sweep, place);
                    cells[place].key = run_key(scenario_at(sweep, place), digests);
                    return true;
                  });
  return cells;
}

std::vector<Task> tasks_of(const std::vector<SweepCell>& cells, const Shard& shard) {
  std::vector<Task> tasks;
  std::set<std::string_view> seen;
  for (std::size_t place = 0; place < cells.size(); ++place) {
    const std::string& key = cells[place].key;
    if (is_in(shard, key) && seen.insert(key).second) tasks.push_back({place, key});
  }
  return tasks;
}

// Tasks with one plan, in their order.
std::vector<std::vector<Task>> by_plan(const Sweep& sweep, const std::vector<Task>& tasks) {
  std::vector<std::vector<Task>> groups;
  std::size_t plan = cell_count(sweep);  // of none
  for (const Task& task : tasks) {
    if (task.place / sweep.soils.size() != plan) groups.emplace_back();
    plan = task.place / sweep.soils.size();
    groups.back().push_back(task);
  }
  return groups;
}

// A sweep that is being run.
struct RunningSweep {
  const Sweep& sweep;
  RunStore& store;
  RunClaims claims;
  std::mutex mutex;  // of what follows
  SweepResult result;
  std::size_t done = 0;    // tasks that are there now, by whomever, or failed
  std::vector<Task> left;  // other programs are at it
};

void count_run(const std::string& what, const EvaluatedRun& run, SweepResult& result) {
  if (run.end != RunEnd::kDriven) {
    ++(run.end == RunEnd::kNoPlan ? result.no_plan : result.refused);
    if (result.refusals.size() < kRefusalsTold) result.refusals.push_back({what, run.reason});
    return;
  }
  ++result.driven;
  static const std::size_t energy = run_figure_place("energy_wh");
  result.no_energy += std::isfinite(run.figures[energy]) ? 0 : 1;
}

enum class TaskEnd { kDone, kElsewhere, kCancelled };

TaskEnd do_claimed_task(RunningSweep& running, const Task& task, SharedPlan& plan,
                        const CancelAsked& cancelled) {
  // Only under its claim: another program may just have finished it.
  if (holds_run(running.store, task.key)) {
    const std::scoped_lock lock(running.mutex);
    ++running.result.elsewhere;
    return TaskEnd::kDone;
  }
  const Scenario scenario = scenario_at(running.sweep, task.place);
  const std::string what = text_of(cell_at(running.sweep, task.place));
  std::optional<EvaluatedRun> run;
  try {
    run = evaluate_run(scenario, plan, cancelled);
  } catch (const std::exception& fault) {
    const std::scoped_lock lock(running.mutex);
    running.result.failed.push_back({what, fault.what()});
    return TaskEnd::kDone;
  }
  if (!run) return TaskEnd::kCancelled;
  keep_run(running.store, {task.key, scenario_yaml(scenario), *run});
  const std::scoped_lock lock(running.mutex);
  count_run(what, *run, running.result);
  return TaskEnd::kDone;
}

TaskEnd do_task(RunningSweep& running, const Task& task, SharedPlan& plan,
                const CancelAsked& cancelled) {
  if (!running.claims.claim(task.key)) return TaskEnd::kElsewhere;
  const TaskEnd end = do_claimed_task(running, task, plan, cancelled);
  running.claims.release(task.key);
  return end;
}

// False when it was cancelled.
bool do_group(RunningSweep& running, const std::vector<Task>& group, const CancelAsked& cancelled,
              const std::function<void()>& progress) {
  SharedPlan plan;
  for (const Task& task : group) {
    const TaskEnd end = do_task(running, task, plan, cancelled);
    if (end == TaskEnd::kCancelled) return false;
    const std::scoped_lock lock(running.mutex);
    if (end == TaskEnd::kElsewhere) {
      running.left.push_back(task);
    } else {
      ++running.done;
    }
    progress();
  }
  return true;
}

}  // namespace

std::size_t cell_count(const Sweep& sweep) {
  return sweep.scenarios.size() * sweep.terrains.size() * sweep.soils.size() * sweep.seeds.size();
}

SweepCell cell_at(const Sweep& sweep, std::size_t number) {
  const Place place = place_of_cell(sweep, number);
  return {sweep.fields[place.field],
          sweep.terrains[place.terrain].label,
          sweep.soils[place.soil].label,
          sweep.vehicles[place.vehicle],
          sweep.planners[place.planner],
          sweep.seeds[place.seed],
          ""};
}

Scenario scenario_at(const Sweep& sweep, std::size_t number) {
  const Place place = place_of_cell(sweep, number);
  Scenario scenario =
      sweep
          .scenarios[(place.field * sweep.vehicles.size() + place.vehicle) * sweep.planners.size() +
                     place.planner];
  const SweptTerrain& terrain = sweep.terrains[place.terrain];
  scenario.file = sweep.file;
  scenario.name = sweep.name + ": " + text_of(cell_at(sweep, number));
  scenario.seed = sweep.seeds[place.seed];
  scenario.simulation.positioning.seed = scenario.seed;
  scenario.terrain = terrain.source;
  if (!terrain.own_seed) scenario.terrain.seed = scenario.seed;
  scenario.soil = sweep.soils[place.soil].source;
  return scenario;
}

bool is_in(const Shard& shard, const std::string& run_key) {
  constexpr std::size_t kDigits = 15;
  constexpr int kHexadecimal = 16;
  const long long number = std::stoll(run_key.substr(0, kDigits), nullptr, kHexadecimal);
  return number % shard.parts == shard.part - 1;
}

SweepResult run_sweep(const Sweep& sweep, RunStore& store, const Shard& shard,
                      const ParallelOptions& options) {
  const auto ended = [&] { return options.cancelled && options.cancelled(); };
  const std::vector<SweepCell> cells = keyed_cells(sweep, options);
  RunningSweep running{sweep, store, RunClaims(store.file), {}, {}, 0, {}};
  running.result.cells = cells.size();
  running.result.ended_early = ended();
  if (running.result.ended_early) return running.result;
  keep_cells(store, sweep.name, cells);
  std::vector<Task> tasks = tasks_of(cells, shard);
  running.result.runs = tasks.size();
  std::erase_if(tasks, [&](const Task& task) { return holds_run(store, task.key); });
  running.result.known = running.result.runs - tasks.size();

  const int all = static_cast<int>(tasks.size());
  const auto progress = [&] {
    if (options.progress) options.progress(static_cast<int>(running.done), all);
  };
  while (!tasks.empty() && !ended()) {
    const std::vector<std::vector<Task>> groups = by_plan(sweep, tasks);
    run_in_parallel(groups.size(), {options.jobs, {}, options.cancelled},
                    [&](std::size_t i, const CancelAsked& cancelled) {
                      return do_group(running, groups[i], cancelled, progress);
                    });
    tasks = std::move(running.left);
    running.left.clear();
    if (!tasks.empty() && !ended()) std::this_thread::sleep_for(kLookAgain);
  }
  running.result.ended_early = ended();
  return running.result;
}

}  // namespace headland

#include "evaluate/comparison.h"

#include <algorithm>
#include <chrono>

#include "evaluate/parallel_runs.h"
#include "planner/algorithms/region_exact.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// FNV-1a, 64 bits.
std::uint64_t hashed(std::uint64_t hash, std::string_view text) {
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 0x100000001b3U;
  }
  return hash;
}

// The finalizer of SplitMix64: seeds that differ in a bit give draws that have nothing in common.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

GridPlanRequest request_of(const Comparison& comparison, const ComparedRun& run,
                           const CancelAsked& cancelled) {
  const ComparedMap& map = comparison.maps[static_cast<std::size_t>(run.map)];
  const ComparedPlanner& planner = comparison.planners[static_cast<std::size_t>(run.planner)];
  GridPlanRequest request;
  request.map = map.map;
  request.start = map.start;
  request.end = map.end;
  request.closed = map.closed;
  request.cost = comparison.cost;
  request.stop = planner.stop;
  request.parameters = planner.parameters;
  request.seed = run.seed;
  request.cancelled = cancelled;
  return request;
}

void plan_on_map(const Comparison& comparison, const CancelAsked& cancelled, ComparedRun& run) {
  const std::string& name = comparison.planners[static_cast<std::size_t>(run.planner)].name;
  run.plan = find_grid_planner(name, comparison.file.string())
                 .plan(request_of(comparison, run, cancelled));
}

void plan_on_field(const Comparison& comparison, const CancelAsked& cancelled, ComparedRun& run) {
  const ComparedRegion& region = *comparison.maps[static_cast<std::size_t>(run.map)].region;
  const ComparedPlanner& planner = comparison.planners[static_cast<std::size_t>(run.planner)];
  run.least = least_cost(region, planner.sweeps);
  const RegionRequest request{region_problem(region, planner.sweeps), planner.stop,
                              planner.parameters, run.seed, cancelled};
  run.region = find_region_planner(planner.name, comparison.file.string()).plan(request);
}

void plan_run(const Comparison& comparison, const CancelAsked& cancelled, ComparedRun& run) {
  const auto begun = std::chrono::steady_clock::now();
  try {
    if (is_of_fields(comparison)) {
      plan_on_field(comparison, cancelled, run);
    } else {
      plan_on_map(comparison, cancelled, run);
    }
    run.state = RunState::kPlanned;
  } catch (const InputError& refused) {
    run.state = RunState::kRefused;
    run.refusal = refused.what();
  } catch (const Cancelled&) {
    return;  // as if it had never begun
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

std::vector<ComparedRun> runs_to_do(const Comparison& comparison) {
  std::vector<ComparedRun> runs;
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    const bool on_field = comparison.maps[m].region.has_value();
    const int free_cells = on_field ? 0 : free_cell_count(comparison.maps[m].map);
    for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
      for (int repeat = 0; repeat < comparison.repeats; ++repeat) {
        ComparedRun run;
        run.map = static_cast<int>(m);
        run.planner = static_cast<int>(p);
        run.repeat = repeat;
        run.free_cells = free_cells;
        run.seed = seed_of_run(comparison.seed, comparison.maps[m].name,
                               comparison.planners[p].label, repeat);
        runs.push_back(std::move(run));
      }
    }
  }
  return runs;
}

}  // namespace

std::string_view run_state_name(RunState state) {
  switch (state) {
    case RunState::kPlanned:
      return "planned";
    case RunState::kRefused:
      return "refused";
    case RunState::kNotRun:
      break;
  }
  return "not run";
}

bool is_of_fields(const Comparison& comparison) {
  return !comparison.maps.empty() && comparison.maps.front().region.has_value();
}

RunSearch search_of(const ComparedRun& run) {
  const RegionPlan& region = run.region;
  if (!region.visits.empty()) {
    return {region.cost, region.convergence, region.iterations, region.evaluations,
            region.stopped_by};
  }
  const GridPlan& plan = run.plan;
  return {plan.cost, plan.convergence, plan.iterations, plan.evaluations, plan.stopped_by};
}

std::uint64_t seed_of_run(std::uint64_t seed, std::string_view map, std::string_view label,
                          int repeat) {
  // Neither name can hold the byte that parts them.
  std::uint64_t hash = hashed(mixed(seed), map);
  hash = hashed(hashed(hash, std::string_view("\0", 1)), label);
  return mixed(mixed(hash) + static_cast<std::uint64_t>(repeat));
}

void prove_least_costs(Comparison& comparison, const ParallelOptions& options) {
  struct Proof {
    const ComparedRegion& region;
    PartSweeps sweeps;
    std::optional<double>& least;
  };
  std::vector<Proof> proofs;
  for (ComparedMap& map : comparison.maps) {
    if (!map.region) continue;
    for (const ComparedPlanner& planner : comparison.planners) {
      ComparedRegion& region = *map.region;
      std::optional<double>& least =
          planner.sweeps == PartSweeps::kOwn ? region.least_own : region.least_any;
      const bool known =
          std::ranges::any_of(proofs, [&](const Proof& proof) { return &proof.least == &least; });
      if (!known) proofs.push_back({region, planner.sweeps, least});
    }
  }
  ParallelOptions quiet = options;
  quiet.progress = nullptr;
  run_in_parallel(proofs.size(), quiet, [&](std::size_t i, const CancelAsked& cancelled) {
    RegionRequest request;
    request.problem = region_problem(proofs[i].region, proofs[i].sweeps);
    request.cancelled = cancelled;
    if (exact_plan_bytes(request.problem) > kMostProofBytes) return true;
    try {
      proofs[i].least = plan_region_exact(request).cost;
    } catch (const Cancelled&) {
      return false;
    }
    return true;
  });
}

std::vector<ComparedRun> run_comparison(const Comparison& comparison,
                                        const ParallelOptions& options) {
  std::vector<ComparedRun> runs = runs_to_do(comparison);
  const std::size_t repeats = static_cast<std::size_t>(comparison.repeats);
  const std::size_t pairs = runs.size() / repeats;
  run_in_parallel(runs.size(), options, [&](std::size_t i, const CancelAsked& cancelled) {
    ComparedRun& run = runs[i % pairs * repeats + i / pairs];
    plan_run(comparison, cancelled, run);
    return run.state != RunState::kNotRun;
  });
  return runs;
}

std::vector<const ComparedRun*> runs_of(const std::vector<ComparedRun>& runs, int map,
                                        int planner) {
  std::vector<const ComparedRun*> chosen;
  for (const ComparedRun& run : runs) {
    if (run.map == map && run.planner == planner) chosen.push_back(&run);
  }
  return chosen;
}

const ComparedRun* best_run(const std::vector<const ComparedRun*>& runs) {
  const ComparedRun* best = nullptr;
  const auto better = [](const ComparedRun& one, const ComparedRun& other) {
    if ((one.plan.jumps == 0) != (other.plan.jumps == 0)) return one.plan.jumps == 0;
    return search_of(one).cost < search_of(other).cost;
  };
  for (const ComparedRun* run : runs) {
    if (run->state != RunState::kPlanned) continue;
    if (best == nullptr || better(*run, *best)) best = run;
  }
  return best;
}

}  // namespace headland

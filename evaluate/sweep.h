// A sweep: every planner by every vehicle on every soil of every terrain of every field with every
// seed, planned and driven into a store of runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/parallel_runs.h"
#include "evaluate/run_store.h"
#include "evaluate/scenario.h"

namespace headland {

struct YamlSection;

struct SweptTerrain {
  std::string label;
  TerrainSource source;
  bool own_seed = false;  // else the run's
};

struct SweptSoil {
  std::string label;
  SoilSource source;
};

struct Sweep {
  std::filesystem::path file;  // it was read from
  std::string name;
  std::vector<std::string> fields;  // labels
  std::vector<std::string> vehicles;
  std::vector<std::string> planners;
  std::vector<SweptTerrain> terrains;
  std::vector<SweptSoil> soils;
  std::vector<std::uint64_t> seeds;
  std::vector<Scenario> scenarios;  // by field, vehicle, planner; without terrain, soil and seed
};

// Every key: docs/sweep.md. Throws InputError with file, line and key as read_scenario, and for a
// matrix of more than kMostCells.
Sweep read_sweep(const std::filesystem::path& file);
Sweep read_sweep(const YamlSection& top);  // the same as a part of another file
inline constexpr std::size_t kMostCells = 1'000'000;

// The runs of the matrix, the last in this list changing first: field, terrain, vehicle, planner,
// seed, soil. Runs that differ in soil alone have the same plan. `key` is empty.
std::size_t cell_count(const Sweep& sweep);
SweepCell cell_at(const Sweep& sweep, std::size_t place);
Scenario scenario_at(const Sweep& sweep, std::size_t place);

// Part `part` of `parts`, from 1. A run belongs to the same part whatever else is in the sweep.
struct Shard {
  int part = 1;
  int parts = 1;
};
bool is_in(const Shard& shard, const std::string& run_key);

struct FailedRun {
  std::string what;  // the run's labels
  std::string why;
};

struct SweepResult {
  std::size_t cells = 0;      // of the matrix
  std::size_t runs = 0;       // of the shard; cells that are the same run count once
  std::size_t known = 0;      // of those, in the store before
  std::size_t elsewhere = 0;  // driven by other programs meanwhile
  std::size_t driven = 0;     // now
  std::size_t no_plan = 0;
  std::size_t refused = 0;
  std::size_t no_energy = 0;        // of the driven ones, whose energy is not finite
  std::vector<FailedRun> refusals;  // the first few without a plan or refused
  std::vector<FailedRun> failed;    // by a fault of the program; not stored
  bool ended_early = false;
};

// Plans and drives what the store does not hold yet, each plan once on all its soils. Runs that
// another program is driving are waited for, and taken over when it ends without them. Each run is
// on disk when it is counted. Throws InputError for a file of the sweep that cannot be read, before
// any run, and when the store cannot be written; what it holds stays.
SweepResult run_sweep(const Sweep& sweep, RunStore& store, const Shard& shard,
                      const ParallelOptions& options);

}  // namespace headland

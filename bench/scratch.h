// A folder for what a benchmark needs on the disk, gone with it.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "evaluate/measure.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::bench {

struct Scratch {
  explicit Scratch(const std::string& name)
      : folder(std::filesystem::temp_directory_path() /
               fmt::format("headland-{}-{}", name, getpid())) {
    std::filesystem::create_directories(folder);
  }
  ~Scratch() { std::filesystem::remove_all(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path folder;
};

// The vehicle's costs on firm soil as NAME.yaml, unless the file is there.
inline void measure_vehicle(const Scratch& scratch, const std::string& name, int jobs) {
  const std::filesystem::path file = scratch.folder / (name + ".yaml");
  if (std::filesystem::exists(file)) return;
  const CostTable table =
      measure_costs(load_vehicle(name), *find_soil("firm"), planning_measurements(jobs));
  std::ofstream(file) << cost_table_yaml(table);
}

}  // namespace headland::bench

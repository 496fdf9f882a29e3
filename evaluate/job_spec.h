// A job: several fields, or parts of one, worked one after the other by one vehicle, with the roads
// between their gates.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/scenario.h"

namespace headland {

// Coordinates as given: x,y in the job's crs, or metres of W.
struct JobField {
  std::string name;
  FieldSource source;
  PlannerChoice planner;
  std::vector<Eigen::Vector2d> gates;  // at least one
  std::string place;                   // in the file, for messages
};

struct JobSpec {
  Scenario common;  // all but field and planner
  std::vector<JobField> fields;
  std::string crs;  // of gates, roads, start and end; empty: WGS 84, or metres of W
  std::vector<std::vector<Eigen::Vector2d>> roads;
  double road_width_m = 5.0;
  bool order_given = false;
  std::optional<Eigen::Vector2d> start;
  std::optional<Eigen::Vector2d> end;
};

inline constexpr double kLeastRoadWidth_m = 1.0;
inline constexpr double kMostRoadWidth_m = 100.0;
inline constexpr std::size_t kMostJobFields = 60;
inline constexpr std::size_t kMostGates = 20;  // of one field
inline constexpr std::size_t kMostRoadPoints = 5000;

// Reads it with every default filled in. `seed` replaces the file's. Throws InputError as
// read_scenario; for no field, two of one name, a field without a gate, planners on grid maps, more
// than can be ordered. Every key: docs/jobs.md.
JobSpec read_job(const std::filesystem::path& file,
                 std::optional<std::uint64_t> seed = std::nullopt);

// The keys of a job that a scenario does not have, for the test of the documentation.
std::vector<std::string> job_key_paths();

}  // namespace headland

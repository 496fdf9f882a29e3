// Reads what `headland compare` is to do. Every key: docs/compare.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/yaml_section.h"

namespace headland {

// Maps or fields loaded or made, parameters completed. Throws InputError with file, line and key
// path: malformed YAML, an unknown key (with the nearest known one), a key given twice, a missing
// one, a value out of its range, an unknown planner, parameter, figure or label, names that stand
// twice or would give the same file, a map or field that cannot be read or made, a map whose free
// cells are not connected, a start or end that is not free, maps and fields in one file, keys of
// the one with the other, and what check_grid_cost refuses. `seed` replaces the file's.
Comparison read_comparison(const std::filesystem::path& file,
                           std::optional<std::uint64_t> seed = std::nullopt);

// Gives the comparison's cost its measured costs. Throws InputError as read_drive_cost, for the
// vehicle of `drive` or, without it, the costs' own.
void take_measured_costs(const std::filesystem::path& file, Comparison& comparison);

// The quantities of the tractor's energy under their keys.
struct TractorKey {
  std::string_view key;
  double TractorEnergy::*value;
};
std::span<const TractorKey> tractor_energy_keys();

// The keys of the section `cost` of another one. Throws as read_comparison.
GridCost read_grid_cost(const YamlSection& top);

// Every key path, sections included, but for the parameters of planners.
std::vector<std::string> comparison_key_paths();

// A name as part of a file's: letters, digits, '-' and '.' as they are, all else '_'.
std::string name_in_files(std::string_view name);

inline constexpr int kMostRepeats = 10000;

}  // namespace headland

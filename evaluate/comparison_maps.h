// The maps of a comparison: from files, from fields, made up.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/given_cell.h"
#include "evaluate/yaml_section.h"

namespace headland {

// What holds for maps that do not say it themselves; no start or end: free.
struct MapDefaults {
  std::optional<GivenCell> start;
  std::optional<GivenCell> end;
  double cell_m = 1.0;
  bool closed = false;
};

// The maps that one entry of the list `maps` names: one, or `count` of a generator. Names of files
// start at the folder of the section's own. `seed` is that of generators that give none. Throws
// InputError as read_comparison.
std::vector<ComparedMap> read_compared_maps(const YamlSection& section, const MapDefaults& defaults,
                                            std::uint64_t seed);

std::vector<std::string> compared_map_key_paths();

inline constexpr int kMostMapsOfARecipe = 1000;

}  // namespace headland

// The maps of a comparison: from files, from fields, made up.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/yaml_section.h"

namespace headland {

// A cell as it is given: by column and row, or as a corner of the map.
enum class MapCorner { kNorthWest, kNorthEast, kSouthWest, kSouthEast };
struct FreeChoice {};  // the planner's
using GivenCell = std::variant<FreeChoice, MapCorner, GridCell>;

// nullopt when the key is absent. Throws InputError for anything but [column, row], a corner or
// `free`.
std::optional<GivenCell> read_corner(const YamlSection& section, std::string_view key);

// The cell of this map; nullopt: the planner chooses.
std::optional<GridCell> cell_of(const std::optional<GivenCell>& given, const GridMap& map);

// As it is read.
std::string given_cell_text(const GivenCell& given);

// Where paths begin and end on maps that do not say it themselves; nullopt: free.
struct MapEnds {
  std::optional<GivenCell> start;
  std::optional<GivenCell> end;
};

// The maps that one entry of the list `maps` names: one, or `count` of a generator. Names of files
// start at the folder of the section's own. `seed` is that of generators that give none. Throws
// InputError as read_comparison.
std::vector<ComparedMap> read_compared_maps(const YamlSection& section, const MapEnds& ends,
                                            std::uint64_t seed);

std::vector<std::string> compared_map_key_paths();

inline constexpr int kMostMapsOfARecipe = 1000;

// A whole number in [least, most]; nullopt when the key is absent.
std::optional<int> read_count(const YamlSection& section, std::string_view key, int least,
                              int most);

}  // namespace headland

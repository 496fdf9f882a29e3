// Where a path on a grid map begins or ends, as it is given in YAML files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "evaluate/yaml_section.h"
#include "terrains/grid_map.h"

namespace headland {

// A cell as it is given: by column and row, or as a corner of the map.
enum class MapCorner { kNorthWest, kNorthEast, kSouthWest, kSouthEast };
struct FreeChoice {};  // the planner's
using GivenCell = std::variant<FreeChoice, MapCorner, GridCell>;

std::optional<MapCorner> corner_named(std::string_view name);

// nullopt when the key is absent. Throws InputError for anything but [column, row], a corner or
// `free`.
std::optional<GivenCell> read_corner(const YamlSection& section, std::string_view key);

// The cell of this map; nullopt: the planner chooses.
std::optional<GridCell> cell_of(const std::optional<GivenCell>& given, const GridMap& map);

// As it is read.
std::string given_cell_text(const GivenCell& given);

}  // namespace headland

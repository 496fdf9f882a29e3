// The fields of a comparison: from files, from coordinates, made up; and how they are divided.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/given_cell.h"
#include "evaluate/yaml_section.h"

namespace headland {

// Where a plan on a field begins or ends, as it is given: a point p_W [m], the field's entry, or a
// corner of the smallest rectangle around it with sides along x and y.
struct FieldEntry {};
using GivenPlace = std::variant<FreeChoice, FieldEntry, MapCorner, Eigen::Vector2d>;

// nullopt when the key is absent. Throws InputError for anything but these.
std::optional<GivenPlace> read_place(const YamlSection& section, std::string_view key);

// What holds for fields that do not say it themselves; no start or end: free.
struct FieldDefaults {
  std::optional<GivenPlace> start;
  std::optional<GivenPlace> end;
  PartsOptions parts;
};

// The keys of the section `parts` of another one, over those that hold without it.
PartsOptions read_parts_options(const YamlSection& section, const PartsOptions& defaults);

// The fields that one entry of the list `fields` names, divided: one, or `count` of a generator.
// Names of files start at the folder of the section's own. `seed` is that of generators that give
// none. Throws InputError as read_comparison.
std::vector<ComparedMap> read_compared_fields(const YamlSection& section,
                                              const FieldDefaults& defaults, std::uint64_t seed);

std::vector<std::string> compared_field_key_paths();

}  // namespace headland

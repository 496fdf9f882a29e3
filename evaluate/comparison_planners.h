// The planners of a comparison and when their searches end, as they are given.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evaluate/comparison.h"
#include "evaluate/yaml_section.h"

namespace headland {

// `planners`, `stop` and `budget` of the file: planners of grid maps, or of fields where the file
// has some. Throws InputError as read_comparison.
void read_compared_planners(const YamlSection& top, Comparison& comparison);

// The keys of a section `stop`.
SearchStop read_stop(const YamlSection& section, int default_iterations = SearchStop{}.iterations);

std::vector<std::string> compared_planner_key_paths();

// Throws InputError for names that stand twice in a list of the file or would give the same file,
// and for those that cannot be shown. `key` is what the list calls a name.
void refuse_repeated(const YamlSection& top, std::string_view list, const std::string& key,
                     const std::vector<std::string>& names);

}  // namespace headland

// Parameters of planners and generators as they stand in YAML files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "evaluate/yaml_section.h"
#include "terrains/parameter.h"

namespace headland {

std::vector<std::string> parameter_names(std::span<const ParameterSpec> specs);

// The parameters of `specs` that stand in `section` beside its own keys, completed with every
// default. Throws InputError with line and key path for a value that is not allowed; keys that are
// none of `specs` are passed over.
Parameters read_parameters(const YamlSection& section, std::span<const ParameterSpec> specs);

}  // namespace headland

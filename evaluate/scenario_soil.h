// The soil of a scenario: reading `soil` and writing it back.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "evaluate/yaml_section.h"
#include "terrains/soil_source.h"

namespace headland {

// `soil` of the scenario's top mapping: a name, or a mapping with a name, a cone index, constant
// coefficients or a file. `folder` is where relative file names start. Throws InputError with line
// and key.
SoilSource read_soil_source(const YamlSection& top, const std::filesystem::path& folder);

// The value of `soil`, with every default written out.
void emit_soil(YAML::Emitter& out, const SoilSource& source);

}  // namespace headland

// The keys of a scenario file: one literal table that the reader, the writer and the test of the
// documentation share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/scenario.h"
#include "evaluate/yaml_section.h"

namespace headland {

// A number in a scenario: `path` is its key with the sections before it, the key tells the unit.
struct NumberKey {
  std::string_view path;
  NumberRange range;
  double& (*value)(Scenario&);
};

std::span<const NumberKey> number_keys();

// A threshold of the verdict: a section of two numbers, `warn` and `fail`. `more_is_better` tells
// that the figure is fine above the threshold.
struct LimitKey {
  std::string_view path;
  bool more_is_better = false;
  double max = 0.0;  // both numbers lie in [0, max]
  Threshold& (*value)(Scenario&);
};

std::span<const LimitKey> limit_keys();

// Every key path, sections included, but for the parameters of planners and generators.
std::vector<std::string> scenario_key_paths();

// The keys directly inside a section ("" for the file itself).
std::vector<std::string> keys_in_section(std::string_view section);

}  // namespace headland

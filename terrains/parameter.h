// Named parameters of planners, terrain generators and the like: what exists, its default and
// range.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace headland {

using ParameterValue = std::variant<double, std::string>;
using Parameters = std::map<std::string, ParameterValue>;

// One row of a literal table. A parameter with `choices` is a word, any other is a number in
// [min, max]. `name` carries the unit (`length_m`), `what` says what it does in one phrase.
struct ParameterSpec {
  std::string_view name;
  ParameterValue default_value;
  double min = 0.0;
  double max = 0.0;
  std::vector<std::string_view> choices;
  std::string_view what;
};

// `given` completed with every default. Throws InputError(source, "where.name", ...) for a name
// that is not in `specs` (says the nearest one), a number out of range or NaN, or an unknown word.
Parameters resolve_parameters(std::span<const ParameterSpec> specs, const Parameters& given,
                              const std::string& source, const std::string& where);

// The value of a resolved parameter. Asserts that it exists and has the type.
double number(const Parameters& parameters, const std::string& name);
const std::string& word(const Parameters& parameters, const std::string& name);

}  // namespace headland

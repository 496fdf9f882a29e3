// Named parameters of planners, terrain generators and the like: what exists, its default and
// range.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace headland {

using ParameterValue = std::variant<double, std::string>;
using Parameters = std::map<std::string, ParameterValue>;

// One row of a literal table: a number in [min, max], or one of the words `choices`; with choices
// and min < max either ("auto", or a number). `name` carries the unit (`length_m`), `what` says
// what it does in one phrase.
struct ParameterSpec {
  std::string_view name;
  ParameterValue default_value;
  double min = 0.0;
  double max = 0.0;
  std::vector<std::string_view> choices;
  std::string_view what;
  bool whole = false;  // numbers without a fraction only
};

bool takes_number(const ParameterSpec& spec);

// "auto or a whole number from 1 to 20".
std::string allowed_values(const ParameterSpec& spec);

// `given` completed with every default. Throws InputError(source, "where.name", ...) for a name
// that is not in `specs` (says the nearest one), a number out of range or NaN, or an unknown word.
Parameters resolve_parameters(std::span<const ParameterSpec> specs, const Parameters& given,
                              const std::string& source, const std::string& where);

// "where.name"; "name" where `where` is empty.
std::string key_path(const std::string& where, std::string_view name);

// The value of a resolved parameter. Asserts that it exists and has the type; where a spec allows
// both, number_unless_word gives nothing for a word.
double number(const Parameters& parameters, const std::string& name);
std::optional<double> number_unless_word(const Parameters& parameters, const std::string& name);
const std::string& word(const Parameters& parameters, const std::string& name);

}  // namespace headland

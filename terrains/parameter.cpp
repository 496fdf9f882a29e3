#include "terrains/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "terrains/input_error.h"

namespace headland {
namespace {

std::string value_text(const ParameterValue& value) {
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

bool allows(const ParameterSpec& spec, const ParameterValue& value) {
  if (const double* number = std::get_if<double>(&value)) {
    return takes_number(spec) && *number >= spec.min && *number <= spec.max &&
           (!spec.whole || *number == std::floor(*number));
  }
  return std::ranges::find(spec.choices, std::get<std::string>(value)) != spec.choices.end();
}

}  // namespace

bool takes_number(const ParameterSpec& spec) { return spec.choices.empty() || spec.min < spec.max; }

std::string allowed_values(const ParameterSpec& spec) {
  const std::string words = spec.choices.size() == 1
                                ? std::string(spec.choices.front())
                                : fmt::format("one of {}", fmt::join(spec.choices, ", "));
  if (!takes_number(spec)) return words;
  return fmt::format("{}a {}number from {} to {}", spec.choices.empty() ? "" : words + " or ",
                     spec.whole ? "whole " : "", spec.min, spec.max);
}

std::string key_path(const std::string& where, std::string_view name) {
  return where.empty() ? std::string(name) : fmt::format("{}.{}", where, name);
}

Parameters resolve_parameters(std::span<const ParameterSpec> specs, const Parameters& given,
                              const std::string& source, const std::string& where) {
  Parameters resolved;
  for (const ParameterSpec& spec : specs) {
    resolved.emplace(std::string(spec.name), spec.default_value);
  }
  for (const auto& [name, value] : given) {
    const std::string key = key_path(where, name);
    const auto spec = std::ranges::find(specs, name, &ParameterSpec::name);
    if (spec == specs.end()) {
      std::vector<std::string> names;
      names.reserve(specs.size());
      for (const ParameterSpec& known : specs) names.emplace_back(known.name);
      throw InputError(source, key, "",
                       names.empty()
                           ? "unknown parameter; there are none here"
                           : "unknown parameter; the nearest is " + nearest_name(name, names));
    }
    if (!allows(*spec, value)) {
      throw InputError(source, key, value_text(value), allowed_values(*spec));
    }
    resolved[name] = value;
  }
  return resolved;
}

double number(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  assert(found != parameters.end());
  return std::get<double>(found->second);
}

std::optional<double> number_unless_word(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  assert(found != parameters.end());
  const double* value = std::get_if<double>(&found->second);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

const std::string& word(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  assert(found != parameters.end());
  return std::get<std::string>(found->second);
}

}  // namespace headland

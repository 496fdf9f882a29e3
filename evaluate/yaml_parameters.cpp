#include "evaluate/yaml_parameters.h"

namespace headland {

std::vector<std::string> parameter_names(std::span<const ParameterSpec> specs) {
  std::vector<std::string> names;
  for (const ParameterSpec& spec : specs) names.emplace_back(spec.name);
  return names;
}

Parameters read_parameters(const YamlSection& section, std::span<const ParameterSpec> specs) {
  Parameters given;
  // One at a time, so that a message has its line.
  for (const ParameterSpec& spec : specs) {
    const std::string name(spec.name);
    const auto text = read_word(section, name, allowed_values(spec));
    if (!text) continue;
    const auto value = parse_number(*text);
    // A word where a number belongs (or NaN) is refused by resolve_parameters, which knows.
    const ParameterValue parameter =
        value && takes_number(spec) ? ParameterValue(*value) : ParameterValue(*text);
    const std::string place = place_of(section, name);
    const std::string where = place.substr(0, place.size() - name.size() - 1);
    resolve_parameters(specs, {{name, parameter}}, section.source, where);
    given[name] = parameter;
  }
  return resolve_parameters(specs, given, section.source, section.path);
}

}  // namespace headland

#include "evaluate/report_assumptions.h"

#include <yaml-cpp/yaml.h>

#include <string_view>

namespace headland {
namespace {

constexpr std::string_view kAssumed = "assumed";

void collect(const YAML::Node& node, const std::string& key, std::vector<Assumption>& found) {
  if (!node.IsMap()) return;
  if (const YAML::Node source = node["source"]; source && source.IsScalar()) {
    std::string why = source.Scalar();
    if (!why.starts_with(kAssumed)) return;
    why.erase(0, why.find_first_not_of(": ", kAssumed.size()));
    const YAML::Node value = node["value"];
    YAML::Emitter text;
    text << YAML::Flow << value;
    found.push_back({key, text.c_str(), why});
    return;
  }
  for (const auto& entry : node) {
    const std::string name = entry.first.as<std::string>();
    collect(entry.second, key.empty() ? name : key + "." + name, found);
  }
}

}  // namespace

std::vector<Assumption> assumptions_of(const std::filesystem::path& drive_file) {
  std::vector<Assumption> found;
  try {
    collect(YAML::LoadFile(drive_file.string()), "", found);
  } catch (const YAML::Exception&) {
    found.clear();
  }
  return found;
}

}  // namespace headland

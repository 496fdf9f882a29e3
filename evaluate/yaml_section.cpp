#include "evaluate/yaml_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "evaluate/atomic_file.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

std::string joined(const std::string& section, std::string_view key) {
  return section.empty() ? std::string(key) : section + "." + std::string(key);
}

std::string line_of(const YAML::Node& node) { return fmt::format("line {}", node.Mark().line + 1); }

// What stood there, short enough for a message.
std::string shown(const YAML::Node& node) {
  if (node.IsNull()) return "nothing";
  if (node.IsMap()) return "a mapping";
  if (node.IsSequence()) return "a list";
  const std::string& text = node.Scalar();
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

// Lookup that does not create the key, in a node that is known to be a mapping.
YAML::Node find(const YamlSection& section, std::string_view key) {
  const YAML::Node mapping = section.node;
  return mapping[std::string(key)];
}

[[noreturn]] void refuse(const YamlSection& section, std::string_view key, const YAML::Node& node,
                         const std::string& allowed) {
  throw InputError(section.source, line_of(node) + ": " + joined(section.path, key), shown(node),
                   allowed);
}

Eigen::Vector2d point_of(const YamlSection& section, std::string_view key, const YAML::Node& node) {
  if (node.IsSequence() && node.size() == 2 && node[0].IsScalar() && node[1].IsScalar()) {
    const std::optional<double> x = parse_number(node[0].Scalar());
    const std::optional<double> y = parse_number(node[1].Scalar());
    if (x && y) return {*x, *y};
  }
  refuse(section, key, node, "a point [x, y] of two finite numbers is needed");
}

std::vector<Eigen::Vector2d> points_of(const YamlSection& section, std::string_view key,
                                       const YAML::Node& node) {
  if (!node.IsSequence()) refuse(section, key, node, "a list of points [x, y] is needed");
  std::vector<Eigen::Vector2d> points;
  for (const YAML::Node& point : node) points.push_back(point_of(section, key, point));
  return points;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

YamlSection read_yaml(const std::filesystem::path& file) {
  YamlSection top{file.string(), "", {}};
  try {
    top.node = YAML::Load(read_text(file));
  } catch (const YAML::Exception& error) {
    throw InputError(file.string(), fmt::format("line {}", error.mark.line + 1), "",
                     "malformed YAML: " + error.msg);
  }
  if (!top.node.IsMap()) {
    throw InputError(file.string(), "line 1", shown(top.node),
                     "a mapping of keys to values is needed");
  }
  return top;
}

void refuse_unknown_keys(const YamlSection& section, const std::vector<std::string>& known) {
  std::set<std::string> seen;
  for (const auto& entry : section.node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const std::string place = line_of(entry.first) + ": " + joined(section.path, key);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InputError(section.source, place, "",
                       fmt::format("unknown key; did you mean '{}'? (known: {})",
                                   nearest_name(key, known), fmt::join(known, ", ")));
    }
    if (!seen.insert(key).second) {
      throw InputError(section.source, place, "", "the key is given twice");
    }
  }
}

std::string place_of(const YamlSection& section, std::string_view key) {
  for (const auto& entry : section.node) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) {
      return line_of(entry.second) + ": " + joined(section.path, key);
    }
  }
  return line_of(section.node) + ": " + joined(section.path, key);
}

std::optional<YamlSection> read_section(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsMap()) refuse(section, key, node, "a section (a mapping of keys) is needed");
  return YamlSection{section.source, joined(section.path, key), node};
}

std::optional<std::string> read_word(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsScalar() || node.Scalar().empty()) refuse(section, key, node, "a word is needed");
  return node.Scalar();
}

std::optional<double> read_number(const YamlSection& section, std::string_view key, double min,
                                  double max) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  const std::optional<double> value = node.IsScalar() ? parse_number(node.Scalar()) : std::nullopt;
  if (!value || *value < min || *value > max) {
    refuse(section, key, node, fmt::format("a number from {} to {} is needed", min, max));
  }
  return value;
}

std::optional<std::uint64_t> read_whole_number(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  std::uint64_t value = 0;
  if (node.IsScalar()) {
    const std::string& text = node.Scalar();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size()) return value;
  }
  refuse(section, key, node, "a whole number from 0 to 18446744073709551615 is needed");
}

std::optional<bool> read_flag(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (node.IsScalar() && node.Scalar() == "true") return true;
  if (node.IsScalar() && node.Scalar() == "false") return false;
  refuse(section, key, node, "true or false is needed");
}

std::optional<Eigen::Vector2d> read_point(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  return point_of(section, key, node);
}

std::optional<std::vector<Eigen::Vector2d>> read_points(const YamlSection& section,
                                                        std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  return points_of(section, key, node);
}

std::optional<std::vector<std::vector<Eigen::Vector2d>>> read_point_lists(
    const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsSequence()) refuse(section, key, node, "a list of lists of points is needed");
  std::vector<std::vector<Eigen::Vector2d>> lists;
  for (const YAML::Node& list : node) lists.push_back(points_of(section, key, list));
  return lists;
}

std::optional<std::vector<YamlSection>> read_sections(const YamlSection& section,
                                                      std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsSequence()) refuse(section, key, node, "a list of mappings is needed");
  std::vector<YamlSection> sections;
  for (const YAML::Node& item : node) {
    if (!item.IsMap()) refuse(section, key, item, "a mapping of keys to values is needed");
    sections.push_back({section.source, joined(section.path, key), item});
  }
  return sections;
}

}  // namespace headland

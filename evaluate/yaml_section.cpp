#include "evaluate/yaml_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "terrains/geo_frame.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

std::string joined(const std::string& section, std::string_view key) {
  return section.empty() ? std::string(key) : section + "." + std::string(key);
}

std::string line_of(const YAML::Node& node) { return fmt::format("line {}", node.Mark().line + 1); }

// Of a key and its value; a mapping put together of parts of a file has keys that stand nowhere.
std::string line_of_entry(const YAML::Node& key, const YAML::Node& value) {
  return line_of(key.Mark().is_null() ? value : key);
}

// The scalar that stood there, or a short list of scalars; empty for anything else.
std::string shown(const YAML::Node& node) {
  constexpr std::size_t kShortList = 3;
  if (node.IsScalar()) return node.Scalar();
  if (!node.IsSequence() || node.size() == 0 || node.size() > kShortList) return "";
  std::string list;
  for (const YAML::Node& item : node) {
    if (!item.IsScalar()) return "";
    list += (list.empty() ? "[" : ", ") + item.Scalar();
  }
  return list + "]";
}

std::string what_is_wanted(const YAML::Node& node, const std::string& wanted) {
  if (node.IsMap()) return wanted + " is needed, not a mapping";
  if (node.IsSequence()) return wanted + " is needed, not a list";
  if (node.IsNull()) return wanted + " is needed, there is no value";
  if (node.Scalar().empty()) return wanted + " is needed, not an empty text";
  return wanted + " is needed";
}

// Lookup that does not create the key, in a node that is known to be a mapping.
YAML::Node find(const YamlSection& section, std::string_view key) {
  const YAML::Node mapping = section.node;
  return mapping[std::string(key)];
}

// `item` says which part of the key's value `node` is: " point 3".
[[noreturn]] void refuse(const YamlSection& section, std::string_view key, const YAML::Node& node,
                         const std::string& wanted, const std::string& item = "") {
  // A value that is not there has no line of its own.
  const std::string place =
      node.IsNull() ? place_of(section, key) : line_of(node) + ": " + joined(section.path, key);
  throw InputError(section.source, place + item, shown(node), what_is_wanted(node, wanted));
}

Eigen::Vector2d point_of(const YamlSection& section, std::string_view key, const YAML::Node& node,
                         const std::string& item = "") {
  if (node.IsSequence() && node.size() == 2 && node[0].IsScalar() && node[1].IsScalar()) {
    const std::optional<double> x = parse_number(node[0].Scalar());
    const std::optional<double> y = parse_number(node[1].Scalar());
    if (x && y) return {*x, *y};
  }
  const std::string wanted = "a point [x, y] of two finite numbers";
  if (!node.IsSequence()) refuse(section, key, node, wanted, item);
  throw InputError(section.source, line_of(node) + ": " + joined(section.path, key) + item,
                   shown(node), wanted + " is needed");
}

std::vector<Eigen::Vector2d> points_of(const YamlSection& section, std::string_view key,
                                       const YAML::Node& node, const std::string& item = "") {
  if (!node.IsSequence()) refuse(section, key, node, "a list of points [x, y]", item);
  std::vector<Eigen::Vector2d> points;
  for (const YAML::Node& point : node) {
    points.push_back(
        point_of(section, key, point, fmt::format("{} point {}", item, points.size() + 1)));
  }
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
    std::vector<YAML::Node> documents = YAML::LoadAll(read_text(file));
    std::erase_if(documents, [](const YAML::Node& document) { return document.IsNull(); });
    if (documents.size() > 1) {
      throw InputError(file.string(), line_of(documents[1]), "",
                       "a second YAML document begins here; one file holds one");
    }
    if (!documents.empty()) top.node = documents.front();
  } catch (const YAML::Exception& error) {
    throw InputError(file.string(), fmt::format("line {}", error.mark.line + 1), "",
                     "malformed YAML: " + error.msg);
  }
  if (!top.node.IsMap()) {
    throw InputError(file.string(), "line 1", shown(top.node),
                     what_is_wanted(top.node, "a mapping of keys to values"));
  }
  return top;
}

bool has_key(const YamlSection& section, std::string_view key) {
  const YAML::Node node = section.node;
  return node[std::string(key)].IsDefined();
}

void refuse_unknown_keys(const YamlSection& section, const std::vector<std::string>& known) {
  std::set<std::string> seen;
  for (const auto& entry : section.node) {
    if (!entry.first.IsScalar()) {
      throw InputError(section.source, line_of(entry.first), "",
                       "a key that is a word is needed" +
                           (section.path.empty() ? "" : " in section " + section.path));
    }
    const std::string key = entry.first.Scalar();
    const std::string place =
        line_of_entry(entry.first, entry.second) + ": " + joined(section.path, key);
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
      return line_of_entry(entry.first, entry.second) + ": " + joined(section.path, key);
    }
  }
  if (section.node.Mark().is_null()) return joined(section.path, key);
  return line_of(section.node) + ": " + joined(section.path, key);
}

std::string place_of_itself(const YamlSection& section) {
  return line_of(section.node) + ": " + section.path;
}

std::optional<YamlSection> read_section(const YamlSection& section, std::string_view key,
                                        const std::string& wanted) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsMap()) refuse(section, key, node, wanted);
  return YamlSection{section.source, joined(section.path, key), node};
}

std::optional<std::string> read_word(const YamlSection& section, std::string_view key,
                                     const std::string& wanted) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsScalar() || node.Scalar().empty()) refuse(section, key, node, wanted);
  return node.Scalar();
}

std::optional<double> read_number(const YamlSection& section, std::string_view key,
                                  const NumberRange& range) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  const std::optional<double> value = node.IsScalar() ? parse_number(node.Scalar()) : std::nullopt;
  const bool fits =
      value && ((*value >= range.min && *value <= range.max) || (range.or_zero && *value == 0.0));
  if (!fits) {
    refuse(section, key, node,
           fmt::format("{}a number from {} to {}", range.or_zero ? "0 or " : "", range.min,
                       range.max));
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
  refuse(section, key, node, "a whole number from 0 to 18446744073709551615");
}

std::optional<bool> read_flag(const YamlSection& section, std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (node.IsScalar() && node.Scalar() == "true") return true;
  if (node.IsScalar() && node.Scalar() == "false") return false;
  refuse(section, key, node, "true or false");
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
  if (!node.IsSequence()) refuse(section, key, node, "a list of lists of points [x, y]");
  std::vector<std::vector<Eigen::Vector2d>> lists;
  for (const YAML::Node& list : node) {
    lists.push_back(points_of(section, key, list, fmt::format(" {}", lists.size() + 1)));
  }
  return lists;
}

std::optional<std::vector<YamlSection>> read_sections(const YamlSection& section,
                                                      std::string_view key) {
  const YAML::Node node = find(section, key);
  if (!node.IsDefined()) return std::nullopt;
  if (!node.IsSequence()) refuse(section, key, node, "a list of mappings");
  std::vector<YamlSection> sections;
  for (const YAML::Node& item : node) {
    if (!item.IsMap()) refuse(section, key, item, "a mapping of keys to values");
    sections.push_back({section.source, joined(section.path, key), item});
  }
  return sections;
}

std::optional<int> read_count(const YamlSection& section, std::string_view key, int least,
                              int most) {
  const auto text = read_word(section, key, "a whole number");
  if (!text) return std::nullopt;
  int value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  const bool whole = error == std::errc() && end == text->data() + text->size();
  if (whole && value >= least && value <= most) return value;
  throw InputError(section.source, place_of(section, key), *text,
                   fmt::format("a whole number from {} to {} is needed", least, most));
}

std::optional<std::size_t> read_one_of(const YamlSection& section, std::string_view key,
                                       const std::vector<std::string>& words) {
  const auto given = read_word(section, key);
  if (!given) return std::nullopt;
  return place_in(section, key, *given, "word", words);
}

std::size_t place_in(const YamlSection& section, std::string_view key, const std::string& given,
                     std::string_view what, const std::vector<std::string>& known) {
  const auto found = std::ranges::find(known, given);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  throw InputError(section.source, place_of(section, key), given,
                   fmt::format("unknown {}; did you mean '{}'? (known: {})", what,
                               nearest_name(given, known), fmt::join(known, ", ")));
}

std::string read_crs(const YamlSection& section) {
  const std::string crs = read_word(section, "crs").value_or("");
  if (crs.empty() || is_known_crs(crs)) return crs;
  throw InputError(section.source, place_of(section, "crs"), crs,
                   "unknown CRS; give an authority code such as EPSG:32615, WKT or PROJ");
}

std::filesystem::path read_file_name(const YamlSection& section, std::string_view key,
                                     const std::filesystem::path& folder) {
  const auto name = read_word(section, key);
  if (!name) return {};
  const std::filesystem::path file = (folder / *name).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(section.source, place_of(section, key), file.string(), "no such file");
  }
  return file;
}

}  // namespace headland

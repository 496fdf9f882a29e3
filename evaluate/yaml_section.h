// A mapping of a YAML file that knows where it stands, and values read from it: whatever is wrong
// throws InputError(file, "line N: section.key", value, what is allowed).
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace headland {

struct YamlSection {
  std::string source;  // the file
  std::string path;    // key path, "" for the file itself
  YAML::Node node;     // a mapping
};

// The file's top mapping. Throws for a missing file, malformed YAML, a second document, anything
// but one mapping.
YamlSection read_yaml(const std::filesystem::path& file);

// Throws for a key that is not in `known` (says the nearest one) and for a key given twice.
void refuse_unknown_keys(const YamlSection& section, const std::vector<std::string>& known);

// "line N: section.key"; the section's own line when the key is absent.
std::string place_of(const YamlSection& section, std::string_view key);

// "line N: section" of the section itself.
std::string place_of_itself(const YamlSection& section);

// Numbers in [min, max] and, where `or_zero`, 0, which then stands for a default.
struct NumberRange {
  double min = 0.0;
  double max = 0.0;
  bool or_zero = false;
};

// Values of a key; nullopt when the key is absent. `wanted` is for the message on what is no text.
std::optional<YamlSection> read_section(const YamlSection& section, std::string_view key,
                                        const std::string& wanted = "a section of keys");
std::optional<std::string> read_word(const YamlSection& section, std::string_view key,
                                     const std::string& wanted = "a word");
std::optional<double> read_number(const YamlSection& section, std::string_view key,
                                  const NumberRange& range);
std::optional<std::uint64_t> read_whole_number(const YamlSection& section, std::string_view key);
std::optional<bool> read_flag(const YamlSection& section, std::string_view key);
std::optional<Eigen::Vector2d> read_point(const YamlSection& section, std::string_view key);
std::optional<std::vector<Eigen::Vector2d>> read_points(const YamlSection& section,
                                                        std::string_view key);
std::optional<std::vector<std::vector<Eigen::Vector2d>>> read_point_lists(
    const YamlSection& section, std::string_view key);
std::optional<std::vector<YamlSection>> read_sections(const YamlSection& section,
                                                      std::string_view key);

// A CRS that GDAL understands; "" when the key is absent.
std::string read_crs(const YamlSection& section);

// The file that a key names, from `folder` on, which must exist; empty when the key is absent.
std::filesystem::path read_file_name(const YamlSection& section, std::string_view key,
                                     const std::filesystem::path& folder);

// The number that a text holds, all of it, finite; nullopt for anything else.
std::optional<double> parse_number(std::string_view text);

}  // namespace headland

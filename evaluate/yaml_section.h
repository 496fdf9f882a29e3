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
#include <utility>
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

bool has_key(const YamlSection& section, std::string_view key);

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
// In [least, most].
std::optional<int> read_count(const YamlSection& section, std::string_view key, int least,
                              int most);
// One of the words, as its place in the list.
std::optional<std::size_t> read_one_of(const YamlSection& section, std::string_view key,
                                       const std::vector<std::string>& words);
// Where `given`, a value of this key, stands among the known ones. Throws InputError, which calls
// it an unknown `what`.
std::size_t place_in(const YamlSection& section, std::string_view key, const std::string& given,
                     std::string_view what, const std::vector<std::string>& known);
std::optional<bool> read_flag(const YamlSection& section, std::string_view key);
std::optional<Eigen::Vector2d> read_point(const YamlSection& section, std::string_view key);
std::optional<std::vector<Eigen::Vector2d>> read_points(const YamlSection& section,
                                                        std::string_view key);
std::optional<std::vector<std::vector<Eigen::Vector2d>>> read_point_lists(
    const YamlSection& section, std::string_view key);
std::optional<std::vector<YamlSection>> read_sections(const YamlSection& section,
                                                      std::string_view key);

// What the word given stands for; `otherwise` when the key is absent.
template <typename Value>
Value read_choice(const YamlSection& section, std::string_view key, Value otherwise,
                  const std::vector<std::pair<std::string, Value>>& words) {
  std::vector<std::string> known;
  known.reserve(words.size());
  for (const auto& [word, value] : words) known.push_back(word);
  const std::optional<std::size_t> place = read_one_of(section, key, known);
  return place ? words[*place].second : otherwise;
}

// A CRS that GDAL understands; "" when the key is absent.
std::string read_crs(const YamlSection& section);

// The file that a key names, from `folder` on, which must exist; empty when the key is absent.
std::filesystem::path read_file_name(const YamlSection& section, std::string_view key,
                                     const std::filesystem::path& folder);

// The number that a text holds, all of it, finite; nullopt for anything else.
std::optional<double> parse_number(std::string_view text);

}  // namespace headland

#include "vehicle_models/drive_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>

#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "vehicle_models/draft.h"
#include "vehicle_models/drive_keys.h"

namespace headland {
namespace {

// Where a complaint about a node points to: file, line and key path.
struct Place {
  const std::string& file;
  std::string key;

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& value,
                           std::string allowed) const {
    std::string where = key;
    if (const int line = node.Mark().line + 1; line > 0) {
      where = fmt::format("line {}{}{}", line, key.empty() ? "" : ": ", key);
    }
    throw InputError(file, where, value, std::move(allowed));
  }
  Place child(std::string_view name) const {
    return {file, key.empty() ? std::string(name) : fmt::format("{}.{}", key, name)};
  }
};

std::string shown(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  return node.IsNull() ? "" : YAML::Dump(node);
}

struct KeyName {
  std::string name;
  bool optional = false;
};

// Establishes that `node` is a map of `known`, none missing that is not optional.
void check_keys(const YAML::Node& node, const Place& place, const std::vector<KeyName>& known) {
  std::vector<std::string> keys;
  keys.reserve(known.size());
  for (const KeyName& key : known) keys.push_back(key.name);
  if (!node.IsMap()) place.refuse(node, shown(node), "must be a map of keys");
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    const Place here = place.child(key);
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      here.refuse(
          entry.first, "",
          fmt::format("unknown key; the nearest known one is '{}'", nearest_name(key, keys)));
    }
    if (!seen.insert(key).second) here.refuse(entry.first, "", "stands twice");
  }
  for (const KeyName& key : known) {
    if (!key.optional && !seen.contains(key.name)) {
      place.child(key.name).refuse(node, "", "missing key");
    }
  }
}

std::vector<KeyName> names_of(const std::vector<DriveKey>& keys) {
  std::vector<KeyName> names(keys.size());
  std::transform(keys.begin(), keys.end(), names.begin(), [](const DriveKey& key) {
    return KeyName{std::string(key.key), key.optional};
  });
  return names;
}

double read_number(const YAML::Node& node, const Place& place, double min, double max) {
  const std::string written = shown(node);
  double value = 0.0;
  const char* const end = written.data() + written.size();
  const auto [rest, error] = std::from_chars(written.data(), end, value);
  const bool ok = node.IsScalar() && error == std::errc() && rest == end && std::isfinite(value) &&
                  value >= min && value <= max;
  if (!ok) {
    place.refuse(node, written,
                 min == max ? fmt::format("must be {:g}", min)
                            : fmt::format("must be a number from {:g} to {:g}", min, max));
  }
  return value;
}

// The `value` of a node {value: ..., source: "..."}.
YAML::Node sourced_value(const YAML::Node& node, const Place& place) {
  if (!node.IsMap()) {
    place.refuse(node, shown(node),
                 fmt::format("a number needs its source: {{value: {}, source: \"assumed: why\"}}",
                             shown(node)));
  }
  check_keys(node, place, {{"value"}, {"source"}});
  const YAML::Node source = node["source"];
  if (!source.IsScalar() || source.Scalar().empty()) {
    place.child("source").refuse(source, shown(source),
                                 "must say where the number is from, or 'assumed: why'");
  }
  return node["value"];
}

void read_word(const YAML::Node& node, const Place& place, const DriveKey& spec) {
  const std::string word = shown(node);
  const auto found = std::find(spec.words.begin(), spec.words.end(), word);
  if (!node.IsScalar() || found == spec.words.end()) {
    place.refuse(node, word, fmt::format("must be {}", fmt::join(spec.words, " or ")));
  }
  spec.choose(static_cast<std::size_t>(found - spec.words.begin()));
}

void read_key(const YAML::Node& node, const Place& place, const DriveKey& spec) {
  if (spec.number != nullptr) {
    *spec.number = spec.scale * read_number(sourced_value(node, place), place, spec.min, spec.max);
  } else if (spec.integer != nullptr) {
    const YAML::Node value = sourced_value(node, place);
    const double read = read_number(value, place, spec.min, spec.max);
    if (read != std::floor(read)) place.refuse(value, shown(value), "must be a whole number");
    *spec.integer = static_cast<int>(read);
  } else if (spec.text != nullptr) {
    if (!node.IsScalar() || node.Scalar().empty()) {
      place.refuse(node, shown(node), "must be a name");
    }
    *spec.text = node.Scalar();
  } else {
    read_word(node, place, spec);
  }
}

void read_keys(const YAML::Node& node, const Place& place, const std::vector<DriveKey>& keys) {
  for (const DriveKey& spec : keys) {
    const YAML::Node value = node[std::string(spec.key)];
    if (value.IsDefined()) read_key(value, place.child(spec.key), spec);
  }
}

// Draft stands either per metre of width or as a tillage law, and that by a tool's name or by its
// coefficients.
void check_draft(const YAML::Node& root, const Place& top) {
  const YAML::Node implement = root["implement"];
  const bool per_metre = implement[std::string(kDraftPerMetre)].IsDefined();
  const YAML::Node law = root[std::string(kDraft)];
  const Place of_implement = top.child("implement").child(kDraftPerMetre);
  if (!law.IsDefined()) {
    if (!per_metre) of_implement.refuse(implement, "", "missing key, or a section 'draft' instead");
    return;
  }
  if (per_metre) of_implement.refuse(implement, "", "only one of it and the section 'draft'");
  const Place place = top.child(kDraft);
  const YAML::Node tools = law["tools"];
  const YAML::Node name = law[std::string(kDraftTool)];
  if (!name.IsDefined()) {
    if (!law["a"].IsDefined()) place.child("a").refuse(law, "", "missing key, or a 'tool' instead");
    return;
  }
  for (const char* key : {"a", "b", "c"}) {
    if (law[key].IsDefined()) {
      place.child(key).refuse(law[key], "", "stands in the row of the tool; give one of the two");
    }
  }
  const auto row = std::ranges::find(d497_tools(), name.Scalar(), &D497Tool::name);
  const YAML::Node depth = law["depth_cm"];
  if (row->at_any_depth && depth["value"].IsDefined() && depth["value"].Scalar() != "1") {
    place.child("depth_cm")
        .refuse(depth, depth["value"].Scalar(),
                fmt::format("1: {} draws the same at any depth (T = 1 in D497)", row->name));
  }
  if (row->per_tool && !tools.IsDefined()) {
    place.child("tools").refuse(law, "", fmt::format("missing key: {} draws per tool", row->name));
  }
  if (!row->per_tool && tools.IsDefined()) {
    place.child("tools").refuse(tools, "",
                                fmt::format("{} draws per metre of working width", row->name));
  }
}

YAML::Node parse_file(const std::string& file) {
  try {
    std::vector<YAML::Node> documents = YAML::LoadAll(read_text(file));
    std::erase_if(documents, [](const YAML::Node& document) { return document.IsNull(); });
    if (documents.size() > 1) {
      throw InputError(file, fmt::format("line {}", documents[1].Mark().line + 1), "",
                       "a second YAML document begins here; one file holds one");
    }
    return documents.empty() ? YAML::Node() : documents.front();
  } catch (const YAML::Exception& error) {
    throw InputError(file, fmt::format("line {}", error.mark.line + 1), "",
                     "malformed YAML: " + error.msg);
  }
}

}  // namespace

void read_drive(const std::filesystem::path& path, Vehicle& vehicle) {
  const std::string file = path.string();
  const YAML::Node root = parse_file(file);
  const auto stands = [&root](std::string_view section) {
    return root.IsMap() && root[std::string(section)].IsDefined();
  };
  if (stands(kTrailing)) vehicle.implement.trailing.emplace();
  if (stands(kDraft)) vehicle.implement.tillage.emplace();
  const std::vector<DriveKey> head = {{.key = "description", .text = &vehicle.description}};
  const std::vector<DriveSection> sections = sections_of(vehicle);
  std::vector<KeyName> known = names_of(head);
  for (const DriveSection& section : sections) known.push_back({std::string(section.name)});
  for (const std::string_view section : {kDraft, kTrailing}) {
    known.push_back({std::string(section), true});
  }

  const Place top{file, ""};
  check_keys(root, top, known);
  read_keys(root, top, head);
  for (const DriveSection& section : sections) {
    const YAML::Node node = root[std::string(section.name)];
    const Place place = top.child(section.name);
    check_keys(node, place, names_of(section.keys));
    read_keys(node, place, section.keys);
  }
  check_draft(root, top);
}

}  // namespace headland

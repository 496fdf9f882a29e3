#include "vehicle_models/vehicle_loader.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>

#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "vehicle_models/vehicle_check.h"
#include "vehicle_models/vehicle_keys.h"

namespace headland {
namespace {

constexpr std::string_view kFileName = "vehicle.yaml";

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

// Establishes that `node` is a map of exactly `keys`.
void check_keys(const YAML::Node& node, const Place& place, const std::vector<std::string>& keys) {
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
  for (const std::string& key : keys) {
    if (!seen.contains(key)) place.child(key).refuse(node, "", "missing key");
  }
}

std::vector<std::string> names_of(const std::vector<VehicleKey>& keys) {
  std::vector<std::string> names(keys.size());
  std::transform(keys.begin(), keys.end(), names.begin(),
                 [](const VehicleKey& key) { return std::string(key.key); });
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
  check_keys(node, place, {"value", "source"});
  const YAML::Node source = node["source"];
  if (!source.IsScalar() || source.Scalar().empty()) {
    place.child("source").refuse(source, shown(source),
                                 "must say where the number is from, or 'assumed: why'");
  }
  return node["value"];
}

Eigen::Vector3d read_vector(const YAML::Node& node, const Place& place, double min, double max) {
  if (!node.IsSequence() || node.size() != 3) {
    place.refuse(node, shown(node), "must be a list of three numbers");
  }
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) vector[i] = read_number(node[i], place, min, max);
  return vector;
}

void read_key(const YAML::Node& node, const Place& place, const VehicleKey& spec) {
  if (spec.number != nullptr) {
    *spec.number = spec.scale * read_number(sourced_value(node, place), place, spec.min, spec.max);
  } else if (spec.integer != nullptr) {
    const YAML::Node value = sourced_value(node, place);
    const double read = read_number(value, place, spec.min, spec.max);
    if (read != std::floor(read)) place.refuse(value, shown(value), "must be a whole number");
    *spec.integer = static_cast<int>(read);
  } else if (spec.vector != nullptr) {
    *spec.vector = read_vector(sourced_value(node, place), place, spec.min, spec.max);
  } else if (spec.flag != nullptr) {
    if (!YAML::convert<bool>::decode(node, *spec.flag)) {
      place.refuse(node, shown(node), "must be true or false");
    }
  } else if (spec.text != nullptr) {
    if (!node.IsScalar() || node.Scalar().empty())
      place.refuse(node, shown(node), "must be a name");
    *spec.text = node.Scalar();
  } else {
    const std::string word = shown(node);
    if (word != "lead_acid" && word != "lfp") {
      place.refuse(node, word, "must be lead_acid or lfp");
    }
    *spec.chemistry = word == "lfp" ? Chemistry::kLfp : Chemistry::kLeadAcid;
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

Vehicle read_vehicle(const std::filesystem::path& folder) {
  const std::string file = (folder / kFileName).string();
  const YAML::Node root = parse_file(file);
  Vehicle vehicle;
  vehicle.folder = folder;
  vehicle.name = folder.filename().string();

  std::string mesh;
  const std::vector<VehicleKey> head = {{.key = "description", .text = &vehicle.description},
                                        {.key = "mesh", .text = &mesh}};
  const std::vector<VehicleSection> sections = sections_of(vehicle);
  std::vector<std::string> known = names_of(head);
  std::transform(sections.begin(), sections.end(), std::back_inserter(known),
                 [](const VehicleSection& section) { return std::string(section.name); });

  const Place top{file, ""};
  check_keys(root, top, known);
  for (const VehicleKey& spec : head) {
    read_key(root[std::string(spec.key)], top.child(spec.key), spec);
  }
  for (const VehicleSection& section : sections) {
    const YAML::Node node = root[std::string(section.name)];
    const Place place = top.child(section.name);
    check_keys(node, place, names_of(section.keys));
    for (const VehicleKey& spec : section.keys) {
      read_key(node[std::string(spec.key)], place.child(spec.key), spec);
    }
  }
  vehicle.mesh_file = folder / mesh;
  if (!std::filesystem::is_regular_file(vehicle.mesh_file)) {
    top.child("mesh").refuse(root["mesh"], mesh, "no such file in the vehicle's folder");
  }
  check_vehicle(vehicle, file);
  return vehicle;
}

std::filesystem::path built_in_folder() {
  const char* const replaced = std::getenv("HEADLAND_VEHICLE_DIR");
  return replaced != nullptr ? replaced : HEADLAND_VEHICLE_DIR;
}

}  // namespace

Vehicle load_vehicle(const std::string& name_or_folder) {
  const std::vector<std::string> names = vehicle_names();
  if (std::find(names.begin(), names.end(), name_or_folder) != names.end()) {
    return read_vehicle(built_in_folder() / name_or_folder);
  }
  std::filesystem::path folder = name_or_folder;
  if (!folder.has_filename()) folder = folder.parent_path();
  if (std::filesystem::is_directory(folder)) return read_vehicle(folder);
  throw InputError("", "vehicle", name_or_folder,
                   fmt::format("no such vehicle or folder; the nearest known vehicle is '{}' of {}",
                               nearest_name(name_or_folder, names), fmt::join(names, ", ")));
}

std::vector<std::string> vehicle_names() {
  const std::filesystem::path folder = built_in_folder();
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (std::filesystem::is_regular_file(entry.path() / kFileName)) {
      names.push_back(entry.path().filename().string());
    }
  }
  if (names.empty()) {
    throw InputError(folder.string(), "", "", "holds no vehicles; check HEADLAND_VEHICLE_DIR");
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace headland

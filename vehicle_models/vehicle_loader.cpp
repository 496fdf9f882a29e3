#include "vehicle_models/vehicle_loader.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <set>
#include <span>
#include <string_view>

#include "terrains/input_error.h"
#include "vehicle_models/vehicle_check.h"

namespace headland {
namespace {

constexpr std::string_view kFileName = "vehicle.yaml";
constexpr double kDegree = std::numbers::pi / 180.0;

// One key of the file. Exactly one of the targets is set; min and max are in the file's unit.
struct KeySpec {
  std::string_view key;
  double min = 0.0;
  double max = 0.0;
  double* number = nullptr;
  double scale = 1.0;  // struct's unit over file's unit
  int* integer = nullptr;
  Eigen::Vector3d* vector = nullptr;
  bool* flag = nullptr;
  std::string* text = nullptr;
  Chemistry* chemistry = nullptr;
};

// clang-format off
KeySpec number(std::string_view key, double& target, double min, double max, double scale = 1.0) {
  return {.key = key, .min = min, .max = max, .number = &target, .scale = scale};
}
KeySpec integer(std::string_view key, int& target, double min, double max) {
  return {.key = key, .min = min, .max = max, .integer = &target};
}
KeySpec vector(std::string_view key, Eigen::Vector3d& target, double min, double max) {
  return {.key = key, .min = min, .max = max, .vector = &target};
}
KeySpec flag(std::string_view key, bool& target) { return {.key = key, .flag = &target}; }
KeySpec text(std::string_view key, std::string& target) { return {.key = key, .text = &target}; }
// clang-format on

struct Section {
  std::string_view name;
  std::vector<KeySpec> keys;
};

std::vector<KeySpec> axle_keys(Axle& axle, double min_x_m, double max_x_m) {
  return {number("x_B_m", axle.x_B_m, min_x_m, max_x_m),
          number("track_m", axle.track_m, 0.2, 6.0),
          number("radius_m", axle.radius_m, 0.05, 2.0),
          number("width_m", axle.width_m, 0.01, 2.0),
          number("wheel_inertia_kg_m2", axle.wheel_inertia_kg_m2, 1e-4, 1e4),
          number("vertical_stiffness_n_per_m", axle.vertical_stiffness_n_per_m, 1e3, 1e8),
          number("vertical_damping_n_s_per_m", axle.vertical_damping_n_s_per_m, 0.0, 1e6),
          flag("driven", axle.driven)};
}

// Every section and key of a vehicle file, with its range and its place in `v`.
std::vector<Section> sections_of(Vehicle& v) {
  return {
      {"body",
       {number("mass_kg", v.body.mass_kg, 10.0, 60000.0), vector("com_B", v.body.com_B, -5.0, 10.0),
        vector("inertia_kg_m2", v.body.inertia_kg_m2, 1e-3, 1e6),
        number("length_m", v.body.length_m, 0.3, 20.0),
        number("width_m", v.body.width_m, 0.2, 10.0), number("height_m", v.body.height_m, 0.1, 6.0),
        number("rear_overhang_m", v.body.rear_overhang_m, 0.0, 10.0),
        number("ground_clearance_m", v.body.ground_clearance_m, 0.02, 3.0)}},
      {"rear", axle_keys(v.rear, 0.0, 0.0)},
      {"front", axle_keys(v.front, 0.3, 10.0)},
      {"steering",
       {number("max_angle_deg", v.steering.max_angle_rad, 1.0, 80.0, kDegree),
        number("max_rate_deg_per_s", v.steering.max_rate_rad_per_s, 1.0, 360.0, kDegree)}},
      {"drivetrain",
       {number("gear_ratio", v.drivetrain.gear_ratio, 0.1, 1000.0),
        number("efficiency", v.drivetrain.efficiency, 0.1, 1.0),
        number("brake_torque_max_nm", v.drivetrain.brake_torque_max_nm, 1.0, 1e6)}},
      {"motor",
       {number("max_torque_nm", v.motor.max_torque_nm, 0.1, 1e5),
        number("max_power_w", v.motor.max_power_w, 10.0, 1e6),
        number("max_speed_rad_per_s", v.motor.max_speed_rad_per_s, 1.0, 5000.0),
        number("copper_loss_kc", v.motor.copper_loss_kc, 0.0, 1000.0),
        number("iron_loss_ki", v.motor.iron_loss_ki, 0.0, 1000.0),
        number("windage_loss_kw", v.motor.windage_loss_kw, 0.0, 1.0),
        number("constant_loss_w", v.motor.constant_loss_w, 0.0, 1e5),
        number("regeneration_fraction", v.motor.regeneration_fraction, 0.0, 1.0),
        number("regeneration_min_speed_mps", v.motor.regeneration_min_speed_mps, 0.0, 10.0)}},
      {"battery",
       {{.key = "chemistry", .chemistry = &v.battery.chemistry},
        integer("cells_in_series", v.battery.cells_in_series, 1.0, 1000.0),
        number("capacity_ah", v.battery.capacity_ah, 0.1, 10000.0),
        number("resistance_ohm", v.battery.resistance_ohm, 1e-5, 10.0),
        number("polarisation_resistance_ohm", v.battery.polarisation_resistance_ohm, 0.0, 10.0),
        number("polarisation_time_constant_s", v.battery.polarisation_time_constant_s, 0.1, 1e5),
        number("max_charge_c_rate", v.battery.max_charge_c_rate, 0.0, 20.0),
        number("peukert", v.battery.peukert, 1.0, 1.6),
        number("empty_soc", v.battery.empty_soc, 0.0, 0.9),
        number("auxiliary_power_w", v.battery.auxiliary_power_w, 0.0, 1e5)}},
      {"implement",
       {text("name", v.implement.name), number("mass_kg", v.implement.mass_kg, 0.0, 20000.0),
        number("x_B_m", v.implement.x_B_m, -10.0, 10.0),
        number("working_width_m", v.implement.working_width_m, 0.05, 100.0),
        number("draft_n_per_m", v.implement.draft_n_per_m, 0.0, 1e5),
        number("draft_height_m", v.implement.draft_height_m, -1.0, 2.0),
        number("shaft_power_w", v.implement.shaft_power_w, 0.0, 1e6),
        number("lift_time_s", v.implement.lift_time_s, 0.0, 60.0),
        number("lift_energy_j", v.implement.lift_energy_j, 0.0, 1e6)}},
      {"driver",
       {number("work_speed_mps", v.driver.work_speed_mps, 0.05, 15.0),
        number("turn_speed_mps", v.driver.turn_speed_mps, 0.05, 15.0),
        number("transit_speed_mps", v.driver.transit_speed_mps, 0.05, 15.0),
        number("reverse_speed_mps", v.driver.reverse_speed_mps, 0.05, 15.0),
        number("max_acceleration_mps2", v.driver.max_acceleration_mps2, 0.05, 5.0),
        number("max_lateral_acceleration_mps2", v.driver.max_lateral_acceleration_mps2, 0.05, 5.0),
        number("look_ahead_m", v.driver.look_ahead_m, 0.1, 50.0),
        number("look_ahead_time_s", v.driver.look_ahead_time_s, 0.0, 10.0)}},
  };
}

// Where a complaint about a node points to: file, line and key path.
struct Place {
  const std::string& file;
  std::string key;

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& value,
                           std::string allowed) const {
    const int line = node.Mark().line + 1;
    const std::string where = line > 0 ? fmt::format("line {}: {}", line, key) : key;
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

void read_key(const YAML::Node& node, const Place& place, const KeySpec& spec) {
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
    return YAML::LoadFile(file);
  } catch (const YAML::BadFile&) {
    throw InputError(file, "", "", "cannot be read; a vehicle is a folder with a vehicle.yaml");
  } catch (const YAML::ParserException& error) {
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
  const std::vector<KeySpec> head = {text("description", vehicle.description), text("mesh", mesh)};
  const std::vector<Section> sections = sections_of(vehicle);
  std::vector<std::string> known;
  for (const KeySpec& spec : head) known.emplace_back(spec.key);
  for (const Section& section : sections) known.emplace_back(section.name);

  const Place top{file, ""};
  check_keys(root, top, known);
  for (const KeySpec& spec : head) {
    read_key(root[std::string(spec.key)], top.child(spec.key), spec);
  }
  for (const Section& section : sections) {
    const YAML::Node node = root[std::string(section.name)];
    const Place place = top.child(section.name);
    std::vector<std::string> keys;
    for (const KeySpec& spec : section.keys) keys.emplace_back(spec.key);
    check_keys(node, place, keys);
    for (const KeySpec& spec : section.keys) {
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

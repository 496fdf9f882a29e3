// headland list: what there is to choose from, with its source and its parameters.
#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "planner/grid_planners.h"
#include "planner/planners.h"
#include "planner/region_planners.h"
#include "terrains/json_text.h"
#include "terrains/soil.h"
#include "terrains/terrain_source.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

Json parameters_json(std::span<const ParameterSpec> specs) {
  Json list = Json::array();
  for (const ParameterSpec& spec : specs) {
    Json entry;
    entry["name"] = spec.name;
    std::visit([&](const auto& value) { entry["default"] = value; }, spec.default_value);
    if (takes_number(spec)) {
      entry["min"] = spec.min;
      entry["max"] = spec.max;
      entry["whole"] = spec.whole;
    }
    if (!spec.choices.empty()) entry["choices"] = spec.choices;
    entry["allowed"] = allowed_values(spec);
    entry["what"] = spec.what;
    list.push_back(std::move(entry));
  }
  return list;
}

Json planners_json() {
  Json list = Json::array();
  for (const PlannerEntry& entry : planners()) {
    list.push_back({{"name", entry.name},
                    {"source", entry.source},
                    {"plans_on", "field"},
                    {"parameters", parameters_json(entry.parameters)}});
  }
  for (const GridPlannerEntry& entry : grid_planners()) {
    list.push_back({{"name", entry.name},
                    {"source", entry.source},
                    {"plans_on", "grid map"},
                    {"parameters", parameters_json(entry.parameters)}});
  }
  for (const RegionPlannerEntry& entry : region_planners()) {
    list.push_back({{"name", entry.name},
                    {"source", entry.source},
                    {"plans_on", "parts of a field"},
                    {"parameters", parameters_json(entry.parameters)}});
  }
  return list;
}

Json generators_json() {
  Json list = Json::array();
  for (const GeneratorEntry& entry : generators()) {
    list.push_back({{"name", entry.name},
                    {"what", entry.what},
                    {"parameters", parameters_json(entry.parameters)}});
  }
  return list;
}

Json soils_json() {
  Json list = Json::array();
  for (const Soil& soil : soils()) {
    list.push_back({{"name", soil.name},
                    {"law", law_text(soil)},
                    {"lateral_gamma_rad", soil.lateral_gamma_rad},
                    {"texture", std::string(texture_name(soil.texture))},
                    {"source", soil.source}});
  }
  return list;
}

Json vehicles_json() {
  Json list = Json::array();
  for (const std::string& name : vehicle_names()) {
    const Vehicle vehicle = load_vehicle(name);
    const Battery& battery = vehicle.battery;
    list.push_back({{"name", vehicle.name},
                    {"what", vehicle.description},
                    {"mass_kg", total_mass_kg(vehicle)},
                    {"steering", steering_word(vehicle.steering.kind)},
                    {"motors", motor_count(vehicle)},
                    {"motor_power_w", motor_count(vehicle) * vehicle.motor.max_power_w},
                    {"battery_ah", battery.capacity_ah},
                    {"implement", vehicle.implement.name},
                    {"working_width_m", vehicle.implement.working_width_m},
                    {"turning_radius_m", min_turning_radius_m(vehicle)}});
  }
  return list;
}

// "  length_m = 40 (1 to 500): what" a line.
std::string parameters_text(const Json& parameters) {
  std::string text;
  for (const Json& entry : parameters) {
    const std::string value = entry["default"].is_number()
                                  ? fmt::format("{}", entry["default"].get<double>())
                                  : entry["default"].get<std::string>();
    text += fmt::format("    {:<24} {:>10}   {}; {}\n", entry["name"].get<std::string>(), value,
                        entry["what"].get<std::string>(), entry["allowed"].get<std::string>());
  }
  return text;
}

std::string entry_text(const Json& entry) {
  const std::string name = entry["name"].get<std::string>();
  if (entry.contains("parameters")) {
    const char* key = entry.contains("what") ? "what" : "source";
    return fmt::format("{:<19} {}\n", name, entry[key].get<std::string>()) +
           parameters_text(entry["parameters"]);
  }
  if (entry.contains("law")) {
    return fmt::format("{:<16} {}\n    source: {}\n", name, entry["law"].get<std::string>(),
                       entry["source"].get<std::string>());
  }
  return fmt::format(
      "{:<24} {}\n    {:.0f} kg with implement, {:.1f} kW, {:.0f} Ah, {} {:.4g} m wide, {} "
      "steering, "
      "turns on {:.2f} m\n",
      name, entry["what"].get<std::string>(), entry["mass_kg"].get<double>(),
      entry["motor_power_w"].get<double>() / 1000.0, entry["battery_ah"].get<double>(),
      entry["implement"].get<std::string>(), entry["working_width_m"].get<double>(),
      entry["steering"].get<std::string>(), entry["turning_radius_m"].get<double>());
}

struct Listing {
  const char* name;
  const char* what;
  Json (*entries)();
};

constexpr Listing kListings[] = {
    {"planners", "Planners, their source and parameters", planners_json},
    {"vehicles", "Built-in vehicles", vehicles_json},
    {"soils", "Soils, their law of traction and source", soils_json},
    {"generators", "Terrain generators and their parameters", generators_json},
};

}  // namespace

void add_list_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("list", "Tell what a scenario can choose from");
  command->require_subcommand(1);
  command->footer("Example:\n  headland list planners");
  for (const Listing& listing : kListings) {
    auto* kind = command->add_subcommand(listing.name, listing.what);
    auto json = std::make_shared<bool>(false);
    kind->add_flag("--json", *json, "Print the list as JSON");
    kind->footer(fmt::format("Example:\n  headland list {}", listing.name));
    kind->callback([json, listing, &exit_code] {
      const Json entries = listing.entries();
      if (*json) fmt::print("{}\n", json_text(entries, 2));
      for (const Json& entry : entries) {
        if (!*json) fmt::print("{}", entry_text(entry));
      }
      exit_code = kExitRan;
    });
  }
}

}  // namespace headland

// headland vehicle check: loads one vehicle, tells what follows from its numbers, draws it.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numbers>

#include "apps/commands.h"
#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "render/gnuplot.h"
#include "render/vehicle_charts.h"
#include "render/vehicle_mesh.h"
#include "render/vehicle_sheet.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"
#include "terrains/soil.h"
#include "vehicle_models/draft.h"
#include "vehicle_models/gradeability.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  std::string vehicle;
  std::string soil = "firm";
  std::string picture;
  std::string charts;
  CommonOptions common;
};

// Every figure once: its key in the JSON, its value, and how people read it.
struct Figure {
  std::string key;
  Json value;
  std::string label;
  std::string text;
};

struct Figures {
  std::vector<Figure> lines;

  void add(std::string key, Json value, std::string label, std::string text) {
    lines.push_back({std::move(key), std::move(value), std::move(label), std::move(text)});
  }
};

void add_body(const Vehicle& vehicle, Figures& out) {
  const Body& body = vehicle.body;
  const Eigen::Vector3d com_B = total_com_B(vehicle);
  const Eigen::Vector3d& inertia = body.inertia_kg_m2;
  const AxleLoads loads = static_axle_loads(vehicle);
  out.add("mass_kg", body.mass_kg, "Mass", fmt::format("{:.0f} kg", body.mass_kg));
  out.add("total_mass_kg", total_mass_kg(vehicle), "Mass with implement",
          fmt::format("{:.0f} kg", total_mass_kg(vehicle)));
  out.add("com_B_m", {com_B.x(), com_B.y(), com_B.z()}, "Centre of mass",
          fmt::format("{:.2f} m {} {}, {:.2f} m up", std::abs(com_B.x()),
                      com_B.x() < 0.0 ? "behind" : "ahead of",
                      vehicle.steering.kind == SteeringKind::kFront ? "the rear axle"
                                                                    : "the middle of the axles",
                      com_B.z()));
  out.add("inertia_kg_m2", {inertia.x(), inertia.y(), inertia.z()}, "Inertia roll, pitch, yaw",
          fmt::format("{:.0f}, {:.0f}, {:.0f} kg m²", inertia.x(), inertia.y(), inertia.z()));
  out.add("size_m", {body.length_m, body.width_m, body.height_m}, "Length, width, height",
          fmt::format("{:.2f} x {:.2f} x {:.2f} m", body.length_m, body.width_m, body.height_m));
  out.add("wheelbase_m", wheelbase_m(vehicle), "Wheelbase",
          fmt::format("{:.2f} m", wheelbase_m(vehicle)));
  out.add("track_m", {vehicle.rear.track_m, vehicle.front.track_m}, "Track rear, front",
          fmt::format("{:.2f}, {:.2f} m", vehicle.rear.track_m, vehicle.front.track_m));
  out.add("wheel_radius_m", {vehicle.rear.radius_m, vehicle.front.radius_m},
          "Wheel radius rear, front",
          fmt::format("{:.2f}, {:.2f} m", vehicle.rear.radius_m, vehicle.front.radius_m));
  out.add("wheel_load_n", {0.5 * loads.rear_n, 0.5 * loads.front_n}, "Wheel load rear, front",
          fmt::format("{:.2f}, {:.2f} kN", 0.5e-3 * loads.rear_n, 0.5e-3 * loads.front_n));
}

// Motors at the wheels may all be at a limit of their own, of torque or of grip.
std::string_view climbing_limit(double climbs, double by_motor, double by_grip) {
  constexpr double kClearlyLess = 0.9;  // than either limit alone, which slip may lower a little
  if (climbs < kClearlyLess * std::min(by_motor, by_grip)) return "motors' and grip's limit";
  return by_motor < by_grip ? "motor's limit" : "grip's limit";
}

void add_limits(const Vehicle& vehicle, const Soil& soil, Figures& out) {
  const double side = degrees(side_stability_angle_rad(vehicle));
  const double up = degrees(nose_up_stability_angle_rad(vehicle));
  const double down = degrees(nose_down_stability_angle_rad(vehicle));
  out.add("side_stability_deg", side, "Tips to the side at", fmt::format("{:.1f}°", side));
  out.add("nose_up_stability_deg", up, "Tips backwards at", fmt::format("{:.1f}° uphill", up));
  out.add("nose_down_stability_deg", down, "Tips forwards at",
          fmt::format("{:.1f}° downhill", down));
  out.add("turning_radius_m", min_turning_radius_m(vehicle), "Turning radius",
          fmt::format("{:.2f} m", min_turning_radius_m(vehicle)));
  out.add("planning_radius_m", planning_turning_radius_m(vehicle), "Plans turn with",
          fmt::format("{:.2f} m, to leave steering for corrections",
                      planning_turning_radius_m(vehicle)));
  out.add("top_speed_mps", top_speed_mps(vehicle), "Top speed",
          fmt::format("{:.2f} m/s", top_speed_mps(vehicle)));
  const SoilFigures on_soil = figures_on(vehicle, soil);
  const double by_motor = max_grade(vehicle, on_soil.rolling_resistance);
  const double by_grip = max_grade_by_grip(vehicle, on_soil.net_pull, on_soil.rolling_resistance);
  const double climbs = gradeability(vehicle, soil);
  out.add("gradeability", climbs, "Climbs",
          fmt::format("{:.0f} % ({})", 100.0 * climbs, climbing_limit(climbs, by_motor, by_grip)));
  out.add("gradeability_by_motor", by_motor, "", "");
  out.add("gradeability_by_grip", by_grip, "", "");
}

void add_pull(const Vehicle& vehicle, const Soil& soil, Figures& out) {
  const double speed_mps = vehicle.driver.work_speed_mps;
  const SoilFigures on_soil = figures_on(vehicle, soil);
  const double draft = draft_n(vehicle.implement, soil.texture, speed_mps);
  const double needed =
      needed_pull_n(vehicle, on_soil.rolling_resistance, soil.texture, speed_mps, true);
  const HitchPull pull = hitch_pull(vehicle, on_soil, speed_mps);
  const double available = std::min(pull.by_motor_n, pull.by_grip_n);
  out.add("draft_n", draft, fmt::format("Draft at {:g} m/s", speed_mps),
          fmt::format("{:.2f} kN, {} soil", 1e-3 * draft, texture_name(soil.texture)));
  out.add("pull_needed_n", needed, "Pull at work",
          fmt::format("{:.2f} of {:.2f} kN ({})", 1e-3 * needed, 1e-3 * available,
                      pull.by_motor_n < pull.by_grip_n ? "motor's limit" : "grip's limit"));
  out.add("pull_by_motor_n", pull.by_motor_n, "", "");
  out.add("pull_by_grip_n", pull.by_grip_n, "", "");
  if (vehicle.implement.trailing) {
    out.add("hitch_load_n", hitch_load_n(vehicle), "Load on the hitch pin",
            fmt::format("{:.2f} kN", 1e-3 * hitch_load_n(vehicle)));
  }
}

void add_endurance(const Vehicle& vehicle, const Soil& soil, bool working, Figures& out) {
  const double speed_mps = vehicle.driver.work_speed_mps;
  const Endurance figure = endurance(
      vehicle, speed_mps, figures_on(vehicle, soil).rolling_resistance, working, soil.texture);
  const std::string prefix = working ? "working_" : "raised_";
  out.add(prefix + "power_w", figure.power_w, "", "");
  out.add(prefix + "time_h", figure.time_h, "", "");
  const std::string text =
      figure.time_h > 0.0 ? fmt::format("{:.1f} km, {:.1f} h, {:.2g} kW", 1e-3 * figure.distance_m,
                                        figure.time_h, 1e-3 * figure.power_w)
                          : "cannot hold this speed";
  out.add(prefix + "range_m", figure.distance_m,
          fmt::format("{} at {:g} m/s", working ? "Works" : "Drives", speed_mps), text);
}

Figures figures_of(const Vehicle& vehicle, const Soil& soil) {
  Figures figures;
  add_body(vehicle, figures);
  add_limits(vehicle, soil, figures);
  add_pull(vehicle, soil, figures);
  add_endurance(vehicle, soil, false, figures);
  add_endurance(vehicle, soil, true, figures);
  figures.add("battery_wh", nominal_energy_wh(vehicle.battery), "Battery",
              fmt::format("{:.1f} kWh, {:.0f} V, empty at {:.0f} %",
                          1e-3 * nominal_energy_wh(vehicle.battery),
                          nominal_voltage_v(vehicle.battery), 100.0 * vehicle.battery.empty_soc));
  figures.add("implement", vehicle.implement.name, "Implement", vehicle.implement.name);
  figures.add("soil", std::string(soil.name), "On soil", std::string(soil.name));
  return figures;
}

// The file's name is what tells programs its format.
void require_extension(const char* option, const std::filesystem::path& file,
                       const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), file.extension().string()) != known.end()) return;
  throw InputError(option, "", file.string(),
                   fmt::format("a file name that ends in {}", fmt::join(known, " or ")));
}

// Files that need not exist yet.
bool same_place(const std::filesystem::path& a, const std::filesystem::path& b) {
  const auto place = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
  };
  return place(a) == place(b);
}

int check(const CheckOptions& options) {
  if (!options.picture.empty()) require_extension("-o", options.picture, {".png"});
  if (!options.charts.empty()) require_extension("--charts", options.charts, {".svg", ".png"});
  if (!options.charts.empty() && !options.picture.empty() &&
      same_place(options.charts, options.picture)) {
    throw InputError("--charts", "", options.charts, "another file than the picture's");
  }
  const Soil& soil = soil_named(options.soil, "--soil", "");
  const PictureSize size = picture_size(options.common);
  const Vehicle vehicle = load_vehicle(options.vehicle);
  const Figures figures = figures_of(vehicle, soil);
  const std::vector<std::string> notes = vehicle_notes(vehicle);
  if (!options.picture.empty()) {
    std::vector<SheetFigure> shown;
    for (const Figure& figure : figures.lines) {
      if (!figure.label.empty()) shown.push_back({figure.label, figure.text});
    }
    const std::filesystem::path file = options.picture;
    write_together(file.has_parent_path() ? file.parent_path() : ".",
                   {{file.filename().string(), png_of(draw_vehicle_sheet(vehicle, shown, size))}});
  }
  if (!options.charts.empty()) {
    const std::filesystem::path file = options.charts;
    const ChartFormat format = file.extension() == ".png" ? ChartFormat::kPng : ChartFormat::kSvg;
    write_together(
        file.has_parent_path() ? file.parent_path() : ".",
        {{file.filename().string(), chart_of(vehicle_charts_script(vehicle, soil), format,
                                             kVehicleChartsWidth_px, kVehicleChartsHeight_px)}});
  }
  if (options.common.json) {
    Json json{{"name", vehicle.name}, {"description", vehicle.description}};
    for (const Figure& figure : figures.lines) json[figure.key] = figure.value;
    json["notes"] = notes;
    if (!options.picture.empty()) json["picture"] = options.picture;
    if (!options.charts.empty()) json["charts"] = options.charts;
    fmt::print("{}\n", json_text(json, 2));
    return kExitRan;
  }
  fmt::print("{}: {}\n", terminal_text(vehicle.name), terminal_text(vehicle.description));
  for (const Figure& figure : figures.lines) {
    if (!figure.label.empty()) fmt::print("  {:<26}{}\n", figure.label, terminal_text(figure.text));
  }
  for (const std::string& note : notes) fmt::print("note: {}\n", terminal_text(note));
  if (!options.picture.empty()) fmt::print("picture: {}\n", terminal_text(options.picture));
  if (!options.charts.empty()) fmt::print("charts: {}\n", terminal_text(options.charts));
  return kExitRan;
}

}  // namespace

void add_vehicle_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("vehicle", "Look into vehicles");
  command->require_subcommand(1);
  command->footer("Example:\n  headland vehicle check transplanter");
  auto* one = command->add_subcommand("check", "Load a vehicle, tell its figures and draw it");
  auto options = std::make_shared<CheckOptions>();
  one->add_option("VEHICLE", options->vehicle,
                  "Name of a built-in vehicle, or a folder with vehicle.urdf and drive.yaml")
      ->required();
  one->add_option("--soil", options->soil, "Soil for gradeability and range (headland list soils)")
      ->capture_default_str();
  one->add_option("-o,--output", options->picture, "Draw it into this PNG file");
  one->add_option("--charts", options->charts,
                  "Chart traction, motor, battery and climbing into this SVG or PNG file");
  add_size_option(*one, options->common);
  one->add_flag("--json", options->common.json, "Print the figures as JSON, in SI units");
  one->footer(
      "Examples:\n  headland vehicle check transplanter --soil tilled\n"
      "  headland vehicle check my_robot/ -o my_robot.png\n"
      "  headland vehicle check utility_tractor --soil tilled --charts charts.svg\n\n"
      "Loads and limits hold for level ground, implement raised, rigid tyres, no slip; range for\n"
      "steady driving on the flat at the work speed, implement raised and working.");
  one->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace headland

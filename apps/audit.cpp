// headland audit: tells what is wrong with a path before anything drives it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/audit.h"
#include "evaluate/audit_file.h"
#include "render/image.h"
#include "render/pictures.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

constexpr double kLeastWidth_m = 0.05;
constexpr double kLargestWidth_m = 100.0;
constexpr double kLeastCell_m = 0.02;
constexpr double kCellsPerWidth = 0.5;  // larger cells hide what the implement misses
constexpr char kAuditFile[] = "audit.json";
constexpr char kAuditPicture[] = "audit.png";

struct AuditOptions {
  CommonOptions common;  // of it the scenario, the folder, the size, json and quiet
  std::string field;
  std::string field_crs;
  std::string field_part;
  std::string path;
  std::string vehicle;
  std::optional<double> width_m;
  std::optional<double> cell_m;
};

struct AuditInput {
  Field field;
  std::vector<std::string> notes;
  Vehicle vehicle;
  double cell_m = 0.25;
};

AuditInput input_of(const AuditOptions& options) {
  AuditInput input;
  const std::string& scenario_file = options.common.scenario;
  if (scenario_file.empty() == options.field.empty()) {
    throw InputError("--field", "", options.field,
                     "give either a scenario or a field with --field FILE and --vehicle NAME");
  }
  if (!scenario_file.empty() && !options.field_crs.empty()) {
    throw InputError("--crs", "", options.field_crs, "goes with --field; a scenario has field.crs");
  }
  if (!scenario_file.empty() && !options.field_part.empty()) {
    throw InputError("--part", "", options.field_part,
                     "goes with --field; a scenario has field.part");
  }
  if (!scenario_file.empty()) {
    const Scenario scenario = read_scenario(scenario_file);
    input.field = read_field(scenario.field, scenario_file, &input.notes);
    input.field.name = scenario.name;
    input.vehicle = load_vehicle(options.vehicle.empty() ? scenario.vehicle : options.vehicle);
    if (options.vehicle.empty()) {
      input.vehicle.implement.working_width_m = scenario.working_width_m;
    }
    input.cell_m = scenario.coverage_cell_m;
  } else {
    if (options.vehicle.empty()) {
      throw InputError("--vehicle", "", "", "needed along with --field (headland list vehicles)");
    }
    FieldSource source;
    source.file = options.field;
    source.crs = options.field_crs;
    source.part = options.field_part;
    input.field = read_field(source, options.field, &input.notes);
    input.vehicle = load_vehicle(options.vehicle);
  }
  if (options.width_m) {
    if (!(*options.width_m >= kLeastWidth_m && *options.width_m <= kLargestWidth_m)) {
      throw InputError("--width", "", fmt::format("{}", *options.width_m),
                       fmt::format("from {} to {} m", kLeastWidth_m, kLargestWidth_m));
    }
    input.vehicle.implement.working_width_m = *options.width_m;
  }
  const double width_m = input.vehicle.implement.working_width_m;
  input.cell_m = options.cell_m.value_or(std::min(input.cell_m, kCellsPerWidth * width_m));
  if (!(input.cell_m >= kLeastCell_m && input.cell_m <= kCellsPerWidth * width_m)) {
    throw InputError("--cell", "", fmt::format("{}", input.cell_m),
                     fmt::format("from {} m to half the working width, {:g} m", kLeastCell_m,
                                 kCellsPerWidth * width_m));
  }
  return input;
}

Image picture_of(const AuditInput& input, const Audit& audit, const std::vector<PathLine>& lines,
                 const AuditOptions& options) {
  // The picture is of the plan alone: level ground stands in for the terrain.
  const Heightfield level = read_terrain({}, input.field, "audit");
  const Path path = drawn_path(lines);
  const RunRecord not_driven;
  const Verdict verdict = audit_verdict(audit);
  PictureScene scene{
      input.field, level,        input.vehicle, path,
      not_driven,  audit.raster, &verdict,      fs::path(options.path).filename().string()};
  scene.terrain_known = false;
  return draw_field_map(scene, picture_size(options.common));
}

std::string summary_of(const Audit& audit, const AuditInput& input) {
  const CoverageFigures& coverage = audit.coverage;
  const auto share = [&](double area_m2) { return 100.0 * area_m2 / coverage.workable_m2; };
  std::string text = fmt::format(
      "{}: {:.2f} km with {}, {:.2f} km at work, {:.0f} m in reverse, {}\n",
      terminal_text(input.field.name), 1e-3 * audit.length_m, input.vehicle.name,
      1e-3 * audit.working_length_m, audit.reverse_length_m,
      counted(static_cast<std::size_t>(audit.gear_changes), "gear change", "gear changes"));
  for (const AuditFault fault : kEveryAuditFault) {
    const AuditTotals& totals = audit.totals[static_cast<std::size_t>(fault)];
    text += fmt::format("  {:<12} {:>5} {}", audit_fault_name(fault), totals.places,
                        totals.places == 1 ? "place" : "places");
    if (totals.places > 0) {
      text += fmt::format(", {:.1f} m, {} of {} states, worst {:.2f} m", totals.length_m,
                          totals.states, audit.states, totals.worst);
    }
    text += "\n";
  }
  text += fmt::format(
      "  covered {:.2f} % of {:.3f} ha, overlap {:.2f} %, outside {:.2f} %; {} missed\n",
      share(coverage.covered_m2), 1e-4 * coverage.workable_m2, share(coverage.overlap_m2),
      share(coverage.outside_m2), counted(audit.missed.size(), "patch", "patches"));
  const DrivenOverWorked& over = audit.over_worked;
  text += fmt::format("  {:.1f} m over worked ground, implement up", over.length_m);
  if (over.stretches > 0) {
    text += fmt::format(", in {}, the longest from x {:.1f} m, y {:.1f} m",
                        counted(static_cast<std::size_t>(over.stretches), "place", "places"),
                        over.p_W.x(), over.p_W.y());
  }
  text += "\n";
  const Verdict verdict = audit_verdict(audit);
  text += fmt::format("{}\n", passes(audit) ? "PASS: nothing is in the way of driving it" : "FAIL");
  for (const std::string& note : input.notes) text += "note: " + terminal_text(note) + "\n";
  int number = 0;
  for (const Reason& reason : verdict.reasons) {
    text += fmt::format("  {}. {} at x {:.1f} m, y {:.1f} m\n", ++number, reason.text,
                        reason.p_W->x(), reason.p_W->y());
  }
  return text;
}

int run_audit(const AuditOptions& options) {
  const fs::path folder = options.common.folder;
  if (!folder.empty()) check_output_folder(folder);
  static_cast<void>(picture_size(options.common));
  const InterruptAtOnce at_once;
  AuditInput input = input_of(options);
  check_coverage_size(input.field, input.vehicle.implement.working_width_m, input.cell_m, "--cell");
  const std::vector<PathLine> lines = read_path_lines(options.path, input.field, &input.notes);
  const Audit audit = audit_path(input.field, input.vehicle, lines, input.cell_m, options.path);
  const nlohmann::ordered_json json =
      audit_json(audit, input.field, input.vehicle, fs::path(options.path).filename().string(),
                 HEADLAND_VERSION);
  if (!folder.empty()) {
    write_together(folder, {{kAuditFile, json_text(json, 2) + "\n"},
                            {kAuditPicture, png_of(picture_of(input, audit, lines, options))}});
  }
  if (options.common.json) {
    fmt::print("{}\n", json_text(json, 2));
  } else if (!options.common.quiet) {
    fmt::print("{}", summary_of(audit, input));
    if (!folder.empty()) {
      fmt::print("every place is in {0}/{1}, drawn in {0}/{2}\n", terminal_text(folder.string()),
                 kAuditFile, kAuditPicture);
    }
  }
  return passes(audit) ? kExitRan : kExitVerdictFail;
}

}  // namespace

void add_audit_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("audit", "Tell what is wrong with any tool's path before it is driven");
  auto options = std::make_shared<AuditOptions>();
  command->add_option("SCENARIO", options->common.scenario,
                      "Scenario with field and vehicle; or give --field and --vehicle");
  command->add_option("--field", options->field, "Field: a vector file that GDAL reads");
  command->add_option("--crs", options->field_crs, "CRS of the field file (default: its own)");
  command->add_option("--part", options->field_part,
                      "Which of the field file's polygons: its name or number (default: the only)");
  command
      ->add_option("--path", options->path,
                   "Path of any tool: lines (GeoJSON, GPKG, GPX, ISOXML...) or CSV; docs/paths.md")
      ->required();
  command->add_option("--vehicle", options->vehicle, "Name of a built-in vehicle, or its folder");
  command->add_option("--width", options->width_m,
                      "Working width in metres (default: of the vehicle's implement)");
  command->add_option("--cell", options->cell_m,
                      "Cell of the coverage raster in metres (default: the scenario's, or 0.25)");
  command->add_option("-o,--output", options->common.folder,
                      "Folder for audit.json and audit.png (default: none)");
  add_size_option(*command, options->common);
  command->add_flag("--json", options->common.json, "Print audit.json, and nothing else");
  command->add_flag("--quiet,-q", options->common.quiet, "No summary");
  command->footer(
      "Examples:\n"
      "  headland audit examples/demo.yaml --path out/demo/path.geojson -o out/audit\n"
      "  headland audit --field field.geojson --vehicle utility_tractor --path other_tool.csv\n\n"
      "Exits with 0 when nothing is in the way of driving the path, 1 when something is, 2 for\n"
      "bad input.");
  command->callback([options, &exit_code] { exit_code = run_audit(*options); });
}

}  // namespace headland

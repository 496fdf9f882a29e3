// headland export: writes a path for machines, terminals and other programs.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/path_export.h"
#include "evaluate/plan_file.h"
#include "evaluate/results.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string plan;
  std::string scenario;
  std::string format;
  std::string output;
  std::string origin;
  bool quiet = false;
};

// By the name of the format, or by the ending of the file that is written.
ExportFormat format_of(const ExportOptions& options) {
  std::string ending = fs::path(options.output).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  std::string known;
  for (const ExportFormat format : kEveryExportFormat) {
    const std::string name(export_format_name(format));
    const std::string own_ending = format == ExportFormat::kIsoxml ? ".xml" : "." + name;
    if (options.format.empty() ? ending == own_ending : options.format == name) return format;
    known += (known.empty() ? "" : ", ") + name;
  }
  if (options.format.empty()) {
    throw InputError("-o", "", options.output,
                     "the ending does not tell the format; give --format, one of " + known);
  }
  throw InputError("--format", "", options.format, "one of " + known);
}

GeoFrame origin_of(const std::string& text) {
  constexpr double kEast_deg = 180.0;
  constexpr double kNorth_deg = 85.0;  // the frame's projection is of no use nearer to the poles
  GeoFrame frame{true, 0.0, 0.0};
  const char* end = text.data() + text.size();
  const auto longitude = std::from_chars(text.data(), end, frame.longitude_deg);
  bool read = longitude.ec == std::errc() && longitude.ptr != end && *longitude.ptr == ',';
  if (read) {
    const auto latitude = std::from_chars(longitude.ptr + 1, end, frame.latitude_deg);
    read = latitude.ec == std::errc() && latitude.ptr == end;
  }
  if (read && std::abs(frame.longitude_deg) <= kEast_deg &&
      std::abs(frame.latitude_deg) <= kNorth_deg) {
    return frame;
  }
  throw InputError("--origin", "", text,
                   "LON,LAT in degrees: from -180 to 180, from -85 to 85, for example 9.05,52.1");
}

int run_export(const ExportOptions& options) {
  const ExportFormat format = format_of(options);
  const fs::path plan = options.plan;
  const bool folder = fs::is_directory(plan);
  const fs::path path_file = folder ? plan / kPathFile : plan;
  fs::path scenario_file = options.scenario;
  if (scenario_file.empty()) scenario_file = path_file.parent_path() / kScenarioFile;
  if (!fs::exists(path_file)) {
    throw InputError(path_file.string(), "", "", "no such file: 'headland plan' writes it");
  }
  if (!fs::exists(scenario_file)) {
    throw InputError(scenario_file.string(), "", "",
                     "no such file: the path's field and vehicle are needed; give their scenario "
                     "with --scenario");
  }
  const fs::path output = options.output;
  const fs::path output_folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  check_output_folder(output_folder);
  const InterruptAtOnce at_once;
  const Scenario scenario = read_scenario(scenario_file);
  Field field = read_field(scenario.field, scenario_file.string());
  field.name = scenario.name;
  if (!is_path_file(path_file)) {
    throw InputError(path_file.string(), "", "",
                     "is not a path that headland wrote; 'headland drive --path' makes one of it");
  }
  const Path path = read_path(path_file, field);
  if (!options.origin.empty()) {
    if (field.frame.georeferenced) {
      throw InputError("--origin", "", options.origin,
                       "is for fields without a place on the earth; this one has its own");
    }
    field.frame = origin_of(options.origin);
  }
  const Vehicle vehicle = vehicle_of(scenario, scenario_file.string());
  write_together(output_folder, {{output.filename().string(),
                                  export_text({path, field, vehicle, HEADLAND_VERSION}, format)}});
  if (!options.quiet) {
    fmt::print("{}: {:.0f} m of path as {}\n", terminal_text(output.string()), length_m(path),
               export_format_name(format));
  }
  return kExitRan;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("export", "Write a path for machines: GeoJSON, KML, GPX, CSV, ISOXML");
  auto options = std::make_shared<ExportOptions>();
  command
      ->add_option("DIR_OR_PATH", options->plan,
                   "Folder that 'headland plan', 'drive' or 'job' wrote, or a path in a file")
      ->required();
  command->add_option("-o,--output", options->output, "File to write")->required();
  command->add_option("--format", options->format,
                      "geojson, kml, gpx, csv or isoxml (default: by the ending of the file; .xml "
                      "is ISOXML)");
  command->add_option("--scenario", options->scenario,
                      "Scenario with field and vehicle (default: scenario.yaml beside the path)");
  command->add_option("--origin", options->origin,
                      "LON,LAT of x 0, y 0 of a field that has no place on the earth");
  command->add_flag("--quiet,-q", options->quiet, "No summary");
  command->footer(
      "Examples:\n"
      "  headland export out/real -o out/TASKDATA/TASKDATA.XML\n"
      "  headland export out/demo --format kml --origin 9.05,52.1 -o demo.kml\n\n"
      "What each format holds and how it is read back: docs/export.md.\n"
      "Exits with 0, 2 for bad input.");
  command->callback([options, &exit_code] { exit_code = run_export(*options); });
}

}  // namespace headland

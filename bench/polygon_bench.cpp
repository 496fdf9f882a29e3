// Planning of irregular fields: how long it takes, and whether the paths stay inside and cover what
// can be reached.
// Usage: polygon_bench suite [--fields N] [--first N] [--least-ha HA] [--most-ha HA]
//        [--vehicle NAME] [--set KEY=VALUE] [--rows FILE] [--again] [--json]
//        polygon_bench drive [--fields N] [--most-ha HA] [--vehicle NAME] [--set KEY=VALUE]
//        [--json]
//        polygon_bench times [--swaths N] [--field FILE] [--set KEY=VALUE] [--json]
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/field_drives.h"
#include "bench/field_suite_run.h"
#include "bench/planning_times.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

Parameters parameters_of(const std::vector<std::string>& set) {
  Parameters parameters;
  for (const std::string& text : set) {
    const std::size_t at = text.find('=');
    const std::string value = at == std::string::npos ? "" : text.substr(at + 1);
    const auto number = parse_number(value);
    parameters[text.substr(0, at)] = number ? ParameterValue(*number) : ParameterValue(value);
  }
  return parameters;
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  headland::bench::SuiteAsked asked;
  CLI::App app("Planning of irregular fields");
  app.require_subcommand(1);
  auto* suite = app.add_subcommand("suite", "Made-up fields, planned and audited");
  suite->add_option("--fields", asked.fields, "How many");
  suite->add_option("--first", asked.first, "Leave out so many before");
  suite->add_option("--least-ha", asked.least_ha, "Leave out smaller ones");
  suite->add_option("--most-ha", asked.most_ha, "Leave out larger ones");
  suite->add_option("--jobs", asked.jobs, "Threads");
  suite->add_option("--vehicle", asked.vehicles, "Vehicles");
  suite->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner");
  suite->add_option("--rows", asked.rows_file,
                    "Keep rows in this file, make those only that it lacks");
  suite->add_flag("--again", asked.again, "Make refused, faulty and less covered ones of it again");
  suite->add_flag("--json", asked.json, "Print JSON");
  auto* drive = app.add_subcommand("drive", "Made-up fields, planned and driven in physics");
  headland::bench::DrivesAsked drives;
  drive->add_option("--fields", drives.fields, "How many");
  drive->add_option("--most-ha", drives.most_ha, "Leave out larger ones");
  drive->add_option("--clearance", drives.clearance_m, "Kept by the hull [m]");
  drive->add_option("--jobs", drives.jobs, "Threads");
  drive->add_option("--vehicle", drives.vehicles, "Vehicles");
  drive->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner");
  drive->add_flag("--json", asked.json, "Print JSON");
  auto* times = app.add_subcommand("times", "Time and memory over the number of swaths");
  headland::bench::TimesAsked sizes;
  times->add_option("--swaths", sizes.swaths, "How many");
  times->add_option("--field", sizes.files, "Files with fields to be planned too");
  times->add_option("--set", asked.set, "KEY=VALUE: a parameter of the planner for them");
  times->add_flag("--json", asked.json, "Print JSON");
  CLI11_PARSE(app, argc, argv);
  try {
    if (times->parsed()) {
      sizes.parameters = headland::bench::parameters_of(asked.set);
      sizes.json = asked.json;
      headland::bench::print_planning_times(sizes);
      return EXIT_SUCCESS;
    }
    if (drive->parsed()) {
      drives.parameters = headland::bench::parameters_of(asked.set);
      drives.json = asked.json;
      headland::bench::print_drives(drives);
      return EXIT_SUCCESS;
    }
    asked.parameters = headland::bench::parameters_of(asked.set);
    headland::bench::print_suite(asked);
    return EXIT_SUCCESS;
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "polygon_bench: %s\n", error.what());
    return 2;
  }
}

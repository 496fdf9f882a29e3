#include "apps/summary_rows.h"

#include <fmt/format.h>

#include "apps/terminal_text.h"

namespace headland {
namespace {

constexpr double kSquareMetresPerHa = 1e4;

}  // namespace

std::string hectares(double area_m2) {
  return fmt::format("{:.3f} ha", area_m2 / kSquareMetresPerHa);
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string summary_row(std::string_view label, const std::string& value, const std::string& note) {
  const std::string line = fmt::format("  {:<26}{:>12}   {}", label, value, note);
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string headline(const Job& job) {
  const Scenario& scenario = job.scenario;
  const std::string driven =
      scenario.path_file.empty()
          ? ""
          : fmt::format("path {}, ", terminal_text(scenario.path_file.filename().string()));
  return fmt::format(
      "{}: {} with {:.4g} m on {}, soil {}, terrain {}, {}seed {}\n", terminal_text(scenario.name),
      terminal_text(job.stage.vehicle.name), scenario.working_width_m,
      hectares(field_area_m2(job.stage.field)), terminal_text(soil_text(scenario.soil)),
      scenario.terrain.file.empty() ? scenario.terrain.generator
                                    : terminal_text(scenario.terrain.file.filename().string()),
      driven, scenario.seed);
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "note: " + terminal_text(note) + "\n";
  return text;
}

}  // namespace headland

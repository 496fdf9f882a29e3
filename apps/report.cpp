// headland report: one page on what a run, a comparison or a tuning left in its folder.
#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/compare_pictures.h"
#include "apps/interrupt.h"
#include "apps/report_stage.h"
#include "apps/set_reports.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/results.h"
#include "evaluate/tuning_file.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct ReportCommand {
  std::string folder;
  std::string file;  // to write; empty: report.html in the folder
  bool json = false;
  bool quiet = false;
};

void require_folder(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string(), "", "",
                     fs::exists(folder) ? "no folder: one that 'headland evaluate', 'compare' or "
                                          "'tune' wrote is needed"
                                        : "no such folder");
  }
}

// Results may lie where nothing may be written.
void require_place(const fs::path& folder, bool is_default) {
  try {
    check_output_folder(folder);
  } catch (const InputError& refused) {
    if (!is_default) throw;
    throw InputError(refused.source, refused.where, refused.value,
                     refused.allowed + "; -o FILE writes the page elsewhere");
  }
}

ReportPage page_of_folder(const fs::path& folder) {
  if (fs::exists(folder / kComparisonFile)) return comparison_report(folder);
  if (fs::exists(folder / kTuningFile)) return tuning_report(folder);
  if (!fs::exists(folder / kScenarioFile)) {
    throw InputError(folder.string(), "", "",
                     fmt::format("neither {} of a run nor {} of a comparison nor {} of a tuning is "
                                 "there",
                                 kScenarioFile, kComparisonFile, kTuningFile));
  }
  require_file(folder / kScenarioFile);
  const Scenario scenario = read_scenario(folder / kScenarioFile);
  return run_report({scenario, load_stage(scenario), folder});
}

int report(const ReportCommand& command) {
  const fs::path folder = command.folder;
  const fs::path file = command.file.empty() ? folder / kReportFile : fs::path(command.file);
  require_folder(folder);
  const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
  require_place(parent, command.file.empty());
  ReportPage page;
  {
    const InterruptAtOnce at_once;
    page = page_of_folder(folder);
  }
  write_together(parent, {{file.filename().string(), page.html}});
  tell_missing(page.missing);
  if (command.json) {
    fmt::print("{}\n", json_text({{"report", file.string()}}, 2));
  } else if (!command.quiet) {
    fmt::print("{}\n", terminal_text(file.string()));
  }
  return kExitRan;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("report", "Write a page on a run, a comparison or a tuning");
  auto given = std::make_shared<ReportCommand>();
  command
      ->add_option("DIR", given->folder,
                   "Folder that 'evaluate', 'drive', 'compare' or 'tune' wrote")
      ->required();
  command->add_option("-o,--output", given->file, "File to write [DIR/report.html]");
  command->add_flag("--json", given->json, "Print the file's name as JSON");
  command->add_flag("--quiet,-q", given->quiet, "Print nothing");
  command->footer(
      "Example:\n  headland report out/demo\n\n"
      "Writes one HTML file that holds everything it shows: open it in any browser, offline too.\n"
      "What is missing in the folder is left out and told, on the page too.");
  command->callback([given, &exit_code] { exit_code = report(*given); });
}

}  // namespace headland

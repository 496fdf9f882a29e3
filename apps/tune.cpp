// headland tune: weights fitted to driven energy, and what plans made by them save.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "apps/set_reports.h"
#include "apps/terminal_text.h"
#include "apps/tune_pictures.h"
#include "apps/tune_summary.h"
#include "evaluate/atomic_file.h"
#include "evaluate/measure.h"
#include "evaluate/results.h"
#include "evaluate/tuning_file.h"
#include "render/gnuplot.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr int kMostTuneJobs = 1024;
constexpr char kCostsFile[] = "costs.yaml";

struct TuneCommand {
  std::string spec;
  std::string folder;
  std::string store;
  int jobs = 1;
  bool json = false;
  bool quiet = false;
};

// Of the tuning's vehicle on the first soil of its training set: the same file every time.
void measure_for(const TuneCommand& command, Tuning& tuning) {
  const SoilSource& soil = tuning.training.soils.front().source;
  if (!soil.file.empty()) {
    throw InputError(command.spec, "costs", "", "missing: on a map of soils nothing is measured");
  }
  MeasureOptions options = planning_measurements(command.jobs);
  ProgressLine line = start_progress(command.quiet);
  options.progress = [&line](double done) {
    show_share(line, "measuring", done);
    return !interrupted();
  };
  const CostTable table = measure_costs(vehicle_of(tuning.training.scenarios.front(), command.spec),
                                        soil.soil, options);
  end_progress(line);
  stop_if_interrupted();
  write_together(command.folder, {{kCostsFile, cost_table_yaml(table)}});
  tuning.costs = std::filesystem::absolute(command.folder) / kCostsFile;
}

void open_store(const TuneCommand& command, RunStore& store) {
  std::filesystem::create_directories(command.folder);
  const std::filesystem::path file = command.store.empty()
                                         ? std::filesystem::path(command.folder) / "runs.db"
                                         : std::filesystem::path(command.store);
  open_run_store(file, DatabaseMode::kWrite, store);
}

TuneResult tuned(const TuneCommand& command, const Tuning& tuning, RunStore& store) {
  ProgressLine line = start_progress(command.quiet);
  TuneOptions options;
  options.jobs = command.jobs;
  options.cancelled = interrupted;
  options.progress = [&](std::string_view what, int done, int all) {
    show_count(line, what, done, all);
  };
  try {
    TuneResult result = run_tuning(tuning, store, options);
    end_progress(line);
    return result;
  } catch (const Cancelled&) {
    end_progress(line);
    throw Interrupted{};
  } catch (...) {
    end_progress(line);
    throw;
  }
}

int tune(const TuneCommand& command) {
  if (command.jobs < 1 || command.jobs > kMostTuneJobs) {
    throw InputError("--jobs", "", fmt::format("{}", command.jobs),
                     fmt::format("a whole number from 1 to {}", kMostTuneJobs));
  }
  check_output_folder(command.folder);
  const std::filesystem::path folder = command.folder;
  for (const char* name : {kTuningFile, kWeightsFile, kCostsFile, kReportFile}) {
    require_replaceable(folder / name);
  }
  Tuning tuning = read_tuning(command.spec);
  const std::string spec = read_text(command.spec);
  require_gnuplot();
  RunStore store;
  open_store(command, store);
  if (tuning.costs.empty()) measure_for(command, tuning);
  const TuneResult result = tuned(command, tuning, store);
  nlohmann::ordered_json json = tuning_json(tuning, result, HEADLAND_VERSION);
  json["spec"] = {{"file", tuning.file.filename().string()}, {"text", spec}};
  std::vector<FileText> files = {{kTuningFile, json_text(json, 1) + "\n"}};
  const std::string weights = tuned_weights_yaml(tuning, result);
  if (!weights.empty()) files.push_back({kWeightsFile, weights});
  // The figures first: pictures that cannot be drawn cost nobody a run.
  write_together(folder, files);
  std::filesystem::remove(folder / kReportFile);
  std::vector<FileText> pictures = tune_pictures(tuning, result);
  for (const FileText& picture : pictures) json["pictures"].push_back(picture.name);
  pictures.push_back({kTuningFile, json_text(json, 1) + "\n"});
  write_together(folder, pictures);
  write_together(folder, {{kReportFile, tuning_report(folder).html}});
  if (command.json) {
    fmt::print("{}\n", json_text(json, 1));
  } else if (!command.quiet) {
    fmt::print("{}\n{}figures, pictures and {} are in {}\n", tune_summary(tuning, result),
               weights.empty() ? "" : fmt::format("{}: {}; ", kWeightsFile, result.best_label),
               kReportFile, terminal_text(command.folder));
  }
  stop_if_interrupted();
  return kExitRan;
}

}  // namespace

void add_tune_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("tune", "Fit weights to driven energy, prove what they save");
  auto given = std::make_shared<TuneCommand>();
  given->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("SPEC", given->spec, "Training and held-out fields, vehicle, planner (YAML)")
      ->required();
  command->add_option("-o,--output", given->folder, "Folder for the results")->required();
  command->add_option(
      "--store", given->store,
      "SQLite file with the runs (default: runs.db in the folder); what it holds is "
      "not driven again");
  command->add_option("--jobs", given->jobs, "Runs at the same time")->capture_default_str();
  command->add_flag("--json", given->json, "Print tune.json, and nothing else");
  command->add_flag("--quiet,-q", given->quiet, "No progress and no summary");
  command->footer(
      "Example:\n  headland tune examples/tune.yaml -o out/tune\n"
      "  headland plan examples/field_b.yaml --weights out/tune/weights.yaml -o out/plan\n\n"
      "Writes weights.yaml, tune.json, prediction.svg, savings.svg, pictures of plans,\n"
      "and report.html that shows them.\n"
      "Ended early, by whatever, it goes on where it was when called again.\n"
      "Exits with 0, 2 for bad input, 130 after Ctrl-C (finished runs are kept).");
  command->callback([given, &exit_code] { exit_code = tune(*given); });
}

}  // namespace headland

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "apps/terminal_text.h"
#include "evaluate/coverage.h"
#include "evaluate/results.h"
#include "evaluate/tuned_weights.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {

namespace {

constexpr int kMostPixels = 8192;

}  // namespace

std::string whole_number_fault(const std::string& given) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  if (error == std::errc() && end == given.data() + given.size()) return "";
  return "'" + given + "': a whole number from 0 to 18446744073709551615 is needed";
}

void add_scenario_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--seed", options.seed, "Seed of every random draw, instead of the scenario's")
      ->check(whole_number_fault);
  command.add_flag("--allow-overrun", options.allow_overrun,
                   "Record where the path does not fit the field instead of refusing");
  command.add_flag("--json", options.json, "Print the summary as JSON, and nothing else");
  command.add_flag("--quiet,-q", options.quiet, "No progress and no summary");
}

void add_cost_option(CLI::App& command, std::string& file) {
  command.add_option("--cost", file,
                     "Plan by measured costs (costs.yaml of 'headland measure'; docs/costs.md)");
}

void add_weights_option(CLI::App& command, std::string& file) {
  command.add_option("--weights", file,
                     "Plan by these weights (weights.yaml of 'headland tune'; docs/tune.md)");
}

void add_record_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--record-hz", options.record_hz, "Rows a second of run.csv");
}

void add_size_option(CLI::App& command, CommonOptions& options) {
  command.add_option(
      "--size", options.size,
      fmt::format("Pixels of the pictures, from {}x{} to {}x{} (default: 1600x1000)",
                  kLeastPicture.width, kLeastPicture.height, kMostPixels, kMostPixels));
}

Job make_job(const std::filesystem::path& file, const std::filesystem::path& folder,
             const CommonOptions& options) {
  check_results_folder(folder);
  const InterruptAtOnce at_once;
  Job job;
  job.folder = folder;
  job.scenario = read_scenario(file, options.seed);
  if (options.allow_overrun) job.scenario.path.allow_overrun = true;
  if (options.record_hz) {
    const double rate_hz = job.scenario.simulation.rate_hz;
    if (!(*options.record_hz > 0.0 && *options.record_hz <= rate_hz)) {
      throw InputError("--record-hz", "", fmt::format("{}", *options.record_hz),
                       fmt::format("more than 0 and at most {}, the simulation's rate", rate_hz));
    }
    job.scenario.simulation.record_hz = *options.record_hz;
  }
  if (!options.cost.empty()) {
    const std::filesystem::path costs = std::filesystem::absolute(options.cost).lexically_normal();
    require_file(costs);
    plan_by_costs(costs, job.scenario.planner);
  }
  if (!options.weights.empty()) {
    if (!options.cost.empty()) {
      throw InputError("--weights", "", options.weights, "not with --cost: one or the other");
    }
    require_file(options.weights);
    plan_by_weights(options.weights, job.scenario.planner);
  }
  job.stage = load_stage(job.scenario);
  check_coverage_size(job.stage.field, job.scenario.working_width_m, job.scenario.coverage_cell_m,
                      file.string());
  return job;
}

PictureSize picture_size(const CommonOptions& options, const PictureSize& least) {
  PictureSize size;
  if (options.size.empty()) return size;
  int read = 0;
  const bool parsed =
      std::sscanf(options.size.c_str(), "%5dx%5d%n", &size.width, &size.height, &read) == 2 &&
      static_cast<std::size_t>(read) == options.size.size();
  const auto fits = [](int pixels, int lowest) {
    return pixels >= lowest && pixels <= kMostPixels;
  };
  if (!parsed || !fits(size.width, least.width) || !fits(size.height, least.height)) {
    throw InputError("--size", "", options.size,
                     fmt::format("WIDTHxHEIGHT from {}x{} to {}x{} pixels", least.width,
                                 least.height, kMostPixels, kMostPixels));
  }
  return size;
}

double time_from(const std::string& option, const std::string& text) {
  double total_s = 0.0;
  std::size_t at = 0;
  for (int parts = 1;; ++parts) {
    const std::size_t colon = std::min(text.find(':', at), text.size());
    const std::string part = text.substr(at, colon - at);
    std::size_t read = 0;
    double value = -1.0;
    const bool plain = !part.empty() && part.find_first_not_of("0123456789.") == std::string::npos;
    try {
      if (plain) value = std::stod(part, &read);
    } catch (const std::exception&) {
      value = -1.0;
    }
    const bool whole = parts == 1 && colon == text.size();
    if (read != part.size() || !(value >= 0.0) || parts > 3 ||
        (!whole && at > 0 && value >= 60.0)) {
      throw InputError(option, "", text, "seconds, as 90 or 90.5, or 1:30 or 1:02:30");
    }
    total_s = 60.0 * total_s + value;
    if (colon == text.size()) return total_s;
    at = colon + 1;
  }
}

PlanResult plan_with_progress(const Job& job, bool quiet) {
  PlanningLine line(quiet);
  return plan_stage(job, line.shown());
}

std::optional<TrackReport> given_path_with_progress(const Job& job, bool quiet) {
  PlanningLine line(quiet);
  return given_path_stage(job, line.shown());
}

DriveResult drive_with_progress(const Job& job, const CommonOptions& options) {
  ProgressLine line = start_progress(options.quiet);
  const auto on_progress = [&line](const SimulationProgress& progress) {
    show_progress(line, progress);
    return !interrupted();
  };
  try {
    DriveResult result = drive_stage(job, on_progress);
    end_progress(line);
    for (const std::string& note : result.notes) {
      fmt::print(stderr, "headland: {}\n", terminal_text(note));
    }
    return result;
  } catch (...) {
    end_progress(line);
    throw;
  }
}

int exit_code_of(const Verdict& verdict) {
  return verdict.grade == Grade::kFail ? kExitVerdictFail : kExitRan;
}

}  // namespace headland

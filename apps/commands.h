// The subcommands of `headland`: each adds itself to the command line, runs when it is called and
// leaves its exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "apps/stages.h"
#include "render/pictures.h"

namespace headland {

enum ExitCode : int {
  kExitRan = 0,          // done; of a verdict: PASS or WARN
  kExitVerdictFail = 1,  // done, and the verdict is FAIL
  kExitBadInput = 2,     // one line on standard error says what is wrong
  kExitInternal = 3,     // a fault of headland itself
  kExitInterrupted = 130,
};

void add_evaluate_command(CLI::App& app, int& exit_code);
void add_plan_command(CLI::App& app, int& exit_code);
void add_audit_command(CLI::App& app, int& exit_code);
void add_job_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_drive_command(CLI::App& app, int& exit_code);
void add_render_command(CLI::App& app, int& exit_code);
void add_report_command(CLI::App& app, int& exit_code);
void add_measure_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_sweep_command(CLI::App& app, int& exit_code);
void add_tune_command(CLI::App& app, int& exit_code);
void add_query_command(CLI::App& app, int& exit_code);
void add_merge_command(CLI::App& app, int& exit_code);
void add_list_command(CLI::App& app, int& exit_code);
void add_vehicle_command(CLI::App& app, int& exit_code);

// Options that several subcommands share.
struct CommonOptions {
  std::string scenario;
  std::string folder;
  std::optional<std::uint64_t> seed;
  std::optional<double> record_hz;
  std::string size;     // "WxH"; empty: the pictures' default
  std::string cost;     // file with measured costs; empty: the scenario's
  std::string weights;  // file with weights of a fitness; empty: the scenario's
  bool allow_overrun = false;
  bool json = false;
  bool quiet = false;
};

// Declares the shared options on `command`: the seed, --allow-overrun, --json, --quiet.
void add_scenario_options(CLI::App& command, CommonOptions& options);
// What is wrong with a text that is to be a whole number, as a check of CLI11's, which takes -1 for
// the largest number and cuts off what is too large; empty when nothing is.
std::string whole_number_fault(const std::string& given);

void add_cost_option(CLI::App& command, std::string& file);
void add_weights_option(CLI::App& command, std::string& file);
void add_record_option(CLI::App& command, CommonOptions& options);
void add_size_option(CLI::App& command, CommonOptions& options);

// The scenario of `file` with the options applied, and what it describes, loaded. Throws
// InputError, also when no results could be written to `folder`.
Job make_job(const std::filesystem::path& file, const std::filesystem::path& folder,
             const CommonOptions& options);

// Throws InputError unless it is within `least`..8192x8192.
inline constexpr PictureSize kLeastPicture{640, 400};  // the legend has no room on smaller ones
PictureSize picture_size(const CommonOptions& options, const PictureSize& least = kLeastPicture);

// "90", "90.5", "1:30" or "1:02:30", given to this option, as seconds. Throws InputError.
double time_from(const std::string& option, const std::string& text);

// plan_stage and given_path_stage (stages.h) with progress on the terminal.
PlanResult plan_with_progress(const Job& job, bool quiet);
std::optional<TrackReport> given_path_with_progress(const Job& job, bool quiet);

// Drives the job's path with progress on the terminal.
DriveResult drive_with_progress(const Job& job, const CommonOptions& options);

int exit_code_of(const Verdict& verdict);

}  // namespace headland

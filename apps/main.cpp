#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>

#include "apps/command_words.h"
#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/terminal_text.h"
#include "planner/plan.h"
#include "terrains/input_error.h"

namespace {

void complain(std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  fmt::print(stderr, "headland: {}\n", headland::terminal_text(line));
}

// An empty name would stand for the current folder, an empty number for none.
void refuse_empty_values(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    refuse_empty_values(*command);
    for (CLI::Option* option : command->get_options()) {
      if (option->get_type_size() == 0) continue;
      option->check([](const std::string& given) {
        return std::string(given.empty() ? "the value is empty" : "");
      });
    }
  }
}

int run(int argc, char** argv) {
  int exit_code = headland::kExitRan;
  CLI::App app("Drives coverage plans in physics before anyone drives them in a field.",
               "headland");
  app.set_version_flag("--version", "headland " HEADLAND_VERSION);
  app.require_subcommand(1);
  app.footer("Example:\n  headland evaluate examples/demo.yaml -o out/demo");
  headland::add_evaluate_command(app, exit_code);
  headland::add_plan_command(app, exit_code);
  headland::add_audit_command(app, exit_code);
  headland::add_job_command(app, exit_code);
  headland::add_export_command(app, exit_code);
  headland::add_drive_command(app, exit_code);
  headland::add_render_command(app, exit_code);
  headland::add_report_command(app, exit_code);
  headland::add_measure_command(app, exit_code);
  headland::add_compare_command(app, exit_code);
  headland::add_sweep_command(app, exit_code);
  headland::add_tune_command(app, exit_code);
  headland::add_query_command(app, exit_code);
  headland::add_merge_command(app, exit_code);
  headland::add_list_command(app, exit_code);
  headland::add_vehicle_command(app, exit_code);
  refuse_empty_values(app);
  headland::check_words(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    complain(fmt::format("{} (see '{}')", error.what(), headland::help_command(app, argc, argv)));
    return headland::kExitBadInput;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  headland::catch_interrupts();
  try {
    const int exit_code = run(argc, argv);
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category());
    return exit_code;
  } catch (const headland::InputError& error) {
    complain(error.what());
    return headland::kExitBadInput;
  } catch (const headland::PlanInfeasible& error) {
    complain(error.what());
    return headland::kExitBadInput;
  } catch (const std::filesystem::filesystem_error& error) {
    complain(fmt::format("{}: {}", error.path1().string(), error.code().message()));
    return headland::kExitBadInput;
  } catch (const headland::Interrupted&) {
    complain(headland::kInterruptedText);
    return headland::kExitInterrupted;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) {
      complain("standard output: cannot be written: " + error.code().message());
      return headland::kExitBadInput;
    }
    complain(std::string("internal error: ") + error.what());
    return headland::kExitInternal;
  } catch (const std::exception& error) {
    complain(std::string("internal error: ") + error.what());
    return headland::kExitInternal;
  }
}

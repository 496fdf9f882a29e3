// Words of the command line that mean nothing, told with what was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace headland {

// Throws InputError for an unknown subcommand or option, with the nearest known one: CLI11 calls
// them unexpected arguments.
void check_words(const CLI::App& app, int argc, const char* const* argv);

// "headland drive --help": the help on the subcommands that the words name.
std::string help_command(const CLI::App& app, int argc, const char* const* argv);

}  // namespace headland

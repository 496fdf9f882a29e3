#include "apps/command_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "terrains/input_error.h"

namespace headland {
namespace {

// The subcommand that the first words name, and how many they are with the program's own.
struct Named {
  const CLI::App* app;
  int words = 1;
};

const CLI::App* subcommand(const CLI::App& app, const std::string& word) {
  const std::vector<const CLI::App*> all = app.get_subcommands({});
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const CLI::App* command) { return command->get_name() == word; });
  return found == all.end() ? nullptr : *found;
}

Named named_subcommand(const CLI::App& app, int argc, const char* const* argv) {
  Named named{&app};
  while (named.words < argc) {
    const CLI::App* next = subcommand(*named.app, argv[named.words]);
    if (next == nullptr) break;
    named.app = next;
    ++named.words;
  }
  return named;
}

std::string subcommand_path(int words, const char* const* argv) {
  return fmt::format("{}", fmt::join(argv + 1, argv + words, " "));
}

void check_subcommand(const Named& named, const char* word, const char* const* argv) {
  std::vector<std::string> known;
  for (const CLI::App* command : named.app->get_subcommands({})) {
    known.push_back(command->get_name());
  }
  if (known.empty() || word[0] == '-') return;
  throw InputError(subcommand_path(named.words, argv), "", word,
                   fmt::format("unknown subcommand; did you mean '{}'? (known: {})",
                               nearest_name(word, known), fmt::join(known, ", ")));
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

bool is_option(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && word.find_first_of("0123456789.") != 1;
}

}  // namespace

void check_words(const CLI::App& app, int argc, const char* const* argv) {
  const Named named = named_subcommand(app, argc, argv);
  if (named.words < argc) check_subcommand(named, argv[named.words], argv);
  for (int i = named.words; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--") return;
    if (!is_option(word)) continue;
    const bool is_long = word.starts_with("--");
    const std::string name(word.substr(0, is_long ? word.find('=') : 2));
    const CLI::Option* option = named.app->get_option_no_throw(name);
    if (option == nullptr) {
      const std::vector<std::string> known = option_names(*named.app);
      throw InputError(name, "", "",
                       fmt::format("unknown option; did you mean '{}'? (see '{}')",
                                   nearest_name(name, known), help_command(app, argc, argv)));
    }
    // Its value is the next word unless it stands in this one.
    const bool takes_next = option->get_type_size() != 0 && name.size() == word.size();
    if (takes_next) ++i;
  }
}

std::string help_command(const CLI::App& app, int argc, const char* const* argv) {
  const Named named = named_subcommand(app, argc, argv);
  const std::string path = subcommand_path(named.words, argv);
  return "headland " + path + (path.empty() ? "" : " ") + "--help";
}

}  // namespace headland

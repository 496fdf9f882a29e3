// headland render: draws what a run left in its folder.
#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/terminal_text.h"
#include "evaluate/results.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr const char* kPictures[] = {kFieldPicture, kViewPicture, kEnergyPicture};

int render(const CommonOptions& options) {
  const std::filesystem::path folder = options.folder;
  const PictureSize size = picture_size(options);
  for (const char* needed :
       {kScenarioFile, kPathFile, kMetricsFile, kRunFile, kFootprintFile, kSegmentsFile}) {
    if (!std::filesystem::exists(folder / needed)) {
      throw InputError((folder / needed).string(), "", "",
                       "no such file: 'headland drive' or 'headland evaluate' writes it");
    }
    require_file(folder / needed);
  }
  const Job job = make_job(folder / kScenarioFile, folder, options);
  draw_stage(job, size);
  if (options.json) {
    nlohmann::ordered_json json;
    for (const char* name : kPictures) {
      json["pictures"].push_back((folder / name).string());
    }
    fmt::print("{}\n", json_text(json, 2));
  } else if (!options.quiet) {
    for (const char* name : kPictures) {
      fmt::print("{}\n", terminal_text((folder / name).string()));
    }
  }
  return kExitRan;
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("render", "Draw the pictures of a run");
  auto options = std::make_shared<CommonOptions>();
  command->add_option("DIR", options->folder, "Folder that 'drive' or 'evaluate' wrote")
      ->required();
  add_size_option(*command, *options);
  command->add_flag("--json", options->json, "Print the pictures' names as JSON");
  command->add_flag("--quiet,-q", options->quiet, "Print nothing");
  command->footer(
      "Example:\n  headland render out/demo --size 2400x1500\n\n"
      "Writes field.png, view.png and energy.png into the folder.");
  command->callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace headland

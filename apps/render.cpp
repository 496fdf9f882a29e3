// headland render: draws what a run left in its folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/render_view.h"
#include "apps/terminal_text.h"
#include "apps/video_stage.h"
#include "evaluate/atomic_file.h"
#include "evaluate/results.h"
#include "render/vehicle_mesh.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr const char* kPictures[] = {kFieldPicture, kViewPicture, kEnergyPicture};
constexpr PictureSize kLeastVideo{480, 270};

struct RenderOptions {
  CommonOptions common;
  std::string view;
  std::string at;
  std::string overlay;
  std::optional<double> exaggeration;
  std::string file;
  std::string video;
  std::string from;
  std::string to;
  std::optional<double> speed;
  std::optional<double> frames_per_s;
  std::optional<int> processes;
};

void tell_written(const CommonOptions& options, const std::vector<std::string>& files) {
  if (options.json) {
    nlohmann::ordered_json json;
    json["pictures"] = files;
    fmt::print("{}\n", json_text(json, 2));
  } else if (!options.quiet) {
    for (const std::string& file : files) fmt::print("{}\n", terminal_text(file));
  }
}

Job job_of(const CommonOptions& options) {
  const std::filesystem::path folder = options.folder;
  if (!std::filesystem::exists(folder / kScenarioFile)) {
    throw InputError((folder / kScenarioFile).string(), "", "",
                     "no such file: 'headland drive' or 'headland evaluate' writes it");
  }
  // Before the folder is taken for one to write into.
  for (const char* name : {kScenarioFile, kPathFile, kRunFile, kFootprintFile, kSegmentsFile}) {
    if (std::filesystem::exists(folder / name)) require_file(folder / name);
  }
  return make_job(folder / kScenarioFile, folder, options);
}

ViewRequest request_of(const RenderOptions& options) {
  ViewRequest request;
  request.view = options.view.empty() ? "map" : options.view;
  request.size = picture_size(options.common);
  if (!options.at.empty()) request.at_s = time_from("--at", options.at);
  if (!options.overlay.empty()) request.overlay = quantity_named(options.overlay);
  request.exaggeration = options.exaggeration;
  constexpr double kMost = 1000.0;
  if (request.exaggeration && !(*request.exaggeration >= 1.0 && *request.exaggeration <= kMost)) {
    throw InputError("--exaggeration", "", fmt::format("{:g}", *request.exaggeration),
                     fmt::format("from 1 to {:g}", kMost));
  }
  return request;
}

// However damaged; what is missing is said.
RecordedRun read_run_and_tell(const Job& job) {
  RecordedRun recorded = recorded_run(job);
  tell_missing(recorded.missing);
  const VehicleMesh body = body_mesh(job.stage.vehicle);
  tell_missing(body.lacks);
  // A vehicle without a mesh is meant to be a box, one with a broken mesh is not.
  if (!body.note.empty() && !job.stage.vehicle.shapes.empty()) tell_missing({body.note});
  return recorded;
}

int render_all(const CommonOptions& options) {
  const std::filesystem::path folder = options.folder;
  const PictureSize size = picture_size(options);
  const Job job = job_of(options);
  draw_stage(job, read_run_and_tell(job), size);
  std::vector<std::string> files;
  for (const char* name : kPictures) files.push_back((folder / name).string());
  tell_written(options, files);
  return kExitRan;
}

int render_view(const RenderOptions& options) {
  const ViewRequest request = request_of(options);
  const std::filesystem::path file =
      options.file.empty()
          ? std::filesystem::path(options.common.folder) /
                (fmt::format("{}.png", request.view.substr(request.view.find(':') + 1)))
          : std::filesystem::path(options.file);
  if (file.extension() != ".png") {
    throw InputError("--output", "", file.string(), "a file whose name ends in .png");
  }
  require_replaceable(file);
  const Job job = job_of(options.common);
  std::string png;
  {
    // What is planned on a grid is there before anything is driven.
    const RecordedRun recorded = request.view == kGridView ? RecordedRun{} : read_run_and_tell(job);
    const InterruptAtOnce at_once;
    png = png_of(draw_requested(job, recorded, request));
  }
  write_together(file.parent_path().empty() ? "." : file.parent_path(),
                 {{file.filename().string(), png}});
  tell_written(options.common, {file.string()});
  return kExitRan;
}

int render_video(const RenderOptions& options) {
  if (!options.view.empty() || !options.overlay.empty() || !options.at.empty() ||
      !options.file.empty() || options.exaggeration) {
    throw InputError("--video", "", options.video,
                     "takes none of --view, --at, --overlay, --exaggeration and --output");
  }
  VideoRequest request;
  request.file = options.video;
  if (!options.common.size.empty()) request.size = picture_size(options.common, kLeastVideo);
  request.speed = options.speed;
  if (!options.from.empty()) request.from_s = time_from("--from", options.from);
  if (!options.to.empty()) request.to_s = time_from("--to", options.to);
  request.frames_per_s = options.frames_per_s.value_or(request.frames_per_s);
  request.processes = options.processes;
  request.quiet = options.common.quiet || options.common.json;
  check_video_request(request);
  const Job job = job_of(options.common);
  video_stage(job, read_run_and_tell(job), request);
  tell_written(options.common, {options.video});
  return kExitRan;
}

int render(const RenderOptions& options) {
  if (!options.video.empty()) return render_video(options);
  if (options.speed || options.frames_per_s || options.processes || !options.from.empty() ||
      !options.to.empty()) {
    throw InputError("--from, --to, --speed, --fps, --jobs", "", "", "are of a --video");
  }
  const bool one = !options.view.empty() || !options.overlay.empty() || !options.at.empty() ||
                   !options.file.empty() || options.exaggeration;
  return one ? render_view(options) : render_all(options.common);
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("render", "Draw the pictures of a run");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("DIR", options->common.folder, "Folder that 'drive' or 'evaluate' wrote")
      ->required();
  std::vector<std::string_view> overlays;
  for (const QuantityEntry& entry : path_quantities()) overlays.push_back(entry.name);
  command->add_option("--view", options->view,
                      fmt::format("One picture: {}", fmt::join(view_names(), ", ")));
  command->add_option("--at", options->at, "Moment of the run: seconds, or 1:30, or 1:02:30");
  command->add_option("--overlay", options->overlay,
                      fmt::format("Colour the way by {}", fmt::join(overlays, ", ")));
  command->add_option("--exaggeration", options->exaggeration,
                      "Stretch heights (perspective, elevation)");
  command->add_option("--output,-o", options->file,
                      "The picture (default: in DIR, named after the view)");
  add_size_option(*command, options->common);
  command->add_option("--video", options->video,
                      "Film the run into this .mp4: the machine from behind, the map beside it");
  command->add_option("--from", options->from, "Where the video begins, as --at");
  command->add_option("--to", options->to, "Where it ends");
  command->add_option("--speed", options->speed,
                      "Seconds of the run in one of the video (default: a minute in all)");
  command->add_option("--fps", options->frames_per_s, "Frames a second of the video (default: 25)");
  command->add_option("--jobs", options->processes,
                      "Processes that draw frames (default: one a processor)");
  command->add_flag("--json", options->common.json, "Print the pictures' names as JSON");
  command->add_flag("--quiet,-q", options->common.quiet, "Print nothing");
  command->footer(
      "Examples:\n  headland render out/demo --size 2400x1500\n"
      "  headland render out/demo --view chase --at 3:20 -o chase.png\n"
      "  headland render out/demo --view map --overlay slip --size 4096x4096\n"
      "  headland render out/demo --view event:worst_slip\n"
      "  headland render out/demo --video demo.mp4 --speed 60\n\n"
      "Without a view, writes field.png, view.png and energy.png into the folder.");
  command->callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace headland

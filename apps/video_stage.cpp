#include "apps/video_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "apps/interrupt.h"
#include "apps/progress.h"
#include "evaluate/atomic_file.h"
#include "render/called_program.h"
#include "render/frame_workers.h"
#include "render/video_encoder.h"
#include "render/video_frame.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kLongest_s = 60.0;  // of a video whose speed is not given
constexpr int kMostFrames = 200000;

struct Times {
  double from_s = 0.0;
  double to_s = 0.0;
  double speed = 1.0;
  int frames = 0;
};

Times times_of(const RunRecord& run, const VideoRequest& request) {
  if (run.samples.empty())
    throw InputError("--video", "", "", "the run has no samples to be shown");
  Times times;
  const double first_s = run.samples.front().time_s;
  const double last_s = run.samples.back().time_s;
  times.from_s = request.from_s.value_or(first_s);
  times.to_s = request.to_s.value_or(last_s);
  if (times.to_s > last_s) {
    throw InputError("--to", "", fmt::format("{:g} s", times.to_s),
                     fmt::format("the run ends after {:.1f} s", last_s));
  }
  if (!(times.from_s <= times.to_s)) {
    throw InputError("--from", "", fmt::format("{:g} s", times.from_s),
                     fmt::format("before --to and the run's end at {:.1f} s", last_s));
  }
  const double length_s = times.to_s - times.from_s;
  times.speed = request.speed.value_or(std::max(1.0, std::ceil(length_s / kLongest_s)));
  const double frames = std::floor(length_s / times.speed * request.frames_per_s + 1e-9) + 1.0;
  if (!(frames <= kMostFrames)) {
    throw InputError(
        "--speed", "", fmt::format("{:g}", times.speed),
        fmt::format("{:.0f} frames are more than {}; choose a higher speed", frames, kMostFrames));
  }
  times.frames = static_cast<int>(frames);
  return times;
}

}  // namespace

void check_video_request(const VideoRequest& request) {
  const auto refuse = [](const char* option, double given, const char* allowed) {
    throw InputError(option, "", fmt::format("{:g}", given), allowed);
  };
  if (request.file.extension() != ".mp4") {
    throw InputError("--video", "", request.file.string(), "a file whose name ends in .mp4");
  }
  if (request.size.width % 2 != 0 || request.size.height % 2 != 0) {
    throw InputError("--size", "", fmt::format("{}x{}", request.size.width, request.size.height),
                     "even numbers of pixels for a video");
  }
  if (request.speed && !(*request.speed >= 0.01 && *request.speed <= 1e4)) {
    refuse("--speed", *request.speed, "from 0.01 to 10000");
  }
  if (!(request.frames_per_s >= 1.0 && request.frames_per_s <= 60.0)) {
    refuse("--fps", request.frames_per_s, "from 1 to 60");
  }
  if (request.processes && (*request.processes < 1 || *request.processes > 64)) {
    refuse("--jobs", *request.processes, "from 1 to 64");
  }
  const std::filesystem::path folder = std::filesystem::absolute(request.file).parent_path();
  if (std::error_code ignored; !std::filesystem::is_directory(folder, ignored)) {
    throw InputError("--video", "", request.file.string(), "a file in a folder that exists");
  }
  check_output_folder(folder);
  require_replaceable(request.file);
  require_ffmpeg();
}

void video_stage(const Job& job, const RecordedRun& recorded, const VideoRequest& request) {
  const Times times = times_of(recorded.run, request);
  stop_if_interrupted();
  const BrokenPipesIgnored ignored;
  const CoverageRaster none;
  const PictureScene scene{job.stage.field, job.stage.terrain, job.stage.vehicle,
                           recorded.path,   recorded.run,      none};
  const VideoFrameOptions options{request.size, job.scenario.working_width_m,
                                  job.scenario.coverage_cell_m, times.speed};
  const auto begin = [&]() -> DrawFrame {
    const auto painter = std::make_shared<VideoPainter>(scene, options);
    return [painter, &times, &request](int frame) {
      return painter->draw(times.from_s + times.speed * frame / request.frames_per_s);
    };
  };
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int processes = std::min(request.processes.value_or(cores), times.frames);
  FrameWorkers workers(times.frames, processes, begin);
  VideoEncoder encoder(request.file, request.size, request.frames_per_s);
  ProgressLine line = start_progress(request.quiet);
  std::vector<std::uint8_t> rgba;
  const std::size_t size = 4 * static_cast<std::size_t>(request.size.width) *
                           static_cast<std::size_t>(request.size.height);
  try {
    for (int frame = 0; frame < times.frames; ++frame) {
      if (!workers.read(frame, rgba, size, interrupted)) throw Interrupted{};
      encoder.write(rgba);
      show_count(line, "frames", frame + 1, times.frames);
    }
    encoder.finish();
  } catch (...) {
    end_progress(line);
    throw;
  }
  end_progress(line);
}

}  // namespace headland

// What pictures cost: a frame of the machine in the field, its coverage there already, a video, a
// large map, the report.
// Usage: render_bench DIR [--json], DIR holding a run ('headland evaluate' writes it). Frames are
// drawn with 4 samples a pixel, shadows, furrows and coverage.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "bench/figures.h"
#include "evaluate/coverage.h"
#include "evaluate/report_record.h"
#include "evaluate/results.h"
#include "evaluate/scenario.h"
#include "render/frame_workers.h"
#include "render/moment_view.h"
#include "render/run_moment.h"
#include "render/video_encoder.h"
#include "render/video_frame.h"

namespace headland {
namespace {

using Clock = std::chrono::steady_clock;

struct Loaded {
  explicit Loaded(const std::filesystem::path& folder)
      : scenario(read_scenario(folder / kScenarioFile, {})),
        stage(load_stage(scenario)),
        recorded(read_recorded_run(folder, stage.field)),
        coverage(measure_coverage(stage.field, recorded.run.footprints, scenario.working_width_m,
                                  scenario.coverage_cell_m)),
        scene{stage.field, stage.terrain, stage.vehicle, recorded.path, recorded.run, coverage} {}
  Scenario scenario;
  Stage stage;
  RecordedRun recorded;
  CoverageRaster coverage;
  PictureScene scene;
};

// Frames of a world that is on the graphics side already, from all along the run.
double frame_ms(const Loaded& run) {
  const PictureScene& scene = run.scene;
  const Typeface typeface(kFontFile, kBoldFontFile);
  const GlContext context;
  const World world(scene, {scene.run.samples.front().p_WB.z(), 1.0}, moment_sun());
  const SurfaceCoverage coverage(coverage_classes(scene.coverage, true));
  const GlFrame frame(1280, 720, colours::kPaper);
  const Box box{0.0, 0.0, 1280.0, 720.0};
  std::vector<double> times_ms;
  constexpr int kFrames = 25;
  for (int i = 0; i < kFrames; ++i) {
    const double time_s = scene.run.samples.back().time_s * (i + 0.5) / kFrames;
    const auto start = Clock::now();
    const RunSample now = sample_at(scene.run, time_s).value();
    const FieldView view =
        chase_view(scene, now, trailing_heading_rad(scene.run, time_s), box, world.relief);
    const Shot shot(world, view, Surroundings::kSky, &now);
    const Sheet lines = moment_lines(scene, view, now, nullptr, 0.8);
    const Image image = frame.draw(
        [&](const Canvas& canvas) { paint_world(canvas, typeface, world, shot, coverage, lines); });
    times_ms.push_back(1e3 * bench::seconds_since(start));
  }
  return bench::median(times_ms);
}

struct ScratchVideo {
  std::filesystem::path file = std::filesystem::temp_directory_path() /
                               fmt::format("headland-render-bench-{}.mp4", ::getpid());
  ScratchVideo() = default;
  ~ScratchVideo() { std::filesystem::remove(file); }
  ScratchVideo(const ScratchVideo&) = delete;
  ScratchVideo& operator=(const ScratchVideo&) = delete;
};

// As 'headland render --video' makes it, into a file.
double video_frames_per_s(const Loaded& run) {
  constexpr int kFrames = 120;
  const VideoFrameOptions options{
      {640, 360}, run.scenario.working_width_m, run.scenario.coverage_cell_m, 1.0};
  const double step_s = run.scene.run.samples.back().time_s / kFrames;
  const ScratchVideo video;
  const auto start = Clock::now();
  FrameWorkers workers(kFrames, 2, [&]() -> DrawFrame {
    const auto painter = std::make_shared<VideoPainter>(run.scene, options);
    return [painter, step_s](int frame) { return painter->draw(step_s * frame); };
  });
  VideoEncoder encoder(video.file, options.size, 25.0);
  std::vector<std::uint8_t> rgba;
  for (int frame = 0; frame < kFrames; ++frame) {
    workers.read(frame, rgba, std::size_t{4} * 640 * 360, [] { return false; });
    encoder.write(rgba);
  }
  encoder.finish();
  return kFrames / bench::seconds_since(start);
}

struct Took {
  double wall_s = 0.0;
  double processor_s = 0.0;
};

// As 'headland report' makes it of the folder.
Took report_time(const std::filesystem::path& folder) {
  const std::filesystem::path page = std::filesystem::temp_directory_path() /
                                     fmt::format("headland-render-bench-{}.html", ::getpid());
  const std::string program = HEADLAND_PROGRAM;
  const std::string from = folder.string();
  const auto start = Clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(program.c_str(), program.c_str(), "report", from.c_str(), "-q", "-o", page.c_str(),
            nullptr);
    ::_exit(127);
  }
  int status = -1;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  const double wall_s = bench::seconds_since(start);
  std::filesystem::remove(page);
  if (status != 0) throw std::runtime_error(program + " report " + from + " failed");
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {wall_s, seconds(used.ru_utime) + seconds(used.ru_stime)};
}

int run_bench(const std::filesystem::path& folder, bool as_json) {
  const Loaded run(folder);
  std::vector<bench::Figure> figures;
  // First, while the process is small: it starts others.
  figures.push_back({"video 640x360, two processes", video_frames_per_s(run), "frames/s", ">= 20"});
  const Took report = report_time(folder);
  figures.push_back({"report", report.wall_s, "s", "< 10"});
  figures.push_back({"report, processor time", report.processor_s, "s", ""});
  figures.push_back(
      {"frame 1280x720, 4x MSAA, shadows, coverage (median)", frame_ms(run), "ms", "<= 120"});
  const auto start = Clock::now();
  const Image map = draw_field_map(run.scene, {4096, 4096});
  figures.push_back({"map 4096x4096", bench::seconds_since(start), "s", "< 5"});
  figures.push_back({"peak memory", bench::peak_memory_bytes() / 1048576.0, "MiB", "< 500"});
  bench::print(figures, as_json);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: render_bench DIR [--json]\n", stderr);
    return 2;
  }
  return headland::run_bench(argv[1], headland::bench::wants_json(argc, argv));
}

#include "evaluate/results.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <system_error>

#include "evaluate/atomic_file.h"
#include "evaluate/metrics_file.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

constexpr std::string_view kInOrder[] = {
    kScenarioFile, kPlanFile,      kGridPlanFile, kJobFile,     kPathFile,
    kRunFile,      kFootprintFile, kSegmentsFile, kMetricsFile, kFieldPicture,
    kViewPicture,  kEnergyPicture, kReportFile};

// Row `row` of a table, counted from 0 after the header.
InputError row_error(const std::filesystem::path& file, std::size_t row, const std::string& column,
                     const std::string& value, const std::string& allowed) {
  return {file.string(), fmt::format("line {}, {}", row + 2, column), value, allowed};
}

void check_segment(int segment, std::size_t row, const Path& path,
                   const std::filesystem::path& file) {
  if (segment >= 0 && static_cast<std::size_t>(segment) < path.segments.size()) return;
  throw row_error(file, row, "segment", fmt::format("{}", segment),
                  fmt::format("{} beside it has {} segments: the run belongs to another path",
                              kPathFile, path.segments.size()));
}

// The vehicle cannot have been further from its path than the terrain reaches.
void check_place(const Eigen::Vector2d& p_W, std::size_t row, const std::string& column,
                 const Eigen::AlignedBox2d& path_box, const std::filesystem::path& file) {
  constexpr double kNear_m = 2.0 * kMaxMargin_m;
  if (path_box.isEmpty() || path_box.exteriorDistance(p_W) <= kNear_m) return;
  throw row_error(file, row, column, fmt::format("{:.7g}, {:.7g}", p_W.x(), p_W.y()),
                  fmt::format("a place within {} m of {} beside it", kNear_m, kPathFile));
}

template <typename Row>
void check_order(const std::vector<Row>& rows, const std::string& column, double Row::*value,
                 const std::filesystem::path& file) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].*value >= rows[i - 1].*value) continue;
    throw row_error(file, i, column, fmt::format("{}", rows[i].*value),
                    fmt::format("at least {}, as in the line before", rows[i - 1].*value));
  }
}

void check_samples(const std::vector<RunSample>& samples, const Path& path,
                   const Eigen::AlignedBox2d& path_box, const std::filesystem::path& file) {
  if (samples.empty()) throw InputError(file.string(), "line 2", "", "the table has no rows");
  check_order(samples, "time_s", &RunSample::time_s, file);
  check_order(samples, "travel_m", &RunSample::travel_m, file);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    check_segment(samples[i].segment, i, path, file);
    check_place(samples[i].p_WB.head<2>(), i, "x_m, y_m", path_box, file);
  }
}

void check_footprints(const std::vector<FootprintSample>& footprints,
                      const Eigen::AlignedBox2d& path_box, const std::filesystem::path& file) {
  check_order(footprints, "time_s", &FootprintSample::time_s, file);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    check_place(footprints[i].left_W, i, "left_x_m, left_y_m", path_box, file);
    check_place(footprints[i].right_W, i, "right_x_m, right_y_m", path_box, file);
  }
}

}  // namespace

void remove_results_from(const std::filesystem::path& folder, std::string_view first) {
  for (auto name = std::find(std::begin(kInOrder), std::end(kInOrder), first);
       name != std::end(kInOrder); ++name) {
    std::error_code ignored;
    std::filesystem::remove(folder / *name, ignored);
  }
}

void check_results_folder(const std::filesystem::path& folder) {
  check_output_folder(folder);
  for (const std::string_view name : kInOrder) require_replaceable(folder / name);
}

void require_no_result(const std::filesystem::path& folder, const std::filesystem::path& file) {
  for (const std::string_view name : kInOrder) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(folder / name, file, ignored)) continue;
    throw InputError(file.string(), "", "",
                     "the results would replace it; give another folder for them with -o");
  }
}

RunRecord read_run(const std::filesystem::path& folder, const Path& path) {
  RunRecord run = read_run_totals(folder / kMetricsFile);
  run.samples = read_run_csv(folder / kRunFile);
  run.footprints = read_footprint_csv(folder / kFootprintFile);
  run.segments = read_segments_csv(folder / kSegmentsFile, run.outcome == Outcome::kDiverged);
  Eigen::AlignedBox2d path_box;
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) path_box.extend(point.p_W);
  }
  check_samples(run.samples, path, path_box, folder / kRunFile);
  check_footprints(run.footprints, path_box, folder / kFootprintFile);
  for (std::size_t i = 0; i < run.segments.size(); ++i) {
    check_segment(run.segments[i].segment, i, path, folder / kSegmentsFile);
  }
  return run;
}

}  // namespace headland

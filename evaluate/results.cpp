#include "evaluate/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "evaluate/metrics_file.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

void check_segment(int segment, const Path& path, const std::filesystem::path& file) {
  if (segment >= 0 && static_cast<std::size_t>(segment) < path.segments.size()) return;
  throw InputError(file.string(), "segment", fmt::format("{}", segment),
                   fmt::format("{} beside it has {} segments: the run belongs to another path",
                               kPathFile, path.segments.size()));
}

}  // namespace

void remove_results_from(const std::filesystem::path& folder, std::string_view first) {
  constexpr std::string_view kInOrder[] = {
      kScenarioFile, kPlanFile,    kPathFile,     kRunFile,     kFootprintFile,
      kSegmentsFile, kMetricsFile, kFieldPicture, kViewPicture, kEnergyPicture};
  for (auto name = std::find(std::begin(kInOrder), std::end(kInOrder), first);
       name != std::end(kInOrder); ++name) {
    std::error_code ignored;
    std::filesystem::remove(folder / *name, ignored);
  }
}

RunRecord read_run(const std::filesystem::path& folder, const Path& path) {
  RunRecord run = read_run_totals(folder / kMetricsFile);
  run.samples = read_run_csv(folder / kRunFile);
  run.footprints = read_footprint_csv(folder / kFootprintFile);
  run.segments = read_segments_csv(folder / kSegmentsFile);
  for (const RunSample& sample : run.samples) {
    check_segment(sample.segment, path, folder / kRunFile);
  }
  for (const SegmentRecord& record : run.segments) {
    check_segment(record.segment, path, folder / kSegmentsFile);
  }
  return run;
}

}  // namespace headland

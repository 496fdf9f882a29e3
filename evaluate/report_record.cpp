#include "evaluate/report_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluate/metrics_file.h"
#include "evaluate/plan_file.h"
#include "evaluate/results.h"
#include "evaluate/run_tables.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

std::string because(const InputError& fault) {
  return fmt::format("({}{}{}: {})", fs::path(fault.source).filename().string(),
                     fault.where.empty() ? "" : ", ", fault.where, fault.allowed);
}

// Does `read`, and tells what of it failed.
template <typename Read>
bool attempt(std::vector<std::string>& missing, const std::string& lost, Read read) {
  try {
    read();
    return true;
  } catch (const InputError& fault) {
    missing.push_back(lost + " " + because(fault));
    return false;
  }
}

// What a run without its path, or of another path, would point nowhere with.
void drop_strays(RecordedRun& recorded) {
  const std::size_t known = recorded.path.segments.size();
  const auto stray = [known](int segment) {
    return segment < 0 || static_cast<std::size_t>(segment) >= known;
  };
  std::erase_if(recorded.run.segments,
                [&](const SegmentRecord& record) { return stray(record.segment); });
}

RecordedRun read_piece_by_piece(const fs::path& folder, const Field& field) {
  RecordedRun recorded;
  std::vector<std::string>& missing = recorded.missing;
  RunRecord& run = recorded.run;
  attempt(missing, "The planned path is missing",
          [&] { recorded.path = read_path(folder / kPathFile, field); });
  attempt(missing, "Totals, verdict and figures are missing", [&] {
    run = read_run_totals(folder / kMetricsFile);
    recorded.metrics = parse_json(folder / kMetricsFile);
  });
  const auto so_far = [&] {
    return run.samples.empty()
               ? std::string("The time series is missing")
               : fmt::format("The time series ends after {:.1f} s", run.samples.back().time_s);
  };
  std::vector<std::string> series;
  if (!attempt(series, "", [&] { read_run_csv(folder / kRunFile, run.samples); })) {
    missing.push_back(so_far() + series.front());
  }
  attempt(missing, "Ground covered is known in part at most",
          [&] { read_footprint_csv(folder / kFootprintFile, run.footprints); });
  attempt(missing, "Costs of movements are known in part at most", [&] {
    read_segments_csv(folder / kSegmentsFile, run.outcome == Outcome::kDiverged, run.segments);
  });
  drop_strays(recorded);
  return recorded;
}

// Tables cut between two rows can be read as if they were whole.
void tell_cuts(RecordedRun& recorded) {
  const RunRecord& run = recorded.run;
  if (run.samples.empty()) return;
  constexpr double kRowsLate = 1.5;
  double step_s = 0.0;
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    step_s = std::max(step_s, run.samples[i].time_s - run.samples[i - 1].time_s);
  }
  const double first_s = run.samples.front().time_s;
  const double last_s = run.samples.back().time_s;
  if (first_s > kRowsLate * step_s) {
    recorded.missing.push_back(
        fmt::format("The time series begins after {:.1f} s only ({})", first_s, kRunFile));
  }
  if (run.duration_s - last_s > kRowsLate * step_s) {
    recorded.missing.push_back(fmt::format("The time series ends after {:.1f} s of {:.1f} ({})",
                                           last_s, run.duration_s, kRunFile));
  }
  const auto works = std::find_if(run.samples.rbegin(), run.samples.rend(),
                                  [](const RunSample& sample) { return sample.implement_down; });
  if (works == run.samples.rend()) return;
  constexpr double kFootprintsApart_m = 1.0;  // at most
  const double known_m = run.footprints.empty() ? 0.0 : run.footprints.back().travel_m;
  if (works->travel_m - known_m > kFootprintsApart_m) {
    recorded.missing.push_back(
        fmt::format("Ground covered is known for {:.1f} m of {:.1f} m driven ({})", known_m,
                    works->travel_m, kFootprintFile));
  }
}

}  // namespace

RecordedRun read_recorded_run(const fs::path& folder, const Field& field) {
  if (!fs::exists(folder / kMetricsFile) && !fs::exists(folder / kRunFile)) {
    throw InputError((folder / kMetricsFile).string(), "", "",
                     "no such file: 'headland drive' or 'headland evaluate' writes it");
  }
  try {
    RecordedRun recorded;
    recorded.path = read_path(folder / kPathFile, field);
    recorded.run = read_run(folder, recorded.path);
    recorded.metrics = parse_json(folder / kMetricsFile);
    tell_cuts(recorded);
    return recorded;
  } catch (const InputError& fault) {
    RecordedRun recorded = read_piece_by_piece(folder, field);
    if (!recorded.missing.empty()) return recorded;
    // Every file by itself can be read.
    recorded.missing.push_back((recorded.run.samples.empty()
                                    ? "The time series is missing "
                                    : "The files do not belong together ") +
                               because(fault));
    return recorded;
  }
}

}  // namespace headland

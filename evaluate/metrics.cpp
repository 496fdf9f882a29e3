#include "evaluate/metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "sim/ledger.h"

namespace headland {
namespace {

constexpr double kSquareMetrePerHectare = 10000.0;

// Root of the mean square over a distance, from its integral over that distance.
struct DistanceMean {
  double integral_m3 = 0.0;
  double distance_m = 0.0;
  double rms_m() const { return distance_m > 0.0 ? std::sqrt(integral_m3 / distance_m) : 0.0; }
};

double residual_ratio(const EnergyBalance& energy) {
  double losses_j = 0.0;
  for (std::size_t cause = 0; cause < static_cast<std::size_t>(EnergyCause::kGrade); ++cause) {
    losses_j += energy.cause_j[cause];
  }
  const double throughput_j = std::max(std::abs(energy.battery_j), losses_j);
  const double residual_j =
      std::abs(energy.cause_j[static_cast<std::size_t>(EnergyCause::kResidual)]);
  if (residual_j == 0.0) return 0.0;
  return residual_j / throughput_j;
}

}  // namespace

Metrics measure_run(const Path& path, const RunRecord& run, const CoverageFigures& coverage) {
  Metrics metrics;
  metrics.coverage = coverage;
  if (coverage.workable_m2 > 0.0) {
    metrics.coverage_ratio = coverage.covered_m2 / coverage.workable_m2;
    metrics.overlap_ratio = coverage.overlap_m2 / coverage.workable_m2;
    metrics.outside_area_ratio = coverage.outside_m2 / coverage.workable_m2;
  }
  metrics.distance_m = run.distance_m;
  metrics.time_s = run.duration_s;
  metrics.energy_wh = run.energy.battery_j / kJoulePerWattHour;
  metrics.energy_wh_per_ha =
      coverage.covered_m2 > 0.0 ? metrics.energy_wh / (coverage.covered_m2 / kSquareMetrePerHectare)
                                : std::numeric_limits<double>::quiet_NaN();
  metrics.delta_soc = run.soc_start - run.soc_end;
  metrics.rested_voltage_drop_v = run.rested_voltage_start_v - run.rested_voltage_end_v;
  metrics.worst_slip = run.peaks.slip.value;
  metrics.worst_load_transfer = std::abs(run.peaks.load_transfer_ratio.value);
  metrics.ledger_residual_ratio = residual_ratio(run.energy);

  std::set<std::pair<PathKind, int>> counted;
  DistanceMean working;
  DistanceMean turning;
  for (const SegmentRecord& driven : run.segments) {
    assert(driven.segment >= 0 && static_cast<std::size_t>(driven.segment) < path.segments.size());
    const PathSegment& segment = path.segments[static_cast<std::size_t>(driven.segment)];
    KindTotals& totals = metrics.by_kind[static_cast<std::size_t>(segment.kind)];
    totals.count += counted.emplace(segment.kind, segment.manoeuvre).second ? 1 : 0;
    totals.time_s += driven.duration_s;
    totals.distance_m += driven.distance_m;
    add(totals.energy, driven.energy);
    DistanceMean& mean = segment.implement_down ? working : turning;
    mean.integral_m3 += driven.cross_track_sum_m3;
    mean.distance_m += driven.distance_m;
  }
  metrics.turns = metrics.by_kind[static_cast<std::size_t>(PathKind::kTurn)].count;
  metrics.u_turns = metrics.by_kind[static_cast<std::size_t>(PathKind::kUTurn)].count;
  metrics.track_rms_working_m = working.rms_m();
  metrics.track_rms_turning_m = turning.rms_m();
  return metrics;
}

}  // namespace headland

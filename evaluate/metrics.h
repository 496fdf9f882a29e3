// Figures of a run: free functions over its record.
#pragma once

#include <array>
#include <cstddef>

#include "evaluate/coverage.h"
#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {

// Totals of one kind of path segment.
struct KindTotals {
  int count = 0;  // manoeuvres begun
  double time_s = 0.0;
  double distance_m = 0.0;
  EnergyBalance energy;
};

inline constexpr std::array kEveryPathKind = {PathKind::kSwath, PathKind::kHeadlandPass,
                                              PathKind::kTurn, PathKind::kUTurn,
                                              PathKind::kTransit};
inline constexpr std::size_t kPathKinds = kEveryPathKind.size();

struct Metrics {
  CoverageFigures coverage;
  double coverage_ratio = 0.0;      // covered / workable
  double overlap_ratio = 0.0;       // overlap / workable
  double outside_area_ratio = 0.0;  // outside / workable
  double distance_m = 0.0;
  double time_s = 0.0;
  double energy_wh = 0.0;         // battery, chemistry side
  double energy_wh_per_ha = 0.0;  // of covered area; NaN when nothing was covered
  double delta_soc = 0.0;
  double rested_voltage_drop_v = 0.0;
  int turns = 0;  // manoeuvres of kind turn
  int u_turns = 0;
  double worst_slip = 0.0;
  double worst_load_transfer = 0.0;
  double track_rms_working_m = 0.0;  // over the distance with the implement down
  double track_rms_turning_m = 0.0;  // over the distance with it raised
  // |residual| over the larger of the battery's net energy and the sum of all losses: downhill the
  // net alone may be close to nothing.
  double ledger_residual_ratio = 0.0;
  KindTotals by_kind[kPathKinds];  // indexed by PathKind
};

// `run` is a drive of `path`: its segment records point into the path's segments.
Metrics measure_run(const Path& path, const RunRecord& run, const CoverageFigures& coverage);

}  // namespace headland

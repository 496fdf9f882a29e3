#include "evaluate/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace headland {
namespace {

double& cause(EnergyBalance& energy, EnergyCause which) {
  return energy.cause_j[static_cast<std::size_t>(which)];
}

// Swath, U-turn in two segments (a cusp), swath, turn: as a short drive leaves them.
struct Drive {
  Path path;
  RunRecord run;

  Drive() {
    add(PathKind::kSwath, true, 0, 100.0, 36000.0, 0.04);
    add(PathKind::kUTurn, false, 1, 6.0, 3600.0, 0.06);
    add(PathKind::kUTurn, false, 1, 4.0, 1800.0, 0.04);
    add(PathKind::kSwath, true, 2, 100.0, 36000.0, 0.12);
    add(PathKind::kTurn, false, 3, 10.0, 3600.0, 0.22);
    run.distance_m = 220.0;
    run.duration_s = 220.0;
  }

  void add(PathKind kind, bool down, int manoeuvre, double distance_m, double battery_j,
           double error_integral_m3) {
    PathSegment& segment = path.segments.emplace_back();
    segment.kind = kind;
    segment.implement_down = down;
    segment.manoeuvre = manoeuvre;
    SegmentRecord driven;
    driven.segment = static_cast<int>(path.segments.size()) - 1;
    driven.distance_m = distance_m;
    driven.duration_s = distance_m;
    driven.energy.battery_j = battery_j;
    cause(driven.energy, EnergyCause::kRolling) = battery_j;
    driven.cross_track_sum_m3 = error_integral_m3;
    run.segments.push_back(driven);
    run.energy.battery_j += battery_j;
    cause(run.energy, EnergyCause::kRolling) += battery_j;
  }
};

const KindTotals& of(const Metrics& metrics, PathKind kind) {
  return metrics.by_kind[static_cast<std::size_t>(kind)];
}

constexpr CoverageFigures kCoverage{.workable_m2 = 10000.0,
                                    .covered_m2 = 9000.0,
                                    .overlap_m2 = 500.0,
                                    .missed_m2 = 1000.0,
                                    .outside_m2 = 50.0};

TEST(Metrics, RatiosAreOfTheWorkableArea) {
  const Drive drive;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_DOUBLE_EQ(metrics.coverage_ratio, 0.9);
  EXPECT_DOUBLE_EQ(metrics.overlap_ratio, 0.05);
  EXPECT_DOUBLE_EQ(metrics.outside_area_ratio, 0.005);
  EXPECT_EQ(metrics.coverage.missed_m2, 1000.0);
}

TEST(Metrics, EnergyIsInWattHoursAndPerCoveredHectare) {
  const Drive drive;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_DOUBLE_EQ(metrics.energy_wh, 81000.0 / 3600.0);
  EXPECT_DOUBLE_EQ(metrics.energy_wh_per_ha, 22.5 / 0.9);
}

TEST(Metrics, EnergyPerHectareOfNothingIsNotANumber) {
  const Drive drive;
  EXPECT_TRUE(std::isnan(measure_run(drive.path, drive.run, {}).energy_wh_per_ha));
}

TEST(Metrics, AManoeuvreWithACuspIsOneTurn) {
  const Drive drive;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_EQ(metrics.turns, 1);
  EXPECT_EQ(metrics.u_turns, 1);
  EXPECT_EQ(of(metrics, PathKind::kSwath).count, 2);
  EXPECT_EQ(of(metrics, PathKind::kTransit).count, 0);
}

TEST(Metrics, TotalsByKindAddUpToTheRun) {
  const Drive drive;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_DOUBLE_EQ(of(metrics, PathKind::kUTurn).distance_m, 10.0);
  EXPECT_DOUBLE_EQ(of(metrics, PathKind::kUTurn).energy.battery_j, 5400.0);
  double distance_m = 0.0;
  double time_s = 0.0;
  double battery_j = 0.0;
  for (const KindTotals& totals : metrics.by_kind) {
    distance_m += totals.distance_m;
    time_s += totals.time_s;
    battery_j += totals.energy.battery_j;
  }
  EXPECT_DOUBLE_EQ(distance_m, metrics.distance_m);
  EXPECT_DOUBLE_EQ(time_s, metrics.time_s);
  EXPECT_DOUBLE_EQ(battery_j, drive.run.energy.battery_j);
}

TEST(Metrics, TrackingErrorIsTheRootMeanSquareOverDistance) {
  const Drive drive;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_DOUBLE_EQ(metrics.track_rms_working_m, std::sqrt(0.16 / 200.0));
  EXPECT_DOUBLE_EQ(metrics.track_rms_turning_m, std::sqrt(0.32 / 20.0));
}

TEST(Metrics, OnlyWhatWasDrivenCounts) {
  Drive drive;
  drive.run.segments.resize(2);  // the run ended in the U-turn
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_EQ(metrics.turns, 0);
  EXPECT_EQ(metrics.u_turns, 1);
  EXPECT_EQ(of(metrics, PathKind::kSwath).count, 1);
}

TEST(Metrics, ARunThatNeverMovedHasZeroesNotNaN) {
  const Metrics metrics = measure_run(Path(), RunRecord(), kCoverage);
  EXPECT_EQ(metrics.track_rms_working_m, 0.0);
  EXPECT_EQ(metrics.track_rms_turning_m, 0.0);
  EXPECT_EQ(metrics.ledger_residual_ratio, 0.0);
}

TEST(Metrics, BatteryFiguresAreStartMinusEnd) {
  Drive drive;
  drive.run.soc_start = 0.95;
  drive.run.soc_end = 0.55;
  drive.run.rested_voltage_start_v = 51.0;
  drive.run.rested_voltage_end_v = 49.6;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_DOUBLE_EQ(metrics.delta_soc, 0.4);
  EXPECT_NEAR(metrics.rested_voltage_drop_v, 1.4, 1e-12);
}

TEST(Metrics, LoadTransferIsAMagnitude) {
  Drive drive;
  drive.run.peaks.load_transfer_ratio.value = -0.4;
  drive.run.peaks.slip.value = 0.12;
  const Metrics metrics = measure_run(drive.path, drive.run, kCoverage);
  EXPECT_EQ(metrics.worst_load_transfer, 0.4);
  EXPECT_EQ(metrics.worst_slip, 0.12);
}

TEST(Metrics, LedgerResidualIsOverTheEnergyThatWentThrough) {
  Drive drive;
  cause(drive.run.energy, EnergyCause::kResidual) = -81.0;
  EXPECT_DOUBLE_EQ(measure_run(drive.path, drive.run, kCoverage).ledger_residual_ratio, 0.001);
  // Downhill the battery may end where it began; the losses then are what went through.
  drive.run.energy.battery_j = 10.0;
  EXPECT_DOUBLE_EQ(measure_run(drive.path, drive.run, kCoverage).ledger_residual_ratio, 0.001);
}

}  // namespace
}  // namespace headland

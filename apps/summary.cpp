#include "apps/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/duration_text.h"
#include "evaluate/results.h"
#include "terrains/geo_frame.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

std::string percent(double ratio) { return fmt::format("{:.1f} %", 100.0 * ratio); }

std::string place(const Peak& peak) {
  return fmt::format("at x {:.1f}, y {:.1f} m after {}", peak.p_W.x(), peak.p_W.y(),
                     duration_text(peak.time_s));
}

std::string figures(const Vehicle& vehicle, const DriveResult& result) {
  const Metrics& m = result.metrics;
  const Peaks& peaks = result.run.peaks;
  const CoverageFigures& area = m.coverage;
  return summary_row("outcome", std::string(outcome_name(result.run.outcome)),
                     result.run.outcome_detail) +
         summary_row(
             "covered", hectares(area.covered_m2),
             percent(m.coverage_ratio) + " of " + hectares(area.workable_m2) + " workable") +
         summary_row("missed", hectares(area.missed_m2)) +
         summary_row("overlap", hectares(area.overlap_m2),
                     percent(m.overlap_ratio) + " of workable") +
         summary_row("outside the field", hectares(area.outside_m2)) +
         summary_row("distance", fmt::format("{:.0f} m", m.distance_m)) +
         summary_row("time", duration_text(m.time_s)) +
         summary_row("energy", fmt::format("{:.1f} Wh", m.energy_wh),
                     std::isfinite(m.energy_wh_per_ha)
                         ? fmt::format("{:.0f} Wh/ha", m.energy_wh_per_ha)
                         : "") +
         summary_row(
             "state of charge", charge_change_text(m.delta_soc),
             fmt::format("{:.1f} % to {:.1f} %, empty at {:.0f} %; lowest {:.1f} V under load",
                         100.0 * result.run.soc_start, 100.0 * result.run.soc_end,
                         100.0 * vehicle.battery.empty_soc, peaks.min_voltage_v.value)) +
         summary_row("turns", fmt::format("{}", m.turns),
                     fmt::format("and {} U-turns", m.u_turns)) +
         summary_row("worst slip", percent(m.worst_slip), place(peaks.slip)) +
         summary_row("load transfer", fmt::format("{:.2f}", m.worst_load_transfer),
                     place(peaks.load_transfer_ratio) + " (1 lifts the wheels of a side)") +
         summary_row("tips at rest on",
                     fmt::format("{:.0f} deg", degrees(side_stability_angle_rad(vehicle))),
                     fmt::format("of side slope, nose up on {:.0f} deg",
                                 degrees(nose_up_stability_angle_rad(vehicle)))) +
         summary_row(
             "tracking error", fmt::format("{:.3f} m", m.track_rms_working_m),
             fmt::format("rms at work, worst {:.3f} m; {:.3f} m rms in turns",
                         std::abs(peaks.cross_track_working_m.value), m.track_rms_turning_m)) +
         summary_row("energy ledger", fmt::format("{:.4f} %", 100.0 * m.ledger_residual_ratio),
                     "unaccounted for");
}

std::string energy_table(const RunRecord& run) {
  std::string text = "\n  where the energy went\n";
  const double battery_j = run.energy.battery_j;
  std::vector<std::pair<double, EnergyCause>> causes;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    causes.emplace_back(run.energy.cause_j[i], static_cast<EnergyCause>(i));
  }
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [energy_j, cause] : causes) {
    const double wh = energy_j / kJoulePerWattHour;
    if (std::abs(wh) < 0.05) continue;
    text +=
        summary_row(energy_cause_name(cause), fmt::format("{:.1f} Wh", wh),
                    battery_j > 0.0 ? fmt::format("{:5.1f} %", 100.0 * energy_j / battery_j) : "");
  }
  return text;
}

std::string kind_table(const Metrics& metrics) {
  std::string text = fmt::format("\n  {:<16}{:>6}{:>11}{:>15}{:>15}{:>13}{:>15}\n", "by movement",
                                 "count", "distance", "time", "energy", "per m", "each");
  for (const PathKind kind : kEveryPathKind) {
    const KindTotals& totals = metrics.by_kind[static_cast<std::size_t>(kind)];
    if (totals.count == 0) continue;
    const double wh = totals.energy.battery_j / kJoulePerWattHour;
    text += fmt::format("  {:<16}{:>6}{:>9.0f} m{:>15}{:>12.1f} Wh{:>10.3f} Wh{:>12.2f} Wh\n",
                        path_kind_name(kind), totals.count, totals.distance_m,
                        duration_text(totals.time_s), wh,
                        totals.distance_m > 0.0 ? wh / totals.distance_m : 0.0, wh / totals.count);
  }
  return text;
}

// Where the reason's place is on the earth, for those who go and look.
std::string on_earth(const Field& field, const Reason& reason) {
  if (!field.frame.georeferenced || !reason.p_W || !reason.p_W->allFinite()) return "";
  const Eigen::Vector2d lon_lat_deg = wgs84_from_local(field.frame, {*reason.p_W}).front();
  return fmt::format(" [lon {:.6f}, lat {:.6f}]", lon_lat_deg.x(), lon_lat_deg.y());
}

std::string judged_table(const Job& job, const DriveResult& result) {
  std::string text = fmt::format("\n  {:<40}{:>10}{:>20}{:>12}\n", "judged", "", "warns", "fails");
  for (const JudgedFigure& figure :
       judged_figures(result.run, result.metrics, job.scenario.verdict)) {
    text += fmt::format("  {:<40}{:>10}{:>11}{:>9}{:>12}   {}\n", figure.what, figure.value,
                        figure.at_least ? "below" : "above", figure.warn, figure.fail,
                        grade_name(figure.grade));
  }
  return text;
}

std::string verdict_text(const Job& job, const DriveResult& result) {
  const Verdict& verdict = result.verdict;
  std::string text =
      judged_table(job, result) + fmt::format("\nverdict: {}\n", grade_name(verdict.grade));
  for (const Reason& reason : verdict.reasons) {
    text += fmt::format("  {:<5} {}{}\n", grade_name(reason.grade), reason.text,
                        on_earth(job.stage.field, reason));
  }
  return text;
}

}  // namespace

std::string charge_change_text(double delta_soc) {
  const double change_percent = std::round(-1000.0 * delta_soc) / 10.0;
  return fmt::format("{:+.1f} %", change_percent + 0.0);  // + 0.0 turns -0 into 0
}

std::string run_summary(const Job& job, const DriveResult& result) {
  return headline(job) + "\n" + figures(job.stage.vehicle, result) + energy_table(result.run) +
         kind_table(result.metrics) + verdict_text(job, result) + notes_text(result.notes);
}

}  // namespace headland

#include "evaluate/run_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "evaluate/run_tables.h"

namespace headland {
namespace {

struct PlanFigure {
  const char* key;
  double (*value)(const PlanResult&);
};

constexpr PlanFigure kPlanFigures[] = {
    {"plan_passes", [](const PlanResult& r) { return static_cast<double>(r.plan.passes.size()); }},
    {"plan_length_m", [](const PlanResult& r) { return r.plan.planned_length_m; }},
    {"plan_direction_rad", [](const PlanResult& r) { return r.plan.swath_direction_rad; }},
    {"path_length_m", [](const PlanResult& r) { return length_m(r.path); }},
    {"path_violations",
     [](const PlanResult& r) { return static_cast<double>(r.path.violations.size()); }},
    {"path_reversals",
     [](const PlanResult& r) {
       return static_cast<double>(
           std::ranges::count(r.path.segments, Gear::kReverse, &PathSegment::gear));
     }},
};

struct GridFigure {
  const char* key;
  double (*value)(const GridPlan&);
};

constexpr GridFigure kGridFigures[] = {
    {"grid_steps", [](const GridPlan& plan) { return static_cast<double>(plan.counts.steps); }},
    {"grid_repeats", [](const GridPlan& plan) { return static_cast<double>(plan.counts.repeats); }},
    {"grid_turns", [](const GridPlan& plan) { return static_cast<double>(plan.counts.turns); }},
    {"grid_u_turns", [](const GridPlan& plan) { return static_cast<double>(plan.counts.u_turns); }},
    {"grid_level_m", [](const GridPlan& plan) { return plan.counts.level_m; }},
    {"grid_climb_m", [](const GridPlan& plan) { return plan.counts.climb_m; }},
    {"grid_jumps", [](const GridPlan& plan) { return static_cast<double>(plan.jumps); }},
    {"grid_cost", [](const GridPlan& plan) { return plan.cost; }},
    {"grid_iterations", [](const GridPlan& plan) { return static_cast<double>(plan.iterations); }},
    {"grid_evaluations",
     [](const GridPlan& plan) { return static_cast<double>(plan.evaluations); }},
};

struct DriveFigure {
  const char* key;
  double (*value)(const Metrics&, const RunRecord&);
};

constexpr DriveFigure kDriveFigures[] = {
    {"energy_wh", [](const Metrics& m, const RunRecord&) { return m.energy_wh; }},
    {"energy_wh_per_ha", [](const Metrics& m, const RunRecord&) { return m.energy_wh_per_ha; }},
    {"time_s", [](const Metrics& m, const RunRecord&) { return m.time_s; }},
    {"distance_m", [](const Metrics& m, const RunRecord&) { return m.distance_m; }},
    {"delta_soc", [](const Metrics& m, const RunRecord&) { return m.delta_soc; }},
    {"rested_voltage_drop_v",
     [](const Metrics& m, const RunRecord&) { return m.rested_voltage_drop_v; }},
    {"workable_m2", [](const Metrics& m, const RunRecord&) { return m.coverage.workable_m2; }},
    {"covered_m2", [](const Metrics& m, const RunRecord&) { return m.coverage.covered_m2; }},
    {"missed_m2", [](const Metrics& m, const RunRecord&) { return m.coverage.missed_m2; }},
    {"overlap_m2", [](const Metrics& m, const RunRecord&) { return m.coverage.overlap_m2; }},
    {"outside_m2", [](const Metrics& m, const RunRecord&) { return m.coverage.outside_m2; }},
    {"coverage_ratio", [](const Metrics& m, const RunRecord&) { return m.coverage_ratio; }},
    {"overlap_ratio", [](const Metrics& m, const RunRecord&) { return m.overlap_ratio; }},
    {"outside_area_ratio", [](const Metrics& m, const RunRecord&) { return m.outside_area_ratio; }},
    {"turns", [](const Metrics& m, const RunRecord&) { return static_cast<double>(m.turns); }},
    {"u_turns", [](const Metrics& m, const RunRecord&) { return static_cast<double>(m.u_turns); }},
    {"worst_slip", [](const Metrics& m, const RunRecord&) { return m.worst_slip; }},
    {"worst_load_transfer",
     [](const Metrics& m, const RunRecord&) { return m.worst_load_transfer; }},
    {"track_rms_working_m",
     [](const Metrics& m, const RunRecord&) { return m.track_rms_working_m; }},
    {"track_rms_turning_m",
     [](const Metrics& m, const RunRecord&) { return m.track_rms_turning_m; }},
    {"ledger_residual_ratio",
     [](const Metrics& m, const RunRecord&) { return m.ledger_residual_ratio; }},
    {"boundary_overrun_m",
     [](const Metrics&, const RunRecord& r) { return r.peaks.boundary_overrun_m.value; }},
    {"belly_contact_m",
     [](const Metrics&, const RunRecord& r) { return r.peaks.belly_contact_m.value; }},
    {"battery_power_peak_w",
     [](const Metrics&, const RunRecord& r) { return r.peaks.battery_power_w.value; }},
    {"min_voltage_v",
     [](const Metrics&, const RunRecord& r) { return r.peaks.min_voltage_v.value; }},
    {"motor_clipped_s", [](const Metrics&, const RunRecord& r) { return r.peaks.motor_clipped_s; }},
};

// "headland_pass", "u_turn".
std::string kind_key(PathKind kind) {
  std::string key(path_kind_name(kind));
  for (char& letter : key) {
    if (letter == ' ' || letter == '-') letter = '_';
    if (letter == 'U') letter = 'u';
  }
  return key;
}

// "rolling_resistance_wh".
std::string cause_key(EnergyCause cause) {
  const std::string key = energy_key(cause);
  return fmt::format("{}wh", std::string_view(key).substr(0, key.size() - 1));
}

std::vector<std::string> all_keys() {
  std::vector<std::string> keys;
  for (const PlanFigure& figure : kPlanFigures) keys.emplace_back(figure.key);
  for (const PathKind kind : kEveryPathKind) {
    keys.push_back(fmt::format("path_{}_count", kind_key(kind)));
    keys.push_back(fmt::format("path_{}_m", kind_key(kind)));
  }
  for (const GridFigure& figure : kGridFigures) keys.emplace_back(figure.key);
  keys.emplace_back("grid_unworked_ratio");
  keys.emplace_back("predicted_energy_wh");
  for (const PathKind kind : kEveryPathKind) {
    keys.push_back(fmt::format("predicted_{}_wh", kind_key(kind)));
  }
  for (const DriveFigure& figure : kDriveFigures) keys.emplace_back(figure.key);
  for (const PathKind kind : kEveryPathKind) {
    for (const char* part : {"_count", "_m", "_s", "_wh"}) keys.push_back(kind_key(kind) + part);
  }
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    keys.push_back(cause_key(static_cast<EnergyCause>(i)));
  }
  keys.emplace_back(kPlanSeconds);
  keys.emplace_back(kDriveSeconds);
  return keys;
}

// The figures from the one of this key on, which are set in their order.
struct Setter {
  RunFigures& figures;
  std::size_t place;
  void operator()(double value) { figures[place++] = value; }
};

}  // namespace

const std::vector<std::string>& run_figure_keys() {
  static const std::vector<std::string> keys = all_keys();
  return keys;
}

std::size_t run_figure_place(std::string_view key) {
  const auto& keys = run_figure_keys();
  const auto found = std::find(keys.begin(), keys.end(), key);
  assert(found != keys.end());
  return static_cast<std::size_t>(found - keys.begin());
}

RunFigures no_run_figures() {
  return RunFigures(run_figure_keys().size(), std::numeric_limits<double>::quiet_NaN());
}

void set_plan_figures(const PlanResult& planned, RunFigures& figures) {
  Setter set{figures, run_figure_place(kPlanFigures[0].key)};
  for (const PlanFigure& figure : kPlanFigures) set(figure.value(planned));
  for (const PathKind kind : kEveryPathKind) {
    int count = 0;
    int manoeuvre = -1;
    double kind_m = 0.0;
    for (const PathSegment& segment : planned.path.segments) {
      if (segment.kind != kind) continue;
      count += segment.manoeuvre != manoeuvre ? 1 : 0;
      manoeuvre = segment.manoeuvre;
      kind_m += length_m(segment);
    }
    set(count);
    set(kind_m);
  }
  if (planned.grid_plan) {
    for (const GridFigure& figure : kGridFigures) set(figure.value(*planned.grid_plan));
    set(planned.grid_drive->unworked_ratio);
  }
  if (!planned.predicted) return;
  set.place = run_figure_place("predicted_energy_wh");
  set(planned.predicted->energy_wh);
  for (const double wh : planned.predicted->by_kind_wh) set(wh);
}

void set_drive_figures(const Metrics& metrics, const RunRecord& run, RunFigures& figures) {
  Setter set{figures, run_figure_place(kDriveFigures[0].key)};
  for (const DriveFigure& figure : kDriveFigures) set(figure.value(metrics, run));
  for (const KindTotals& totals : metrics.by_kind) {
    set(totals.count);
    set(totals.distance_m);
    set(totals.time_s);
    set(totals.energy.battery_j / kJoulePerWattHour);
  }
  for (const double cause_j : run.energy.cause_j) set(cause_j / kJoulePerWattHour);
}

}  // namespace headland

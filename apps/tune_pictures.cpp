#include "apps/tune_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "apps/interrupt.h"
#include "evaluate/duration_text.h"
#include "evaluate/plan_scenario.h"
#include "render/gnuplot.h"
#include "render/grid_picture.h"
#include "render/tuning_chart.h"

namespace headland {
namespace {

void add_chart(const std::string& name, const std::string& script, int height_px,
               std::vector<FileText>& files) {
  for (const auto& [format, ending] :
       {std::pair{ChartFormat::kSvg, ".svg"}, std::pair{ChartFormat::kPng, ".png"}}) {
    files.push_back({name + ending, chart_of(script, format, kTuningChartWidth_px, height_px)});
  }
}

void add_prediction_chart(const Tuning& tuning, const TuneResult& result,
                          std::vector<FileText>& files) {
  const std::vector<PlanRun> plans = fit_plans(result.held_out_plans);
  if (plans.empty()) return;
  std::vector<PredictionPanel> panels;
  for (const FormReport& report : result.forms) {
    PredictionPanel& panel = panels.emplace_back();
    panel.title = fmt::format("{}: error {:.1f} %", grid_objective_name(report.fit.form),
                              100.0 * report.held_out_fitted.mean_absolute_error);
    for (const PlanRun& plan : plans) {
      panel.driven_predicted_wh.emplace_back(plan.energy_wh, fitted_energy_wh(report.fit, plan));
    }
  }
  add_chart("prediction",
            prediction_chart_script(tuning.name + ": fitted forms on held-out plans", panels),
            kTuningChartHeight_px, files);
}

void add_saving_chart(const Tuning& tuning, const TuneResult& result,
                      std::vector<FileText>& files) {
  std::vector<SavingBar> bars;
  for (const MethodFigures& figures : result.figures) {
    const Saving* saving = energy_saving(figures, methods::kRows);
    if (saving == nullptr || saving->blocks == 0) continue;
    SavingBar& bar = bars.emplace_back(SavingBar{figures.method, 100.0 * saving->ratio.mean, {}});
    if (saving->ratio.ci95) bar.ci95_percent = 100.0 * *saving->ratio.ci95;
  }
  if (bars.empty()) return;
  add_chart("savings",
            saving_chart_script(tuning.name + ": energy saved over boustrophedon, held out", bars),
            kTuningChartHeight_px, files);
}

// What measured costs save over the weights of Wu et al., by block.
std::map<std::string, double> savings_of(const std::vector<PlanRun>& plans) {
  std::map<std::string, std::pair<double, double>> pairs;
  for (const PlanRun& plan : plans) {
    if (!plan.fault.empty()) continue;
    if (plan.method == methods::kMeasured) pairs[plan.block].first = plan.energy_wh;
    if (plan.method == methods::kWu) pairs[plan.block].second = plan.energy_wh;
  }
  std::map<std::string, double> savings;
  for (const auto& [block, wh] : pairs) {
    if (wh.first > 0.0 && wh.second > 0.0) savings[block] = 1.0 - wh.first / wh.second;
  }
  return savings;
}

std::string wh_text(double wh) { return fmt::format("{:.1f} Wh", wh); }

GridFigure figure_of(const PlanRun& run, const PlanResult& planned) {
  GridFigure figure{run.method, {}, planned.grid_plan->cells};
  figure.lines.push_back(fmt::format("{} driven, {} predicted, {}", wh_text(run.energy_wh),
                                     wh_text(run.predicted_wh), duration_text(run.time_s)));
  figure.lines.push_back(fmt::format("{} turns, {} U-turns, {} repeats, {:.1f} % covered",
                                     run.counts.turns, run.counts.u_turns, run.counts.repeats,
                                     100.0 * run.coverage_ratio));
  std::string kinds = "predicted:";
  for (std::size_t i = 0; i < kPredictedKinds; ++i) {
    if (run.predicted_kind_wh[i] <= 0.0) continue;
    kinds += fmt::format(" {} {:.1f},", path_kind_name(static_cast<PathKind>(i)),
                         run.predicted_kind_wh[i]);
  }
  kinds.back() = ' ';
  figure.lines.push_back(kinds + "Wh");
  return figure;
}

void add_plans(const Tuning& tuning, const TuneResult& result, const std::string& block,
               const char* name, const std::string& heading, std::vector<FileText>& files) {
  const Sweep sweep = sweep_by(tuning.held_out, tuning.name + ": held out", result.methods);
  std::vector<GridFigure> figures;
  std::optional<GridMap> map;
  for (const PlanRun& run : result.held_out_plans) {
    if (run.block != block || !run.fault.empty()) continue;
    const Scenario scenario = scenario_at(sweep, run.place);
    const Stage stage = load_stage(scenario);
    figures.push_back(figure_of(run, plan_scenario(scenario, stage, interrupted)));
    map = stage.grid;
  }
  if (map) files.push_back({name, png_of(draw_grid_sheet(*map, heading, figures))});
}

}  // namespace

std::vector<FileText> tune_pictures(const Tuning& tuning, const TuneResult& result) {
  const InterruptAtOnce at_once;
  std::vector<FileText> files;
  add_prediction_chart(tuning, result, files);
  add_saving_chart(tuning, result, files);
  const std::map<std::string, double> savings = savings_of(result.held_out_plans);
  if (savings.empty()) return files;
  const auto [least, most] = std::minmax_element(
      savings.begin(), savings.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  const auto heading = [](const auto& of) {
    return fmt::format("{}: measured costs save {:.1f} % over the weights of Wu et al.", of->first,
                       100.0 * of->second);
  };
  add_plans(tuning, result, most->first, kMostSavedPicture, heading(most), files);
  if (least != most) {
    add_plans(tuning, result, least->first, kLeastSavedPicture, heading(least), files);
  }
  return files;
}

}  // namespace headland

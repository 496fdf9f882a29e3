#include "apps/tune_summary.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/terminal_text.h"
#include "apps/text_table.h"

namespace headland {
namespace {

std::string figure(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string tally_text(const char* what, const RunTally& tally) {
  std::string text = fmt::format("{}: {} runs, {} of them driven now, {} without figures\n", what,
                                 tally.runs, tally.driven_now, tally.faults);
  for (const std::string& why : tally.why) text += "  " + terminal_text(why) + "\n";
  const std::size_t more = static_cast<std::size_t>(tally.faults) - tally.why.size();
  if (more > 0) text += fmt::format("  and {} more\n", more);
  return text;
}

std::string terms_table(const TuneResult& result) {
  std::vector<Row> rows = {{"form", "term", "fitted", "95 % from", "to"}};
  for (const FormReport& report : result.forms) {
    for (const FittedTerm& term : report.fit.terms) {
      rows.push_back({std::string(grid_objective_name(report.fit.form)), term.name,
                      fmt::format("{:.4g}", term.coefficient),
                      fmt::format("{:.4g}", term.interval.low),
                      fmt::format("{:.4g}", term.interval.high)});
    }
  }
  return aligned(rows);
}

Row prediction_row(const FormReport& report, const char* weights, const Prediction& training,
                   const Prediction& held_out) {
  Row row = {fmt::format("{}, {}", grid_objective_name(report.fit.form), weights)};
  for (const Prediction* prediction : {&training, &held_out}) {
    row.push_back(figure(prediction->r2, "{:.3f}"));
    row.push_back(figure(prediction->spearman, "{:.3f}"));
    row.push_back(figure(prediction->spearman_in_block, "{:.3f}"));
    row.push_back(figure(100.0 * prediction->mean_absolute_error, "{:.2f}"));
  }
  return row;
}

std::string prediction_table(const TuneResult& result) {
  std::vector<Row> rows = {{"energy told by", "R2", "Spearman", "in block", "error %",
                            "held out R2", "Spearman", "in block", "error %"}};
  for (const FormReport& report : result.forms) {
    rows.push_back(
        prediction_row(report, "printed", report.training_printed, report.held_out_printed));
    rows.push_back(
        prediction_row(report, "fitted", report.training_fitted, report.held_out_fitted));
    if (!report.adapted) continue;
    rows.push_back(
        prediction_row(report, "adapted", report.training_adapted, report.held_out_adapted));
  }
  return aligned(rows);
}

std::string saving_text(const MethodFigures& figures, std::string_view reference) {
  const Saving* saving = energy_saving(figures, reference);
  if (saving == nullptr || saving->blocks == 0) return "";
  const std::optional<double>& ci95 = saving->ratio.ci95;
  return fmt::format("{:+.1f} ±{} p {:.2g}", 100.0 * saving->ratio.mean,
                     ci95 ? fmt::format("{:.1f}", 100.0 * *ci95) : "-", saving->test.p);
}

std::string methods_table(const TuneResult& result) {
  std::vector<Row> rows = {{"held-out fields", "driven", "Wh", "Wh/ha", "min", "dSOC %", "cover %",
                            "saves % over rows", "over Wu et al.", "over Wang et al."}};
  for (const MethodFigures& figures : result.figures) {
    rows.push_back(
        {figures.method, fmt::format("{}/{}", figures.runs - figures.faults, figures.runs),
         figure(figures.mean.energy_wh, "{:.1f}"), figure(figures.mean.energy_wh_per_ha, "{:.0f}"),
         figure(figures.mean.time_s / 60.0, "{:.1f}"),
         figure(100.0 * figures.mean.delta_soc, "{:.2f}"),
         figure(100.0 * figures.mean.coverage_ratio, "{:.1f}"),
         saving_text(figures, methods::kRows), saving_text(figures, methods::kWu),
         saving_text(figures, methods::kWang)});
  }
  return aligned(rows);
}

std::string control_text(const TuningControl& control) {
  if (control.fits == 0) return "";
  return fmt::format(
      "control: of {} fits to shuffled energies {} came to no weights, {} to plans as good as "
      "those of {}, p {:.2g}\n",
      control.fits, control.without_weights, control.as_good, control.fitted, control.p);
}

}  // namespace

std::string tune_summary(const Tuning& tuning, const TuneResult& result) {
  std::string text = fmt::format("{}: weights of {}\n", tuning.name, tuning.planner.name) +
                     tally_text("training", result.training);
  if (result.search.runs > 0) text += tally_text("search", result.search);
  text += tally_text("held out", result.held_out) + "\n" + terms_table(result) + "\n" +
          prediction_table(result) + "\n" + methods_table(result) + control_text(result.control);
  for (const std::string& note : result.notes) text += terminal_text(note) + "\n";
  return text;
}

}  // namespace headland

#include "evaluate/tuning_file.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "evaluate/tuned_weights.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json tally_json(const RunTally& tally) {
  return {{"runs", tally.runs}, {"without_figures", tally.faults}, {"why", tally.why}};
}

Json prediction_json(const Prediction& prediction) {
  return {{"plans", prediction.plans},
          {"r2", number(prediction.r2)},
          {"spearman", number(prediction.spearman)},
          {"spearman_in_block", number(prediction.spearman_in_block)},
          {"mean_absolute_error", number(prediction.mean_absolute_error)}};
}

Json form_json(const FormReport& report) {
  Json json;
  json["form"] = grid_objective_name(report.fit.form);
  json["plans"] = report.fit.plans;
  for (const FittedTerm& term : report.fit.terms) {
    json["terms"].push_back({{"name", term.name},
                             {"coefficient_wh", term.coefficient},
                             {"low_wh", term.interval.low},
                             {"high_wh", term.interval.high}});
  }
  json["training"] = {{"printed", prediction_json(report.training_printed)},
                      {"fitted", prediction_json(report.training_fitted)}};
  json["held_out"] = {{"printed", prediction_json(report.held_out_printed)},
                      {"fitted", prediction_json(report.held_out_fitted)}};
  if (report.adapted) {
    json["training"]["adapted"] = prediction_json(report.training_adapted);
    json["held_out"]["adapted"] = prediction_json(report.held_out_adapted);
  }
  if (!report.search) return json;
  json["search"] = {{"weights", report.search->weights},
                    {"loss", report.search->loss},
                    {"evaluations", report.search->evaluations},
                    {"least_so_far", report.search->least_so_far}};
  return json;
}

Json saving_json(const Saving& saving) {
  const std::optional<double>& ci95 = saving.ratio.ci95;
  return {{"quantity", saving.quantity},
          {"blocks", saving.blocks},
          {"mean_ratio", number(saving.ratio.mean)},
          {"ci95_ratio", ci95 ? Json(*ci95) : Json(nullptr)},
          {"wins", saving.test.wins},
          {"losses", saving.test.losses},
          {"ties", saving.test.ties},
          {"p", saving.test.p},
          {"least_p", saving.test.least_p}};
}

Json figures_json(const MethodFigures& figures) {
  Json json;
  json["method"] = figures.method;
  json["runs"] = figures.runs;
  json["without_figures"] = figures.faults;
  if (figures.faults > 0) json["why"] = figures.first_fault;
  for (const SavedQuantity& quantity : saved_quantities()) {
    json["mean"][std::string(quantity.key)] = number(figures.mean.*quantity.value);
  }
  json["mean"]["coverage_ratio"] = number(figures.mean.coverage_ratio);
  for (const MethodSavings& over : figures.over) {
    Json savings = Json::array();
    for (const Saving& saving : over.savings) savings.push_back(saving_json(saving));
    json["saves_over"][over.reference] = savings;
  }
  return json;
}

Json control_json(const TuningControl& control) {
  if (control.fits == 0) return nullptr;
  return {{"fitted", control.fitted},
          {"fits", control.fits},
          {"without_weights", control.without_weights},
          {"as_good", control.as_good},
          {"p", control.p}};
}

Json plan_json(const PlanRun& plan, const std::vector<FormReport>& forms) {
  Json json = {{"block", plan.block}, {"method", plan.method}};
  if (!plan.fault.empty()) {
    json["why_not"] = plan.fault;
    return json;
  }
  json["energy_wh"] = plan.energy_wh;
  json["predicted_wh"] = number(plan.predicted_wh);
  for (std::size_t i = 0; i < kPredictedKinds; ++i) {
    json["predicted_kind_wh"][std::string(path_kind_name(static_cast<PathKind>(i)))] =
        number(plan.predicted_kind_wh[i]);
  }
  // Moves that nothing counts: fits leave such plans out.
  for (const FormReport& report : forms) {
    json["fitted_wh"][std::string(grid_objective_name(report.fit.form))] =
        plan.jumps ? Json(nullptr) : number(fitted_energy_wh(report.fit, plan));
  }
  json["time_s"] = plan.time_s;
  json["coverage_ratio"] = plan.coverage_ratio;
  json["repeats"] = plan.counts.repeats;
  json["turns"] = plan.counts.turns;
  json["u_turns"] = plan.counts.u_turns;
  return json;
}

}  // namespace

Json tuning_json(const Tuning& tuning, const TuneResult& result, std::string_view version) {
  Json json;
  json["headland"] = version;
  json["name"] = tuning.name;
  json["seed"] = tuning.seed;
  json["planner"] = tuning.planner.name;
  // A vehicle of one's own is told by its folder.
  json["vehicle"] = std::filesystem::path(tuning.training.scenarios.front().vehicle).filename();
  json["training"] = tally_json(result.training);
  json["search"] = tally_json(result.search);
  json["held_out"] = tally_json(result.held_out);
  json["notes"] = result.notes;
  json["forms"] = Json::array();
  for (const FormReport& report : result.forms) json["forms"].push_back(form_json(report));
  json["best"] = result.best_label;
  json["methods"] = Json::array();
  for (const MethodFigures& figures : result.figures) {
    json["methods"].push_back(figures_json(figures));
  }
  json["control"] = control_json(result.control);
  json["held_out_plans"] = Json::array();
  for (const PlanRun& plan : result.held_out_plans) {
    json["held_out_plans"].push_back(plan_json(plan, result.forms));
  }
  json["pictures"] = Json::array();
  return json;
}

std::string tuned_weights_yaml(const Tuning& tuning, const TuneResult& result) {
  if (result.best_label.empty()) return "";
  return weights_yaml(result.best,
                      fmt::format("{}: {}\nheadland plan SCENARIO.yaml --weights THIS_FILE -o DIR",
                                  tuning.name, result.best_label));
}

}  // namespace headland

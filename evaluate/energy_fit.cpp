#include "evaluate/energy_fit.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "evaluate/rank_tests.h"
#include "planner/seeded_random.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double cells_of(const PlanRun& plan) { return plan.counts.distinct_cells; }

// Terms and energy a free cell.
struct Rows {
  Eigen::MatrixXd terms;
  Eigen::VectorXd wh;
  std::vector<int> block;
};

Rows rows_of(GridObjective form, const std::vector<PlanRun>& plans) {
  const auto count = static_cast<Eigen::Index>(plans.size());
  Rows rows{
      {count, static_cast<Eigen::Index>(energy_terms(form).size())}, Eigen::VectorXd(count), {}};
  std::map<std::string, int> blocks;
  for (Eigen::Index i = 0; i < count; ++i) {
    const PlanRun& plan = plans[static_cast<std::size_t>(i)];
    const std::vector<double> terms = energy_terms_of(form, plan);
    rows.terms.row(i) =
        Eigen::Map<const Eigen::RowVectorXd>(terms.data(), rows.terms.cols()) / cells_of(plan);
    rows.wh(i) = plan.energy_wh / cells_of(plan);
    rows.block.push_back(
        blocks.try_emplace(plan.block, static_cast<int>(blocks.size())).first->second);
  }
  return rows;
}

// Columns that are to be fitted.
std::vector<Eigen::Index> fitted_columns(GridObjective form, const Eigen::MatrixXd& terms) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index i = 0; i < terms.cols(); ++i) {
    if (form != GridObjective::kMeasured || terms.col(i).norm() > 0.0) columns.push_back(i);
  }
  return columns;
}

void refuse_unfittable(GridObjective form, const Eigen::MatrixXd& terms,
                       const std::vector<std::string>& names, const std::string& source,
                       const std::string& place) {
  if (terms.rows() < terms.cols()) {
    throw InputError(source, place, fmt::format("{} plans", terms.rows()),
                     fmt::format("at least {} are needed to fit {}: {}", terms.cols(),
                                 grid_objective_name(form), fmt::join(names, ", ")));
  }
  std::vector<std::string> alike;
  for (const Eigen::Index i : collinear_terms(terms)) {
    alike.push_back(names[static_cast<std::size_t>(i)]);
  }
  if (alike.empty()) return;
  const bool never =
      terms.col(std::find(names.begin(), names.end(), alike.front()) - names.begin()).norm() == 0.0;
  throw InputError(
      source, place, fmt::format("{}", fmt::join(alike, ", ")),
      fmt::format(
          "{0}, so that {1} cannot be fitted; other fields, terrains or plans help, or leave "
          "{1} out of forms",
          never ? "in no training plan" : "not told apart by the training plans",
          grid_objective_name(form)));
}

void fit_printed(const std::vector<PlanRun>& plans, const Rows& rows, EnergyFit& fit) {
  if (fit.form == GridObjective::kMeasured) return;
  const bool base = fit.form == GridObjective::kWeighted;
  Eigen::MatrixXd terms(rows.wh.size(), base ? 2 : 1);
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const PlanRun& plan = plans[static_cast<std::size_t>(i)];
    terms(i, 0) = printed_cost_of(fit.form, plan) / cells_of(plan);
    if (base) terms(i, 1) = 1.0;
  }
  const Eigen::VectorXd printed = nonnegative_fit(terms, rows.wh);
  fit.printed_scale = printed(0);
  if (base) fit.printed_cell_wh = printed(1);
}

}  // namespace

std::vector<PlanRun> fit_plans(const std::vector<PlanRun>& plans) {
  std::vector<PlanRun> fit;
  std::copy_if(plans.begin(), plans.end(), std::back_inserter(fit), [](const PlanRun& plan) {
    return plan.fault.empty() && !plan.jumps && std::isfinite(plan.predicted_wh);
  });
  return fit;
}

void check_fittable(GridObjective form, const std::vector<PlanRun>& plans,
                    const std::string& source, const std::string& place) {
  const Rows rows = rows_of(form, plans);
  const std::vector<std::string> all = energy_terms(form);
  std::vector<std::string> names;
  const std::vector<Eigen::Index> columns = fitted_columns(form, rows.terms);
  names.reserve(columns.size());
  for (const Eigen::Index i : columns) names.push_back(all[static_cast<std::size_t>(i)]);
  refuse_unfittable(form, rows.terms(Eigen::all, columns), names, source, place);
}

EnergyFit fit_energy(GridObjective form, const std::vector<PlanRun>& plans, int bootstrap_draws,
                     std::uint64_t seed, const std::string& source, const std::string& place) {
  check_fittable(form, plans, source, place);
  const Rows rows = rows_of(form, plans);
  const std::vector<Eigen::Index> columns = fitted_columns(form, rows.terms);
  const Eigen::MatrixXd terms = rows.terms(Eigen::all, columns);
  EnergyFit fit;
  fit.form = form;
  fit.plans = static_cast<int>(plans.size());
  for (const std::string& name : energy_terms(form)) fit.terms.push_back({name, 1.0, {1.0, 1.0}});
  const Eigen::VectorXd coefficients = nonnegative_fit(terms, rows.wh);
  const std::vector<Interval> intervals =
      bootstrap_intervals(terms, rows.wh, rows.block, bootstrap_draws, seed);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    FittedTerm& term = fit.terms[static_cast<std::size_t>(columns[i])];
    term.coefficient = coefficients(static_cast<Eigen::Index>(i));
    term.interval = intervals[i];
  }
  fit_printed(plans, rows, fit);
  return fit;
}

double fitted_energy_wh(const EnergyFit& fit, const PlanRun& plan) {
  const std::vector<double> terms = energy_terms_of(fit.form, plan);
  double wh = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) wh += fit.terms[i].coefficient * terms[i];
  return wh;
}

double printed_energy_wh(const EnergyFit& fit, const PlanRun& plan) {
  return fit.printed_scale * printed_cost_of(fit.form, plan) + fit.printed_cell_wh * cells_of(plan);
}

Prediction prediction_of(const std::vector<PlanRun>& plans,
                         const std::vector<double>& predicted_wh) {
  Prediction prediction{static_cast<int>(plans.size()), kUnknown, kUnknown, kUnknown, kUnknown};
  if (plans.empty()) return prediction;
  std::vector<double> driven;
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> blocks;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    driven.push_back(plans[i].energy_wh);
    auto& [predicted_in, driven_in] = blocks[plans[i].block];
    predicted_in.push_back(predicted_wh[i]);
    driven_in.push_back(plans[i].energy_wh);
  }
  const Eigen::Map<const Eigen::ArrayXd> y(driven.data(), static_cast<Eigen::Index>(driven.size()));
  const Eigen::Map<const Eigen::ArrayXd> x(predicted_wh.data(), y.size());
  const double total = (y - y.mean()).square().sum();
  if (total > 0.0) prediction.r2 = 1.0 - (x - y).square().sum() / total;
  prediction.mean_absolute_error = (x / y - 1.0).abs().mean();
  prediction.spearman = spearman(predicted_wh, driven);
  double sum = 0.0;
  int counted = 0;
  for (const auto& [block, pairs] : blocks) {
    const double within = spearman(pairs.first, pairs.second);
    if (!std::isfinite(within)) continue;
    sum += within;
    ++counted;
  }
  if (counted > 0) prediction.spearman_in_block = sum / counted;
  return prediction;
}

std::optional<GridCost> fitted_cost(const EnergyFit& fit) {
  GridCost cost;
  cost.objective = fit.form;
  std::vector<double*> weights;
  if (fit.form == GridObjective::kWeighted) {
    weights = {nullptr, &cost.weights.repeat, &cost.weights.turn, &cost.weights.u_turn};
  } else if (fit.form == GridObjective::kTractor) {
    weights = {&cost.tractor.length_weight, &cost.tractor.height_weight, &cost.tractor.turn_weight};
  } else {
    return std::nullopt;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == nullptr) continue;
    *weights[i] = fit.terms[i].coefficient;
    sum += *weights[i];
  }
  if (sum > 0.0) return cost;
  return std::nullopt;
}

std::vector<PlanRun> with_shuffled_energies(std::vector<PlanRun> plans, std::uint64_t seed) {
  std::map<std::string, std::vector<std::size_t>> blocks;
  for (std::size_t i = 0; i < plans.size(); ++i) blocks[plans[i].block].push_back(i);
  SeededRandom random(seed);
  for (const auto& [block, places] : blocks) {
    std::vector<double> energies;
    for (const std::size_t place : places) energies.push_back(plans[place].energy_wh);
    shuffle(random, energies, 0, static_cast<int>(energies.size()));
    for (std::size_t i = 0; i < places.size(); ++i) plans[places[i]].energy_wh = energies[i];
  }
  return plans;
}

}  // namespace headland

#include "evaluate/adapted_weights.h"

#include <algorithm>
#include <map>

#include "evaluate/nonnegative_fit.h"
#include "planner/genetic_operators.h"

namespace headland {
namespace {

Three counted(const PlanRun& plan) {
  return {1.0 * plan.counts.repeats, 1.0 * plan.counts.turns, 1.0 * plan.counts.u_turns};
}

std::map<std::string, Three> mean_counts(const std::vector<PlanRun>& plans) {
  std::map<std::string, Three> means;
  std::map<std::string, double> sizes;
  for (const PlanRun& plan : plans) ++sizes[plan.block];
  for (const PlanRun& plan : plans) {
    const Three own = counted(plan);
    Three& mean = means.try_emplace(plan.block, Three{}).first->second;
    for (std::size_t i = 0; i < own.size(); ++i) mean[i] += own[i] / sizes[plan.block];
  }
  return means;
}

}  // namespace

std::vector<double> adapted_costs(const std::vector<PlanRun>& plans) {
  const std::map<std::string, Three> means = mean_counts(plans);
  std::vector<double> costs;
  for (const PlanRun& plan : plans) {
    const GridCost printed;
    Three weights = {printed.weights.repeat, printed.weights.turn, printed.weights.u_turn};
    const Three own = counted(plan);
    adapt_weights(means.at(plan.block), own, weights);
    double cost = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) cost += weights[i] * own[i];
    costs.push_back(cost);
  }
  return costs;
}

AdaptedFit fit_adapted(const std::vector<PlanRun>& plans) {
  const std::vector<double> costs = adapted_costs(plans);
  const auto rows = static_cast<Eigen::Index>(plans.size());
  Eigen::MatrixXd terms(rows, 2);
  Eigen::VectorXd wh(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const PlanRun& plan = plans[static_cast<std::size_t>(i)];
    // A free cell, as all forms are fitted.
    const double cells = plan.counts.distinct_cells;
    terms.row(i) << costs[static_cast<std::size_t>(i)] / cells, 1.0;
    wh(i) = plan.energy_wh / cells;
  }
  const Eigen::VectorXd fitted = nonnegative_fit(terms, wh);
  return {fitted(0), fitted(1)};
}

std::vector<double> adapted_energies_wh(const AdaptedFit& fit, const std::vector<PlanRun>& plans) {
  const std::vector<double> costs = adapted_costs(plans);
  std::vector<double> wh;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    wh.push_back(fit.scale * costs[i] + fit.cell_wh * plans[i].counts.distinct_cells);
  }
  return wh;
}

}  // namespace headland

#include "evaluate/method_savings.h"

#include <algorithm>
#include <limits>
#include <map>

namespace headland {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using ByBlock = std::map<std::string, const PlanRun*>;

Saving saving_of(const SavedQuantity& quantity, const ByBlock& method, const ByBlock& reference) {
  Saving saving;
  saving.quantity = quantity.key;
  std::vector<double> ratios;
  std::vector<double> first;
  std::vector<double> second;
  for (const auto& [block, plan] : method) {
    const auto other = reference.find(block);
    if (other == reference.end()) continue;
    first.push_back(plan->*quantity.value);
    second.push_back(other->second->*quantity.value);
    ratios.push_back(1.0 - first.back() / second.back());
  }
  saving.blocks = static_cast<int>(ratios.size());
  if (ratios.empty()) {
    saving.ratio.mean = kUnknown;
    return saving;
  }
  saving.ratio = estimate_of(ratios);
  saving.test = wilcoxon_test(first, second);
  return saving;
}

void add_to_mean(const PlanRun& plan, MethodFigures& figures) {
  const double n = figures.runs - figures.faults;
  const auto add = [&](double& mean, double value) { mean += (value - mean) / n; };
  for (const SavedQuantity& quantity : saved_quantities()) {
    add(figures.mean.*quantity.value, plan.*quantity.value);
  }
  add(figures.mean.coverage_ratio, plan.coverage_ratio);
}

void forget_mean(MethodFigures& figures) {
  for (const SavedQuantity& quantity : saved_quantities()) {
    figures.mean.*quantity.value = kUnknown;
  }
  figures.mean.coverage_ratio = kUnknown;
}

}  // namespace

const std::vector<SavedQuantity>& saved_quantities() {
  static const std::vector<SavedQuantity> quantities = {
      {"energy_wh", &PlanRun::energy_wh},
      {"energy_wh_per_ha", &PlanRun::energy_wh_per_ha},
      {"time_s", &PlanRun::time_s},
      {"delta_soc", &PlanRun::delta_soc}};
  return quantities;
}

std::vector<MethodFigures> method_figures(const std::vector<PlanRun>& plans,
                                          const std::vector<std::string>& references) {
  std::vector<MethodFigures> all;
  std::map<std::string, ByBlock> driven;
  for (const PlanRun& plan : plans) {
    auto found = std::find_if(all.begin(), all.end(), [&](const MethodFigures& figures) {
      return figures.method == plan.method;
    });
    if (found == all.end()) {
      all.emplace_back().method = plan.method;
      found = std::prev(all.end());
    }
    ++found->runs;
    if (plan.fault.empty()) {
      driven[plan.method][plan.block] = &plan;
      add_to_mean(plan, *found);
      continue;
    }
    if (found->faults++ == 0) found->first_fault = plan.block + ": " + plan.fault;
  }
  for (MethodFigures& figures : all) {
    if (figures.runs == figures.faults) forget_mean(figures);
    for (const std::string& reference : references) {
      if (reference == figures.method || !driven.contains(reference)) continue;
      MethodSavings& over = figures.over.emplace_back();
      over.reference = reference;
      for (const SavedQuantity& quantity : saved_quantities()) {
        over.savings.push_back(saving_of(quantity, driven[figures.method], driven[reference]));
      }
    }
  }
  return all;
}

const Saving* energy_saving(const MethodFigures& figures, std::string_view reference) {
  for (const MethodSavings& over : figures.over) {
    if (over.reference == reference) return &over.savings.front();
  }
  return nullptr;
}

}  // namespace headland

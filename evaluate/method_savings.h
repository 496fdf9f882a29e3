// What plans by several methods took on the same fields, and what one method saves over another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evaluate/cost_table.h"
#include "evaluate/plan_runs.h"
#include "evaluate/rank_tests.h"

namespace headland {

// What is compared of a drive. Less is better.
struct SavedQuantity {
  std::string_view key;
  double PlanRun::*value;
};
const std::vector<SavedQuantity>& saved_quantities();  // the energy first

// Of the blocks where both methods were driven to the end: 1 - method / reference, 0.1 for a tenth
// less, NaN without such blocks. `test` is on the quantity itself, two-sided.
struct Saving {
  std::string_view quantity;
  int blocks = 0;
  Estimate ratio;
  WilcoxonTest test;
};

struct MethodSavings {
  std::string reference;
  std::vector<Saving> savings;  // by quantity
};

struct MethodFigures {
  std::string method;
  int runs = 0;
  int faults = 0;           // not driven to the end
  std::string first_fault;  // why
  PlanRun mean;             // of those that were; NaN without one
  std::vector<MethodSavings> over;
};

// In the methods' order of `plans`; the methods named `references` are what others save over.
std::vector<MethodFigures> method_figures(const std::vector<PlanRun>& plans,
                                          const std::vector<std::string>& references);

// The saving of energy over a reference; null when there is none of that name.
const Saving* energy_saving(const MethodFigures& figures, std::string_view reference);

}  // namespace headland

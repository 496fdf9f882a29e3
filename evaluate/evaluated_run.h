// One run from its scenario to its figures, with nothing on disk.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evaluate/run_figures.h"
#include "evaluate/scenario.h"
#include "evaluate/verdict.h"
#include "planner/cancel.h"

namespace headland {

enum class RunEnd {
  kDriven,
  kNoPlan,  // PlanInfeasible
  kRefused  // InputError: what the scenario describes does not fit together
};
std::string_view run_end_name(RunEnd end);  // "driven", "no plan", "refused"

struct EvaluatedRun {
  RunEnd end = RunEnd::kDriven;
  std::string reason;  // why there is no drive, one line
  Outcome outcome = Outcome::kFinished;
  std::string outcome_detail;
  Grade verdict = Grade::kFail;
  RunFigures figures = no_run_figures();
};

// The plan of scenarios that differ in nothing but soil, simulation, positioning, coverage and
// verdict, none of which planners know of: made by the first, driven by all.
struct SharedPlan {
  std::optional<PlanResult> made;
  double seconds = 0.0;  // it took, with reading field and terrain
};

// Reads what the scenario describes, plans it unless `plan` is made, drives the plan and measures
// the drive. nullopt when it was cancelled.
std::optional<EvaluatedRun> evaluate_run(const Scenario& scenario, SharedPlan& plan,
                                         const CancelAsked& cancelled);

}  // namespace headland

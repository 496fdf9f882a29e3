// Running a tuning: drives, fits, searches and proves.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/adapted_weights.h"
#include "evaluate/energy_fit.h"
#include "evaluate/method_savings.h"
#include "evaluate/tuning.h"
#include "evaluate/tuning_control.h"
#include "evaluate/weight_search.h"

namespace headland {

// The labels of the methods on held-out fields.
namespace methods {
inline constexpr std::string_view kRows = "boustrophedon";
inline constexpr std::string_view kLength = "length";
inline constexpr std::string_view kWu = "Wu et al. weights";
inline constexpr std::string_view kWang = "Wang et al. weights";
inline constexpr std::string_view kMeasured = "measured costs";
inline constexpr std::string_view kShuffled =
    "shuffled";  // all of the control; one: and its number
}  // namespace methods

// One form: its fit, and what it tells of training and held-out plans by printed and by fitted
// weights.
struct FormReport {
  EnergyFit fit;
  Prediction training_printed;
  Prediction training_fitted;
  Prediction held_out_printed;
  Prediction held_out_fitted;
  // Of `weighted`, by printed weights adapted to each plan (adapted_weights.h).
  std::optional<AdaptedFit> adapted;
  Prediction training_adapted;
  Prediction held_out_adapted;
  std::optional<WeightSearch> search;
};

// Runs of a kind: how many, and how many of them came to no figures.
struct RunTally {
  int runs = 0;
  int faults = 0;
  int driven_now = 0;            // the others were in the store
  std::vector<std::string> why;  // the first few
};

struct TuneResult {
  RunTally training;
  RunTally search;
  RunTally held_out;
  std::vector<FormReport> forms;
  std::vector<std::string> notes;       // what was left out, and why
  std::vector<PlanRun> training_plans;  // with figures that can be fitted
  std::vector<PlanRun> held_out_plans;  // without those of the control
  std::vector<TunedMethod> methods;     // on held-out fields
  std::vector<MethodFigures> figures;   // by method, the control's fits as one, last
  TuningControl control;
  GridCost best;  // the tuned weights that did best on training fields
  std::string best_label;
};

struct TuneOptions {
  int jobs = 1;
  std::function<void(std::string_view what, int done, int all)> progress;
  CancelAsked cancelled;
};

// Whether the forms can be fitted to the training plans, found out by planning alone, which takes
// little beside driving. Throws InputError for measured costs that cannot be read and as
// check_fittable; Cancelled.
void check_design(const Tuning& tuning, const TuneOptions& options);

// `store` holds every run when it returns or throws: Cancelled after an early end, InputError as
// run_sweep and check_design, std::runtime_error for runs that failed by a fault of the program.
TuneResult run_tuning(const Tuning& tuning, RunStore& store, const TuneOptions& options);

// What a run without figures counts in the search, where plans around the field's mean count 1.
inline constexpr double kFaultLoss = 2.0;

}  // namespace headland

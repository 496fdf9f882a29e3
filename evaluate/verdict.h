// Go or no-go: thresholds, and the reasons with value, limit, place and time.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace headland {

struct Metrics;
struct RunRecord;
struct Path;

// A figure is fine up to `warn`, a warning up to `fail`, a failure beyond. For figures where more
// is better (coverage, reserve) the order is reversed: fine down to `warn`.
struct Threshold {
  double warn = 0.0;
  double fail = 0.0;
};

// Sources: docs/verdict.md; every number can be set in the
// scenario.
struct VerdictLimits {
  Threshold coverage_ratio_min{0.98, 0.95};
  Threshold overlap_ratio_max{0.15, 0.30};
  Threshold outside_area_ratio_max{0.005, 0.02};
  Threshold slip_max{0.20, 0.30};  // sustained
  Threshold load_transfer_max{0.6, 0.9};
  Threshold track_rms_working_m_max{0.05, 0.15};
  Threshold track_error_m_max{0.30, 1.0};  // worst, implement down
  Threshold boundary_overrun_m_max{0.05, 0.5};
  Threshold belly_contact_m_max{0.0, 0.05};
  Threshold reserve_soc_min{0.20, 0.10};
  Threshold ledger_residual_ratio_max{0.001, 0.01};
};

enum class Grade { kPass, kWarn, kFail };

struct Reason {
  Grade grade = Grade::kPass;
  std::string figure;  // key of the limit, "outcome" or "path"
  double value = 0.0;  // 0 for the outcome, the number of violations for the path
  double limit = 0.0;  // the one that was passed
  std::optional<Eigen::Vector2d> p_W;
  std::optional<double> time_s;
  std::string title;  // the figure's name: "Wheel slip"
  std::string text;   // one sentence for people
};

struct Verdict {
  Grade grade = Grade::kPass;
  std::vector<Reason> reasons;  // worst first; empty when all is well
};

// Compares every figure with its limit. A run that did not finish fails, whatever its figures; a
// figure that is not a number fails; a path with recorded violations warns.
Verdict judge(const Path& path, const RunRecord& run, const Metrics& metrics,
              const VerdictLimits& limits);

// Every figure that judge() compares with a limit, in words, whatever came of it.
struct JudgedFigure {
  Grade grade = Grade::kPass;
  std::string what;   // "Wheel slip"
  std::string value;  // with unit
  std::string warn;   // limits, likewise
  std::string fail;
  bool at_least = false;  // the limits are lower ones
};
std::vector<JudgedFigure> judged_figures(const RunRecord& run, const Metrics& metrics,
                                         const VerdictLimits& limits);

std::string_view grade_name(Grade grade);

}  // namespace headland

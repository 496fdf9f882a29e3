#include "evaluate/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluate/duration_text.h"
#include "evaluate/metrics.h"
#include "planner/path.h"
#include "sim/run_record.h"

namespace headland {
namespace {

enum class Better { kLess, kMore };
enum class Unit { kRatio, kPercent, kMetre };

// One figure against its limit, and the words around it.
struct Check {
  std::string_view key;
  Better better;
  Unit unit;
  Threshold limit;
  double value;
  std::optional<Peak> peak;  // where and when the value was reached
  std::string_view subject;
  std::string consequence;
};

std::string with_unit(double value, Unit unit, int more_digits) {
  switch (unit) {
    case Unit::kRatio:
      return fmt::format("{:.{}f}", value, 2 + more_digits);
    case Unit::kPercent:
      return fmt::format("{:.{}f} %", 100.0 * value, 1 + more_digits);
    case Unit::kMetre:
      return fmt::format("{:.{}f} m", value, 2 + more_digits);
  }
  return "";
}

// Digits after which a value just past its limit no longer reads like the limit itself.
int telling_digits(double value, double limit, Unit unit) {
  constexpr int kMostDigits = 6;
  int digits = 0;
  while (digits < kMostDigits && with_unit(value, unit, digits) == with_unit(limit, unit, digits)) {
    ++digits;
  }
  return digits;
}

Grade grade_of(double value, const Threshold& limit, Better better) {
  if (!std::isfinite(value)) return Grade::kFail;
  const auto beyond = [&](double bound) {
    return better == Better::kLess ? value > bound : value < bound;
  };
  if (beyond(limit.fail)) return Grade::kFail;
  return beyond(limit.warn) ? Grade::kWarn : Grade::kPass;
}

Reason reason_of(const Check& check) {
  Reason reason;
  reason.grade = grade_of(check.value, check.limit, check.better);
  reason.figure = check.key;
  reason.title = check.subject;
  reason.value = check.value;
  reason.limit = reason.grade == Grade::kFail ? check.limit.fail : check.limit.warn;
  if (!std::isfinite(check.value)) {
    reason.text = fmt::format("{} could not be measured: it is not a finite number", check.subject);
    return reason;
  }
  std::string place;
  if (check.peak) {
    reason.p_W = check.peak->p_W;
    reason.time_s = check.peak->time_s;
    place = fmt::format(" at x {:.1f} m, y {:.1f} m after {}", check.peak->p_W.x(),
                        check.peak->p_W.y(), duration_text(check.peak->time_s));
  }
  const int digits = telling_digits(check.value, reason.limit, check.unit);
  reason.text = fmt::format("{} {} {} (limit {}){}: {}", check.subject,
                            check.better == Better::kLess ? "reached" : "was only",
                            with_unit(check.value, check.unit, digits),
                            with_unit(reason.limit, check.unit, digits), place, check.consequence);
  return reason;
}

std::vector<Check> checks(const RunRecord& run, const Metrics& metrics,
                          const VerdictLimits& limits) {
  const Peaks& peaks = run.peaks;
  const auto magnitude = [](const Peak& peak) { return std::abs(peak.value); };
  return {
      {"coverage_ratio_min", Better::kMore, Unit::kPercent, limits.coverage_ratio_min,
       metrics.coverage_ratio, std::nullopt, "Coverage",
       fmt::format("{:.0f} m2 were not worked", metrics.coverage.missed_m2)},
      {"overlap_ratio_max", Better::kLess, Unit::kPercent, limits.overlap_ratio_max,
       metrics.overlap_ratio, std::nullopt, "Overlap",
       fmt::format("{:.0f} m2 were worked again", metrics.coverage.overlap_m2)},
      {"outside_area_ratio_max", Better::kLess, Unit::kPercent, limits.outside_area_ratio_max,
       metrics.outside_area_ratio, std::nullopt, "Area worked outside the field",
       fmt::format("{:.0f} m2 lie beyond the boundary, in a hole or on an obstacle",
                   metrics.coverage.outside_m2)},
      {"slip_max", Better::kLess, Unit::kRatio, limits.slip_max, magnitude(peaks.slip), peaks.slip,
       "Wheel slip", "the tyres are near the end of their grip and churn the soil"},
      {"load_transfer_max", Better::kLess, Unit::kRatio, limits.load_transfer_max,
       magnitude(peaks.load_transfer_ratio), peaks.load_transfer_ratio, "Load transfer",
       fmt::format("the {} wheel{} carried too little; at 1.00 {}",
                   peaks.load_transfer_ratio.value > 0.0 ? "right" : "left",
                   peaks.load_transfer_of_trailer ? " of the trailed implement" : "s",
                   peaks.load_transfer_of_trailer ? "it lifts" : "they lift")},
      {"track_rms_working_m_max", Better::kLess, Unit::kMetre, limits.track_rms_working_m_max,
       metrics.track_rms_working_m, std::nullopt, "Tracking error while working (RMS)",
       "neighbouring strips will overlap or leave gaps"},
      {"track_error_m_max", Better::kLess, Unit::kMetre, limits.track_error_m_max,
       magnitude(peaks.cross_track_working_m), peaks.cross_track_working_m,
       "Tracking error while working", "the vehicle did not hold its line"},
      {"boundary_overrun_m_max", Better::kLess, Unit::kMetre, limits.boundary_overrun_m_max,
       peaks.boundary_overrun_m.value, peaks.boundary_overrun_m, "Boundary overrun",
       peaks.overrun_in_hole ? "the vehicle entered a hole" : "the vehicle left the field"},
      {"belly_contact_m_max", Better::kLess, Unit::kMetre, limits.belly_contact_m_max,
       peaks.belly_contact_m.value, peaks.belly_contact_m, "Belly contact",
       "the hull's underside dragged over the ground"},
      {"reserve_soc_min", Better::kMore, Unit::kPercent, limits.reserve_soc_min, run.soc_end,
       std::nullopt, "Battery reserve",
       fmt::format("the job took {:.1f} % of the charge", 100.0 * metrics.delta_soc)},
      {"ledger_residual_ratio_max", Better::kLess, Unit::kPercent, limits.ledger_residual_ratio_max,
       metrics.ledger_residual_ratio, std::nullopt, "Energy not accounted for",
       "the simulation's energies do not add up, so its figures are not to be relied on"},
  };
}

Reason outcome_reason(const RunRecord& run) {
  Reason reason;
  reason.grade = Grade::kFail;
  reason.figure = "outcome";
  reason.title = "Not finished";
  reason.text = fmt::format("The run did not finish: {} after {}{}{}", outcome_name(run.outcome),
                            duration_text(run.duration_s), run.outcome_detail.empty() ? "" : ": ",
                            run.outcome_detail);
  reason.time_s = run.duration_s;
  if (!run.samples.empty()) reason.p_W = run.samples.back().p_WB.head<2>();
  return reason;
}

Reason path_reason(const Path& path) {
  const PathViolation& worst = *std::max_element(
      path.violations.begin(), path.violations.end(),
      [](const PathViolation& a, const PathViolation& b) { return a.overrun_m < b.overrun_m; });
  Reason reason;
  reason.grade = Grade::kWarn;
  reason.figure = "path";
  reason.title = "Path does not fit";
  reason.value = static_cast<double>(path.violations.size());
  reason.p_W = worst.p_W;
  reason.text = fmt::format(
      "The path was accepted with {} place{} that do{} not fit; the worst, by {:.2f} m at x {:.1f} "
      "m, y {:.1f} m: {}",
      path.violations.size(), path.violations.size() == 1 ? "" : "s",
      path.violations.size() == 1 ? "es" : "", worst.overrun_m, worst.p_W.x(), worst.p_W.y(),
      worst.what);
  return reason;
}

}  // namespace

Verdict judge(const Path& path, const RunRecord& run, const Metrics& metrics,
              const VerdictLimits& limits) {
  Verdict verdict;
  if (run.outcome != Outcome::kFinished) verdict.reasons.push_back(outcome_reason(run));
  for (const Check& check : checks(run, metrics, limits)) {
    if (grade_of(check.value, check.limit, check.better) != Grade::kPass) {
      verdict.reasons.push_back(reason_of(check));
    }
  }
  if (!path.violations.empty()) verdict.reasons.push_back(path_reason(path));
  std::stable_sort(verdict.reasons.begin(), verdict.reasons.end(),
                   [](const Reason& a, const Reason& b) { return a.grade > b.grade; });
  if (!verdict.reasons.empty()) verdict.grade = verdict.reasons.front().grade;
  return verdict;
}

std::vector<JudgedFigure> judged_figures(const RunRecord& run, const Metrics& metrics,
                                         const VerdictLimits& limits) {
  std::vector<JudgedFigure> figures;
  for (const Check& check : checks(run, metrics, limits)) {
    figures.push_back({grade_of(check.value, check.limit, check.better), std::string(check.subject),
                       with_unit(check.value, check.unit, 0),
                       with_unit(check.limit.warn, check.unit, 0),
                       with_unit(check.limit.fail, check.unit, 0), check.better == Better::kMore});
  }
  return figures;
}

std::string_view grade_name(Grade grade) {
  switch (grade) {
    case Grade::kPass:
      return "PASS";
    case Grade::kWarn:
      return "WARN";
    case Grade::kFail:
      return "FAIL";
  }
  return "";
}

}  // namespace headland

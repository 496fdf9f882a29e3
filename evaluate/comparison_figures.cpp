#include "evaluate/comparison_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "evaluate/rank_tests.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kPercent = 100.0;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

constexpr std::array kComparedFigures{
    ComparedFigure{"coverage_rate", "covered %", 1, kPercent, true, FigureOf::kGridPlan,
                   [](const ComparedRun& run) {
                     return static_cast<double>(run.plan.counts.distinct_cells) / run.free_cells;
                   }},
    ComparedFigure{"repeat_rate", "repeat %", 2, kPercent, false, FigureOf::kGridPlan,
                   [](const ComparedRun& run) {
                     return static_cast<double>(run.plan.counts.repeats) / run.free_cells;
                   }},
    ComparedFigure{"length_steps", "length", 1, 1.0, false, FigureOf::kGridPlan,
                   [](const ComparedRun& run) { return 1.0 * run.plan.counts.steps; }},
    ComparedFigure{"turns", "turns", 1, 1.0, false, FigureOf::kGridPlan,
                   [](const ComparedRun& run) { return 1.0 * run.plan.counts.turns; }},
    ComparedFigure{"u_turns", "U-turns", 1, 1.0, false, FigureOf::kGridPlan,
                   [](const ComparedRun& run) { return 1.0 * run.plan.counts.u_turns; }},
    ComparedFigure{"jumps", "jumps", 1, 1.0, false, FigureOf::kGridPlan,
                   [](const ComparedRun& run) { return 1.0 * run.plan.jumps; }},
    ComparedFigure{"cost", "cost", 2, 1.0, false, FigureOf::kAnyPlan,
                   [](const ComparedRun& run) { return search_of(run).cost; }},
    ComparedFigure{"fitness", "fitness", 5, 1.0, true, FigureOf::kGridPlan,
                   [](const ComparedRun& run) { return run.plan.fitness; }},
    ComparedFigure{"gap", "gap %", 2, kPercent, false, FigureOf::kRegionPlan,
                   [](const ComparedRun& run) {
                     return run.least ? run.region.cost / *run.least - 1.0 : kUnknown;
                   }},
    ComparedFigure{"convergence_iteration", "converged", 0, 1.0, false, FigureOf::kAnyPlan,
                   [](const ComparedRun& run) {
                     const auto& points = search_of(run).convergence;
                     return points.empty() ? 0.0 : 1.0 * points.back().iteration;
                   }},
    ComparedFigure{"convergence_seconds", "after s", 3, 1.0, false, FigureOf::kAnyPlan,
                   [](const ComparedRun& run) {
                     const auto& points = search_of(run).convergence;
                     return points.empty() ? 0.0 : points.back().seconds;
                   }},
    ComparedFigure{"iterations", "iterations", 0, 1.0, false, FigureOf::kAnyPlan,
                   [](const ComparedRun& run) { return 1.0 * search_of(run).iterations; }},
    ComparedFigure{
        "evaluations", "evaluations", 0, 1.0, false, FigureOf::kAnyPlan,
        [](const ComparedRun& run) { return static_cast<double>(search_of(run).evaluations); }},
    ComparedFigure{"seconds", "seconds", 3, 1.0, false, FigureOf::kAnyPlan,
                   [](const ComparedRun& run) { return run.seconds; }},
    ComparedFigure{"driven_energy_wh", "driven Wh", 1, 1.0, false, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.energy_wh; }},
    ComparedFigure{"driven_time_s", "time s", 0, 1.0, false, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.time_s; }},
    ComparedFigure{"driven_distance_m", "way m", 0, 1.0, false, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.distance_m; }},
    ComparedFigure{"driven_coverage_ratio", "covered %", 2, kPercent, true, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.coverage_ratio; }},
    ComparedFigure{"driven_overlap_ratio", "overlap %", 2, kPercent, false, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.overlap_ratio; }},
    ComparedFigure{"driven_delta_soc", "charge %", 2, kPercent, false, FigureOf::kDrive,
                   [](const ComparedRun& run) { return run.driven->metrics.delta_soc; }},
};

}  // namespace

bool has_figure(const ComparedFigure& figure, const ComparedRun& run) {
  if (run.state != RunState::kPlanned) return false;
  if (figure.of == FigureOf::kDrive) return run.driven && run.driven->refusal.empty();
  return !std::isnan(figure.value(run));
}

std::span<const ComparedFigure> every_figure() { return kComparedFigures; }

std::vector<ComparedFigure> compared_figures(const Comparison& comparison) {
  const FigureOf other_plan =
      is_of_fields(comparison) ? FigureOf::kGridPlan : FigureOf::kRegionPlan;
  std::vector<ComparedFigure> figures;
  std::ranges::copy_if(kComparedFigures, std::back_inserter(figures),
                       [&](const ComparedFigure& figure) {
                         if (figure.of == FigureOf::kDrive) return comparison.drive.has_value();
                         return figure.of != other_plan;
                       });
  return figures;
}

const ComparedFigure& find_figure(std::string_view key, const std::string& source,
                                  const std::string& where) {
  std::vector<std::string> known;
  for (const ComparedFigure& figure : kComparedFigures) {
    if (figure.key == key) return figure;
    known.emplace_back(figure.key);
  }
  throw InputError(source, where, std::string(key),
                   "unknown figure; the nearest is " + nearest_name(key, known));
}

std::optional<Spread> spread_of(const ComparedFigure& figure,
                                const std::vector<const ComparedRun*>& runs) {
  std::vector<double> values;
  for (const ComparedRun* run : runs) {
    if (has_figure(figure, *run)) values.push_back(figure.value(*run));
  }
  if (values.empty()) return std::nullopt;
  Spread spread;
  spread.runs = static_cast<int>(values.size());
  const auto n = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  if (values.size() > 1) spread.deviation = std::sqrt(squares / (n - 1.0));
  std::ranges::sort(values);
  spread.median = median(values);
  spread.best = figure.more_is_better ? values.back() : values.front();
  spread.worst = figure.more_is_better ? values.front() : values.back();
  return spread;
}

RunCounts run_counts(const std::vector<const ComparedRun*>& runs) {
  RunCounts counts;
  for (const ComparedRun* run : runs) {
    ++counts.asked;
    switch (run->state) {
      case RunState::kPlanned:
        ++counts.planned;
        counts.with_jumps += run->plan.jumps > 0 ? 1 : 0;
        break;
      case RunState::kRefused:
        if (counts.refused++ == 0) counts.refusal = run->refusal;
        break;
      case RunState::kNotRun:
        ++counts.not_run;
        break;
    }
  }
  return counts;
}

}  // namespace headland

#include "evaluate/comparison_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "terrains/input_error.h"

namespace headland {
namespace {

int last_improvement(const GridPlan& plan) {
  return plan.convergence.empty() ? 0 : plan.convergence.back().iteration;
}

}  // namespace

bool has_figure(const ComparedFigure& figure, const ComparedRun& run) {
  if (run.state != RunState::kPlanned) return false;
  return !figure.driven || (run.driven && run.driven->refusal.empty());
}

std::span<const ComparedFigure> compared_figures(bool with_drives) {
  static constexpr double kPercent = 100.0;
  static constexpr std::array kFigures{
      ComparedFigure{"coverage_rate", "covered %", 1, kPercent, true, false,
                     [](const ComparedRun& run) {
                       return static_cast<double>(run.plan.counts.distinct_cells) / run.free_cells;
                     }},
      ComparedFigure{"repeat_rate", "repeat %", 2, kPercent, false, false,
                     [](const ComparedRun& run) {
                       return static_cast<double>(run.plan.counts.repeats) / run.free_cells;
                     }},
      ComparedFigure{
          "length_steps", "length", 1, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(run.plan.counts.steps); }},
      ComparedFigure{
          "turns", "turns", 1, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(run.plan.counts.turns); }},
      ComparedFigure{
          "u_turns", "U-turns", 1, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(run.plan.counts.u_turns); }},
      ComparedFigure{"jumps", "jumps", 1, 1.0, false, false,
                     [](const ComparedRun& run) { return static_cast<double>(run.plan.jumps); }},
      ComparedFigure{"cost", "cost", 2, 1.0, false, false,
                     [](const ComparedRun& run) { return run.plan.cost; }},
      ComparedFigure{"fitness", "fitness", 5, 1.0, true, false,
                     [](const ComparedRun& run) { return run.plan.fitness; }},
      ComparedFigure{
          "convergence_iteration", "converged", 0, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(last_improvement(run.plan)); }},
      ComparedFigure{
          "iterations", "iterations", 0, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(run.plan.iterations); }},
      ComparedFigure{
          "evaluations", "evaluations", 0, 1.0, false, false,
          [](const ComparedRun& run) { return static_cast<double>(run.plan.evaluations); }},
      ComparedFigure{"seconds", "seconds", 3, 1.0, false, false,
                     [](const ComparedRun& run) { return run.seconds; }},
      ComparedFigure{"driven_energy_wh", "driven Wh", 1, 1.0, false, true,
                     [](const ComparedRun& run) { return run.driven->metrics.energy_wh; }},
      ComparedFigure{"driven_time_s", "time s", 0, 1.0, false, true,
                     [](const ComparedRun& run) { return run.driven->metrics.time_s; }},
      ComparedFigure{"driven_distance_m", "way m", 0, 1.0, false, true,
                     [](const ComparedRun& run) { return run.driven->metrics.distance_m; }},
      ComparedFigure{"driven_coverage_ratio", "covered %", 2, kPercent, true, true,
                     [](const ComparedRun& run) { return run.driven->metrics.coverage_ratio; }},
      ComparedFigure{"driven_overlap_ratio", "overlap %", 2, kPercent, false, true,
                     [](const ComparedRun& run) { return run.driven->metrics.overlap_ratio; }},
      ComparedFigure{"driven_delta_soc", "charge %", 2, kPercent, false, true,
                     [](const ComparedRun& run) { return run.driven->metrics.delta_soc; }},
  };
  constexpr auto kOfPlans = static_cast<std::size_t>(
      std::count_if(kFigures.begin(), kFigures.end(),
                    [](const ComparedFigure& figure) { return !figure.driven; }));
  return with_drives ? std::span<const ComparedFigure>(kFigures)
                     : std::span<const ComparedFigure>(kFigures).first(kOfPlans);
}

const ComparedFigure& find_figure(std::string_view key, const std::string& source,
                                  const std::string& where) {
  std::vector<std::string> known;
  for (const ComparedFigure& figure : compared_figures(true)) {
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
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  spread.best = figure.more_is_better ? *most : *least;
  spread.worst = figure.more_is_better ? *least : *most;
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

#include "evaluate/comparison_ranks.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "evaluate/comparison_figures.h"

namespace headland {
namespace {

constexpr double kFailed = std::numeric_limits<double>::infinity();

double rounded_figure(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double digits_before = std::floor(std::log10(std::abs(value)));
  const double scale = std::pow(10.0, kFigureDigits - 1 - digits_before);
  return std::round(value * scale) / scale;
}

bool failed(const ComparedRun& run) {
  return run.state == RunState::kRefused || run.plan.jumps > 0;
}

// Mean of the figure over the runs, less being better; nullopt when some were not run.
std::optional<double> block_figure(const ComparedFigure& figure,
                                   const std::vector<const ComparedRun*>& runs) {
  double sum = 0.0;
  bool any_failed = false;
  for (const ComparedRun* run : runs) {
    if (run->state == RunState::kNotRun) return std::nullopt;
    any_failed = any_failed || failed(*run);
    if (!failed(*run)) sum += figure.value(*run);
  }
  if (any_failed) return kFailed;
  const double mean = rounded_figure(sum / static_cast<double>(runs.size()));
  return figure.more_is_better ? -mean : mean;
}

void add_block(const ComparedFigure& figure,
               const std::vector<std::vector<const ComparedRun*>>& by_planner,
               ComparisonRanks& ranks) {
  std::vector<double> block;
  for (const std::vector<const ComparedRun*>& runs : by_planner) {
    const std::optional<double> value = block_figure(figure, runs);
    if (!value) {
      ++ranks.blocks_left_out;
      return;
    }
    block.push_back(*value);
  }
  ranks.blocks.push_back(block);
}

void make_blocks(const Comparison& comparison, const std::vector<ComparedRun>& runs,
                 ComparisonRanks& ranks) {
  const ComparedFigure& figure =
      find_figure(comparison.tests.figure, comparison.file.string(), "tests.figure");
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    std::vector<std::vector<const ComparedRun*>> by_planner;
    for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
      by_planner.push_back(runs_of(runs, static_cast<int>(m), static_cast<int>(p)));
      for (const ComparedRun* run : by_planner.back()) {
        ranks.failures += run->state != RunState::kNotRun && failed(*run) ? 1 : 0;
      }
    }
    if (comparison.tests.blocks == BlockKind::kMaps) {
      add_block(figure, by_planner, ranks);
      continue;
    }
    for (std::size_t repeat = 0; repeat < by_planner.front().size(); ++repeat) {
      std::vector<std::vector<const ComparedRun*>> single = by_planner;
      for (auto& of_planner : single) of_planner = {of_planner[repeat]};
      add_block(figure, single, ranks);
    }
  }
}

void test_pairs(const Comparison& comparison, ComparisonRanks& ranks) {
  const int planners = static_cast<int>(comparison.planners.size());
  const auto column = [&](int planner) {
    std::vector<double> figures;
    for (const auto& block : ranks.blocks) {
      figures.push_back(block[static_cast<std::size_t>(planner)]);
    }
    return figures;
  };
  const bool more_is_better =
      find_figure(comparison.tests.figure, comparison.file.string(), "tests.figure").more_is_better;
  std::vector<double> p;
  for (int first = 0; first < planners; ++first) {
    for (int second = 0; second < planners; ++second) {
      const bool wanted =
          ranks.control < 0 ? first < second : first == ranks.control && second != first;
      if (!wanted) continue;
      ranks.pairs.push_back({first, second, wilcoxon_test(column(first), column(second)), 1.0});
      // The blocks have the figure negated.
      double& difference = ranks.pairs.back().test.median_difference;
      if (more_is_better && difference != 0.0) difference = -difference;
      p.push_back(ranks.pairs.back().test.p);
    }
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) ranks.pairs[i].holm_p = adjusted[i];
}

// How many blocks it takes for a pair of so many to come out significant if one always wins.
int blocks_needed(std::size_t pairs, double alpha) {
  return static_cast<int>(std::floor(std::log2(2.0 * static_cast<double>(pairs) / alpha))) + 1;
}

void note_what_is_missing(const Comparison& comparison, ComparisonRanks& ranks) {
  const bool maps = comparison.tests.blocks == BlockKind::kMaps;
  const char* const places = is_of_fields(comparison) ? "fields" : "maps";
  const char* what = maps ? places : "runs";
  const std::size_t have = ranks.blocks.size();
  const std::string help =
      maps ? fmt::format(
                 "; more {0} help (a generator with count makes them), or tests.blocks: "
                 "runs, whose word holds for these {0} alone",
                 places)
           : fmt::format("; more {} or repeats help", places);
  if (!ranks.friedman) {
    ranks.notes.push_back(
        fmt::format("Friedman: {} {} are too few for a p value, at least {} are "
                    "needed{}",
                    have, what, kLeastFriedmanBlocks, help));
  }
  const int needed = blocks_needed(ranks.pairs.size(), comparison.tests.alpha);
  ranks.pairs_too_few = have < static_cast<std::size_t>(needed);
  if (ranks.pairs_too_few) {
    ranks.notes.push_back(
        fmt::format("Wilcoxon: with {} {} no pair of {} could come out significant at {} after "
                    "Holm's correction, not even one that always wins; at least {} are needed{}",
                    have, what, ranks.pairs.size(), comparison.tests.alpha, needed,
                    ranks.friedman ? help : ""));
  }
  if (ranks.blocks_left_out > 0) {
    ranks.notes.push_back(
        fmt::format("{} {} are left out: the comparison was ended before all "
                    "planners had run there",
                    ranks.blocks_left_out, what));
  }
  if (ranks.failures > 0) {
    ranks.notes.push_back(fmt::format(
        "{} runs failed (refused, or plans with jumps, which nothing can drive) and rank last{}",
        ranks.failures,
        !maps                      ? ""
        : is_of_fields(comparison) ? ", with the whole field"
                                   : ", with the whole map"));
  }
}

// A planner that stops late had more than the others.
void note_overrun_budgets(const Comparison& comparison, const std::vector<ComparedRun>& runs,
                          ComparisonRanks& ranks) {
  constexpr double kMuch = 1.05;
  if (comparison.budget == Budget::kNone) return;
  const bool counts = comparison.budget == Budget::kEvaluations;
  const SearchStop& stop = comparison.planners.front().stop;
  const double budget = counts ? static_cast<double>(stop.evaluations) : stop.seconds;
  const ComparedFigure& figure = find_figure(counts ? "evaluations" : "seconds", "ranks", "");
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
      const auto used = spread_of(figure, runs_of(runs, static_cast<int>(m), static_cast<int>(p)));
      if (!used || used->worst <= kMuch * budget) continue;
      ranks.notes.push_back(fmt::format("{} overran the budget on {}: up to {:.4g} {} of {:.4g}",
                                        comparison.planners[p].label, comparison.maps[m].name,
                                        used->worst, counts ? "evaluations" : "s", budget));
    }
  }
}

}  // namespace

ComparisonRanks rank_planners(const Comparison& comparison, const std::vector<ComparedRun>& runs) {
  ComparisonRanks ranks;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    if (comparison.planners[p].label == comparison.tests.control) {
      ranks.control = static_cast<int>(p);
    }
  }
  make_blocks(comparison, runs, ranks);
  note_overrun_budgets(comparison, runs, ranks);
  const int planners = static_cast<int>(comparison.planners.size());
  const int blocks = static_cast<int>(ranks.blocks.size());
  if (planners < 2) {
    ranks.notes.emplace_back("one planner: there is nothing to test it against");
    return ranks;
  }
  ranks.average_ranks = average_ranks(ranks.blocks);
  if (blocks >= kLeastFriedmanBlocks) {
    ranks.friedman = friedman_test(ranks.blocks);
    if (ranks.control >= 0) {
      ranks.distance = bonferroni_dunn_distance(planners, blocks, comparison.tests.alpha);
    }
  }
  test_pairs(comparison, ranks);
  note_what_is_missing(comparison, ranks);
  return ranks;
}

}  // namespace headland

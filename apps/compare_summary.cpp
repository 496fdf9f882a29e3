#include "apps/compare_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "apps/terminal_text.h"
#include "evaluate/comparison_figures.h"
#include "render/typeface.h"

namespace headland {
namespace {

// Figures that have a column of their own; the others are in the files.
constexpr std::array<std::string_view, 8> kMeans = {
    "coverage_rate", "repeat_rate",           "length_steps", "turns",
    "u_turns",       "convergence_iteration", "evaluations",  "seconds"};

using Row = std::vector<std::string>;

// Letters, not bytes.
std::size_t width_of(const std::string& text) { return letters(text).size(); }

// The first column to the left, the others to the right.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    // A row with one entry is a line of its own.
    for (std::size_t i = 0; i < row.size() && row.size() > 1; ++i) {
      widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t used = std::min(widths[i], width_of(row[i]));
      const std::string blanks(widths[i] - used, ' ');
      line += i == 0 ? " " + row[i] + blanks : "  " + blanks + row[i];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

const ComparedFigure& figure_named(std::string_view key) { return find_figure(key, "summary", ""); }

std::string number_text(const ComparedFigure& figure, double value) {
  return fmt::format("{:.{}f}", figure.scale * value, figure.decimals);
}

std::string runs_text(const RunCounts& counts) {
  return counts.planned == counts.asked ? fmt::format("{}", counts.asked)
                                        : fmt::format("{} of {}", counts.planned, counts.asked);
}

Row heading() {
  Row row = {"", "runs", "cost", "± sd", "best", "worst"};
  for (const std::string_view key : kMeans) row.emplace_back(figure_named(key).heading);
  return row;
}

Row planner_row(const std::string& label, const std::vector<const ComparedRun*>& runs) {
  const RunCounts counts = run_counts(runs);
  Row row = {label, runs_text(counts)};
  const ComparedFigure& cost = figure_named("cost");
  const auto spread = spread_of(cost, runs);
  if (!spread) return row;
  row.push_back(number_text(cost, spread->mean));
  row.push_back(spread->runs > 1 ? number_text(cost, spread->deviation) : "");
  row.push_back(number_text(cost, spread->best));
  row.push_back(number_text(cost, spread->worst));
  for (const std::string_view key : kMeans) {
    const ComparedFigure& figure = figure_named(key);
    row.push_back(number_text(figure, spread_of(figure, runs)->mean));
  }
  return row;
}

std::string cells_text(const std::optional<GridCell>& cell) {
  return cell ? fmt::format("[{}, {}]", cell->column, cell->row) : "free";
}

// A planner that stops late had more than the others.
std::string budget_remark(const Comparison& comparison, const std::string& label,
                          const std::vector<const ComparedRun*>& runs) {
  constexpr double kMuch = 1.05;
  const double budget = comparison.budget == Budget::kEvaluations
                            ? static_cast<double>(comparison.planners.front().stop.evaluations)
                            : comparison.planners.front().stop.seconds;
  const ComparedFigure& figure =
      figure_named(comparison.budget == Budget::kEvaluations ? "evaluations" : "seconds");
  const auto used = spread_of(figure, runs);
  if (comparison.budget == Budget::kNone || !used || used->worst <= kMuch * budget) return "";
  return fmt::format("  {} overran the budget: up to {:.4g} {} of {:.4g}\n", label, used->worst,
                     figure.heading, budget);
}

// The best plans as they were driven.
std::string drive_table(const Comparison& comparison, int m, const std::vector<ComparedRun>& runs) {
  constexpr std::array<std::string_view, 6> kDriven = {
      "driven_energy_wh",      "driven_time_s",        "driven_distance_m",
      "driven_coverage_ratio", "driven_overlap_ratio", "driven_delta_soc"};
  std::vector<Row> rows = {{"best plan, driven"}};
  rows[0].insert(rows[0].end(), {"outcome", "verdict"});
  for (const std::string_view key : kDriven) rows[0].emplace_back(figure_named(key).heading);
  std::string remarks;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    const std::string label = terminal_text(comparison.planners[p].label);
    const ComparedRun* run = best_run(runs_of(runs, m, static_cast<int>(p)));
    if (run == nullptr || !run->driven) continue;
    if (!run->driven->refusal.empty()) {
      remarks += fmt::format("  {} not driven: {}\n", label, terminal_text(run->driven->refusal));
      continue;
    }
    Row row = {label, std::string(outcome_name(run->driven->outcome)),
               std::string(grade_name(run->driven->verdict))};
    for (const std::string_view key : kDriven) {
      row.push_back(number_text(figure_named(key), figure_named(key).value(*run)));
    }
    rows.push_back(row);
  }
  return aligned(rows) + remarks;
}

std::string map_table(const Comparison& comparison, int m, const std::vector<ComparedRun>& runs) {
  const ComparedMap& map = comparison.maps[static_cast<std::size_t>(m)];
  std::string text =
      fmt::format("\n{}: {} x {} cells of {:g} m, {} free, start {}, end {}\n",
                  terminal_text(map.name), map.map.columns, map.map.rows, map.map.cell_m,
                  free_cell_count(map.map), cells_text(map.start), cells_text(map.end));
  std::vector<Row> rows = {heading()};
  std::string remarks;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    const std::string label = terminal_text(comparison.planners[p].label);
    const auto own = runs_of(runs, m, static_cast<int>(p));
    rows.push_back(planner_row(label, own));
    const RunCounts counts = run_counts(own);
    if (counts.refused > 0) {
      remarks += fmt::format("  {} refused {} of {} runs: {}\n", label, counts.refused,
                             counts.asked, terminal_text(counts.refusal));
    }
    if (counts.with_jumps > 0) {
      remarks += fmt::format(
          "  {}: {} of {} plans jump between cells that are no neighbours, {:.1f} times on "
          "average: nothing can drive them\n",
          label, counts.with_jumps, counts.planned, spread_of(figure_named("jumps"), own)->mean);
    }
    remarks += budget_remark(comparison, label, own);
  }
  for (const std::string& note : map.notes) remarks += "  " + terminal_text(note) + "\n";
  text += aligned(rows) + remarks;
  return comparison.drive ? text + drive_table(comparison, m, runs) : text;
}

std::string p_text(double p) { return p < 0.0001 ? "< 0.0001" : fmt::format("{:.4f}", p); }

std::string ranks_table(const Comparison& comparison, const ComparisonRanks& ranks) {
  std::vector<std::size_t> order(ranks.average_ranks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ranks.average_ranks[a] < ranks.average_ranks[b];
  });
  std::vector<Row> rows = {{"", "average rank", ""}};
  for (const std::size_t p : order) {
    Row row = {terminal_text(comparison.planners[p].label),
               fmt::format("{:.2f}", ranks.average_ranks[p])};
    if (static_cast<int>(p) == ranks.control) {
      row.emplace_back("control");
    } else if (ranks.distance > 0.0) {
      const double apart =
          ranks.average_ranks[p] - ranks.average_ranks[static_cast<std::size_t>(ranks.control)];
      row.emplace_back(std::abs(apart) < ranks.distance ? "not told from the control"
                       : apart < 0.0                    ? "better than the control"
                                                        : "worse than the control");
    }
    rows.push_back(row);
  }
  return aligned(rows);
}

std::string friedman_text(const Comparison& comparison, const ComparisonRanks& ranks) {
  if (!ranks.friedman) return "";
  const FriedmanTest& test = *ranks.friedman;
  const bool differ = test.f_p < comparison.tests.alpha;
  std::string text = fmt::format(
      "  Friedman: chi-square {:.2f} ({} degrees of freedom), p {}; Iman and Davenport: F {:.2f}, "
      "p {}: the planners {}\n",
      test.chi_square, test.methods - 1, p_text(test.chi_square_p), test.f, p_text(test.f_p),
      differ ? "differ" : "cannot be told apart");
  if (ranks.distance > 0.0) {
    text += fmt::format(
        "  Bonferroni and Dunn: average ranks {:.2f} apart from the control's "
        "differ at {}{}\n",
        ranks.distance, comparison.tests.alpha,
        differ ? "" : ", if Friedman's test found any difference");
  }
  return text;
}

std::string pairs_table(const Comparison& comparison, const ComparisonRanks& ranks) {
  if (ranks.pairs.empty()) return "";
  std::vector<Row> rows = {{"Wilcoxon, signed ranks", "", "better", "worse", "equal"}};
  if (!ranks.pairs_too_few) rows[0].insert(rows[0].end(), {"p", "p (Holm)", ""});
  for (const PlannerPair& pair : ranks.pairs) {
    const auto label = [&](int planner) {
      return terminal_text(comparison.planners[static_cast<std::size_t>(planner)].label);
    };
    Row row = {label(pair.first), "against " + label(pair.second),
               fmt::format("{}", pair.test.wins), fmt::format("{}", pair.test.losses),
               fmt::format("{}", pair.test.ties)};
    if (!ranks.pairs_too_few) {
      const bool differ = pair.holm_p < comparison.tests.alpha;
      const bool better = pair.test.rank_sum_wins > pair.test.rank_sum_losses;
      row.insert(row.end(), {p_text(pair.test.p), p_text(pair.holm_p),
                             !differ  ? "not told apart"
                             : better ? "better"
                                      : "worse"});
    }
    rows.push_back(row);
  }
  return "\n" + aligned(rows);
}

std::string tests_text(const Comparison& comparison, const ComparisonRanks& ranks) {
  const bool maps = comparison.tests.blocks == BlockKind::kMaps;
  std::string text =
      fmt::format("\nranks by {} over {} {}{}\n", comparison.tests.figure, ranks.blocks.size(),
                  maps ? "maps, each with its mean over the repeats" : "single runs",
                  maps ? ": what holds for maps like these" : ": what holds for these very maps");
  if (!ranks.average_ranks.empty()) text += ranks_table(comparison, ranks);
  text += friedman_text(comparison, ranks) + pairs_table(comparison, ranks);
  for (const std::string& note : ranks.notes) text += "  note: " + note + "\n";
  return text;
}

std::string budget_text(const Comparison& comparison) {
  const SearchStop& stop = comparison.planners.front().stop;
  switch (comparison.budget) {
    case Budget::kEvaluations:
      return fmt::format("{} evaluations each", stop.evaluations);
    case Budget::kSeconds:
      return fmt::format("{:g} s each", stop.seconds);
    case Budget::kNone:
      break;
  }
  return "each planner's own end";
}

}  // namespace

std::string comparison_summary(const Comparison& comparison, const std::vector<ComparedRun>& runs,
                               const ComparisonRanks& ranks) {
  std::string text = fmt::format("{}: {} planners on {} maps, {} repeats, {}, seed {}\n",
                                 terminal_text(comparison.name), comparison.planners.size(),
                                 comparison.maps.size(), comparison.repeats,
                                 budget_text(comparison), comparison.seed);
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    text += map_table(comparison, static_cast<int>(m), runs);
  }
  return text + tests_text(comparison, ranks);
}

}  // namespace headland

#include "apps/compare_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "apps/terminal_text.h"
#include "apps/text_table.h"
#include "evaluate/comparison_figures.h"

namespace headland {
namespace {

// Figures that have a column of their own; the others are in the files.
constexpr std::array<std::string_view, 8> kMapMeans = {
    "coverage_rate", "repeat_rate",           "length_steps", "turns",
    "u_turns",       "convergence_iteration", "evaluations",  "seconds"};
constexpr std::array<std::string_view, 5> kFieldMeans = {
    "gap", "convergence_iteration", "convergence_seconds", "evaluations", "seconds"};

std::span<const std::string_view> means_of(const Comparison& comparison) {
  if (is_of_fields(comparison)) return kFieldMeans;
  return kMapMeans;
}

const ComparedFigure& figure_named(std::string_view key) { return find_figure(key, "summary", ""); }

std::string number_text(const ComparedFigure& figure, double value) {
  return fmt::format("{:.{}f}", figure.scale * value, figure.decimals);
}

std::string runs_text(const RunCounts& counts) {
  return counts.planned == counts.asked ? fmt::format("{}", counts.asked)
                                        : fmt::format("{} of {}", counts.planned, counts.asked);
}

Row heading(const Comparison& comparison) {
  const bool of_fields = is_of_fields(comparison);
  Row row = {
      "",     "runs", of_fields ? (comparison.cost.measured ? "energy Wh" : "length m") : "cost",
      "± sd", "best", "worst"};
  if (of_fields) row.emplace_back("median gap %");
  for (const std::string_view key : means_of(comparison)) {
    row.emplace_back(figure_named(key).heading);
  }
  return row;
}

Row planner_row(const Comparison& comparison, const std::string& label,
                const std::vector<const ComparedRun*>& runs) {
  const RunCounts counts = run_counts(runs);
  Row row = {label, runs_text(counts)};
  const ComparedFigure& cost = figure_named("cost");
  const auto spread = spread_of(cost, runs);
  if (!spread) return row;
  // Plans with jumps cannot be driven: what they cost and how long they are compares with nothing.
  const bool jumps = counts.with_jumps > 0;
  if (jumps) {
    row.insert(row.end(), 4, "-");
  } else {
    row.push_back(number_text(cost, spread->mean));
    row.push_back(spread->runs > 1 ? number_text(cost, spread->deviation) : "");
    row.push_back(number_text(cost, spread->best));
    row.push_back(number_text(cost, spread->worst));
  }
  if (is_of_fields(comparison)) {
    const ComparedFigure& gap = figure_named("gap");
    const auto gaps = spread_of(gap, runs);
    row.push_back(gaps ? number_text(gap, gaps->median) : "-");
  }
  for (const std::string_view key : means_of(comparison)) {
    const ComparedFigure& figure = figure_named(key);
    const auto own = spread_of(figure, runs);
    const bool tells = own && !(jumps && key == "length_steps");
    row.push_back(tells ? number_text(figure, own->mean) : "-");
  }
  return row;
}

std::string cells_text(const std::optional<GridCell>& cell) {
  return cell ? fmt::format("[{}, {}]", cell->column, cell->row) : "free";
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

std::string place_text(const std::optional<Eigen::Vector2d>& p_W) {
  return p_W ? fmt::format("({:.1f}, {:.1f})", p_W->x(), p_W->y()) : "free";
}

std::string field_line(const ComparedMap& field) {
  const ComparedRegion& region = *field.region;
  constexpr double kHectare_m2 = 1e4;
  std::string text =
      fmt::format("{}: {:.2f} ha in {} parts ({}), swaths {:g} m wide, start {}, end {}",
                  terminal_text(field.name), field_area_m2(region.field) / kHectare_m2,
                  region.parts.parts.size(), decomposition_name(region.options.decomposition),
                  region.options.width_m, place_text(region.start_W), place_text(region.end_W));
  if (!region.parts.dropped_W.empty()) {
    text += fmt::format("; {} small parts dropped, {:.1f} m2", region.parts.dropped_W.size(),
                        dropped_m2(region.parts));
  }
  for (const auto& [least, how] : {std::pair{region.least_own, "each part along its own edge"},
                                   std::pair{region.least_any, "along any edge"}}) {
    if (!least) continue;
    text += fmt::format("\n  least possible, {}: {:.2f} {}", how, *least, region.cost ? "Wh" : "m");
  }
  return text;
}

std::string map_line(const ComparedMap& map) {
  return fmt::format("{}: {} x {} cells of {:g} m, {} free, start {}, end {}",
                     terminal_text(map.name), map.map.columns, map.map.rows, map.map.cell_m,
                     free_cell_count(map.map), cells_text(map.start),
                     map.closed ? "where it begins" : cells_text(map.end));
}

std::string map_table(const Comparison& comparison, int m, const std::vector<ComparedRun>& runs) {
  const ComparedMap& map = comparison.maps[static_cast<std::size_t>(m)];
  std::string text = "\n" + (map.region ? field_line(map) : map_line(map)) + "\n";
  std::vector<Row> rows = {heading(comparison)};
  std::string remarks;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    const std::string label = terminal_text(comparison.planners[p].label);
    const auto own = runs_of(runs, m, static_cast<int>(p));
    rows.push_back(planner_row(comparison, label, own));
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
  }
  for (const std::string& note : map.notes) remarks += "  " + terminal_text(note) + "\n";
  text += aligned(rows) + remarks;
  return comparison.drive ? text + drive_table(comparison, m, runs) : text;
}

std::string p_text(double p) { return p < 0.0001 ? "< 0.0001" : fmt::format("{:.4f}", p); }

// Whether Friedman's test finds a difference; else no planner is called better or worse.
bool planners_differ(const Comparison& comparison, const ComparisonRanks& ranks) {
  return ranks.friedman && ranks.friedman->f_p < comparison.tests.alpha;
}

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
    } else if (ranks.distance > 0.0 && planners_differ(comparison, ranks)) {
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
  const bool differ = planners_differ(comparison, ranks);
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
  const char* what = is_of_fields(comparison) ? "fields" : "maps";
  std::string text =
      fmt::format("\nranks by {} over {} ", comparison.tests.figure, ranks.blocks.size());
  text += maps ? fmt::format(
                     "{0}, each with its mean over the repeats: what holds for {0} like "
                     "these\n",
                     what)
               : fmt::format("single runs: what holds for these very {}\n", what);
  if (!ranks.average_ranks.empty()) text += ranks_table(comparison, ranks);
  text += friedman_text(comparison, ranks) + pairs_table(comparison, ranks);
  for (const std::string& note : ranks.notes) text += "  note: " + terminal_text(note) + "\n";
  return text;
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
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
  std::string text =
      fmt::format("{}: {} on {}, {}, {}, seed {}\n", terminal_text(comparison.name),
                  counted(comparison.planners.size(), "planner"),
                  counted(comparison.maps.size(), is_of_fields(comparison) ? "field" : "map"),
                  counted(static_cast<std::size_t>(comparison.repeats), "repeat"),
                  budget_text(comparison), comparison.seed);
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    text += map_table(comparison, static_cast<int>(m), runs);
  }
  return text + tests_text(comparison, ranks);
}

}  // namespace headland

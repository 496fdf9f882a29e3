#include "apps/compare_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "apps/interrupt.h"
#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_reader.h"
#include "evaluate/duration_text.h"
#include "render/convergence_chart.h"
#include "render/gnuplot.h"
#include "render/grid_picture.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct PictureName {
  std::string_view prefix;
  std::string_view ending;
};
constexpr PictureName kChart{"convergence_", ".svg"};
constexpr PictureName kChartImage{"convergence_", ".png"};
constexpr PictureName kSheet{"plans_", ".png"};
constexpr PictureName kPlan{"plan_", ".png"};

std::string file_name(const PictureName& kind, const std::string& name) {
  return fmt::format("{}{}{}", kind.prefix, name_in_files(name), kind.ending);
}

std::string counted(int count, const char* one, const char* more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

GridFigure figure_of(const std::string& label, const std::vector<const ComparedRun*>& runs) {
  GridFigure figure;
  figure.title = label;
  const RunCounts counts = run_counts(runs);
  const ComparedRun* best = best_run(runs);
  if (best == nullptr) {
    figure.lines = {counts.refused > 0 ? "refused: " + counts.refusal : "not run"};
    return figure;
  }
  const GridPlan& plan = best->plan;
  figure.path = plan.cells;
  if (best->driven && best->driven->refusal.empty()) {
    const Metrics& driven = best->driven->metrics;
    figure.lines.push_back(fmt::format("driven: {:.4g} Wh, {}, {:.1f} % covered, {}",
                                       driven.energy_wh, duration_text(driven.time_s),
                                       100.0 * driven.coverage_ratio,
                                       grade_name(best->driven->verdict)));
  }
  if (plan.jumps > 0) {
    figure.lines.push_back(counted(plan.jumps, "jump", "jumps") +
                           ", which nothing can drive; without them:");
  }
  figure.lines.push_back(fmt::format("cost {:.4g}, length {} ({:.2f} % repeated)", plan.cost,
                                     plan.counts.steps - plan.jumps, 100.0 * repeat_rate(plan)));
  figure.lines.push_back(fmt::format("{}, {}", counted(plan.counts.turns, "turn", "turns"),
                                     counted(plan.counts.u_turns, "U-turn", "U-turns")));
  if (counts.planned > 1) figure.lines.back() += fmt::format("; best of {} plans", counts.planned);
  return figure;
}

ConvergenceLine line_of(const std::string& label, const std::vector<const ComparedRun*>& runs) {
  ConvergenceLine line;
  line.label = label;
  for (const ComparedRun* run : runs) {
    if (run->state != RunState::kPlanned) continue;
    line.runs.push_back(run->plan.convergence);
    line.iterations.push_back(run->plan.iterations);
    line.evaluations.push_back(run->plan.evaluations);
  }
  if (run_counts(runs).with_jumps > 0) line.label += " (jumps)";
  return line;
}

}  // namespace

std::vector<FileText> comparison_pictures(const Comparison& comparison,
                                          const std::vector<ComparedRun>& runs) {
  const InterruptAtOnce at_once;
  std::vector<FileText> files;
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    const ComparedMap& map = comparison.maps[m];
    std::vector<GridFigure> figures;
    std::vector<ConvergenceLine> lines;
    for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
      const std::string& label = comparison.planners[p].label;
      const auto own = runs_of(runs, static_cast<int>(m), static_cast<int>(p));
      figures.push_back(figure_of(label, own));
      lines.push_back(line_of(label, own));
      GridFigure alone = figures.back();
      alone.title = fmt::format("{}: {}", map.name, label);
      files.push_back(
          {file_name(kPlan, map.name + "_" + label), png_of(draw_grid_plan(map.map, alone))});
      // Maps and labels that differ may join to the same name.
      const auto same = [&](const FileText& file) { return file.name == files.back().name; };
      for (int other = 2; std::count_if(files.begin(), files.end(), same) > 1; ++other) {
        files.back().name = file_name(kPlan, fmt::format("{}_{}_{}", map.name, label, other));
      }
    }
    files.push_back(
        {file_name(kSheet, map.name), png_of(draw_grid_sheet(map.map, map.name, figures))});
    const bool planned = std::any_of(
        lines.begin(), lines.end(), [](const ConvergenceLine& line) { return !line.runs.empty(); });
    if (!planned) continue;
    const std::string script = convergence_chart_script(map.name, lines);
    files.push_back(
        {file_name(kChart, map.name), chart_of(script, ChartFormat::kSvg, kConvergenceChartWidth_px,
                                               kConvergenceChartHeight_px)});
    files.push_back({file_name(kChartImage, map.name),
                     chart_of(script, ChartFormat::kPng, kConvergenceChartWidth_px,
                              kConvergenceChartHeight_px)});
  }
  return files;
}

std::string plans_picture_name(const std::string& map) { return file_name(kSheet, map); }

std::vector<fs::path> earlier_pictures(const fs::path& compare_json) {
  std::vector<fs::path> pictures;
  if (!fs::is_regular_file(compare_json)) return pictures;
  try {
    const nlohmann::ordered_json earlier = parse_json(compare_json);
    for (const auto& entry : earlier.at("pictures")) {
      const fs::path name = entry.get<std::string>();
      const bool picture = name.extension() == ".png" || name.extension() == ".svg";
      if (picture && name == name.filename()) pictures.push_back(compare_json.parent_path() / name);
    }
  } catch (const InputError&) {
    // Not a comparison's: nothing is known of pictures.
  } catch (const nlohmann::json::exception&) {
  }
  return pictures;
}

}  // namespace headland

#include "apps/compare_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>

#include "apps/interrupt.h"
#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_reader.h"
#include "evaluate/duration_text.h"
#include "render/convergence_chart.h"
#include "render/gnuplot.h"
#include "render/grid_picture.h"
#include "render/region_picture.h"
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

RegionGround ground_of(const ComparedRegion& region) {
  RegionGround ground{{region.field.boundary, region.field.holes},
                      {},
                      region.parts.dropped_W,
                      region.start_W,
                      region.end_W};
  for (const RegionPart& part : region.parts.parts) ground.parts_W.push_back(part.outline_W);
  return ground;
}

RegionFigure region_figure_of(const ComparedRegion& region, const ComparedPlanner& planner,
                              const std::vector<const ComparedRun*>& runs) {
  RegionFigure figure;
  figure.title = planner.label;
  const RunCounts counts = run_counts(runs);
  const ComparedRun* best = best_run(runs);
  if (best == nullptr) {
    figure.lines = {counts.refused > 0 ? "refused: " + counts.refusal : "not run"};
    return figure;
  }
  const std::vector<WorkedPart> parts = worked_parts(region, planner.sweeps);
  for (const RegionVisit visit : best->region.visits) {
    figure.visits.push_back({visit.part, way_of(parts, visit)});
  }
  figure.lines.push_back(fmt::format("{:.1f} {}", best->region.cost, region.cost ? "Wh" : "m"));
  if (best->least) {
    figure.lines.back() += fmt::format(", {:.2f} % above the least possible",
                                       100.0 * (best->region.cost / *best->least - 1.0));
  }
  if (counts.planned > 1) figure.lines.back() += fmt::format("; best of {} plans", counts.planned);
  return figure;
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
    const RunSearch search = search_of(*run);
    line.runs.push_back(search.convergence);
    line.iterations.push_back(search.iterations);
    line.evaluations.push_back(search.evaluations);
  }
  if (run_counts(runs).with_jumps > 0) line.label += " (jumps)";
  return line;
}

// What is drawn of a map or a field: a planner's best plan alone, and all of them.
struct PlanPictures {
  std::function<Image(std::size_t planner, const std::string& title)> alone;
  std::function<Image()> sheet;
};

PlanPictures map_pictures(const Comparison& comparison, int m,
                          const std::vector<ComparedRun>& runs) {
  const ComparedMap& map = comparison.maps[static_cast<std::size_t>(m)];
  std::vector<GridFigure> figures;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    figures.push_back(
        figure_of(comparison.planners[p].label, runs_of(runs, m, static_cast<int>(p))));
  }
  const auto alone = [&map, figures](std::size_t planner, const std::string& title) {
    GridFigure figure = figures[planner];
    figure.title = title;
    return draw_grid_plan(map.map, figure);
  };
  return {alone, [&map, figures] { return draw_grid_sheet(map.map, map.name, figures); }};
}

PlanPictures field_pictures(const Comparison& comparison, int m,
                            const std::vector<ComparedRun>& runs) {
  const ComparedMap& field = comparison.maps[static_cast<std::size_t>(m)];
  const RegionGround ground = ground_of(*field.region);
  std::vector<RegionFigure> figures;
  for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
    figures.push_back(region_figure_of(*field.region, comparison.planners[p],
                                       runs_of(runs, m, static_cast<int>(p))));
  }
  const auto alone = [ground, figures](std::size_t planner, const std::string& title) {
    RegionFigure figure = figures[planner];
    figure.title = title;
    return draw_region_plan(ground, figure);
  };
  return {alone,
          [&field, ground, figures] { return draw_region_sheet(ground, field.name, figures); }};
}

}  // namespace

std::vector<FileText> comparison_pictures(const Comparison& comparison,
                                          const std::vector<ComparedRun>& runs) {
  const InterruptAtOnce at_once;
  std::vector<FileText> files;
  for (std::size_t m = 0; m < comparison.maps.size(); ++m) {
    const ComparedMap& map = comparison.maps[m];
    const PlanPictures pictures = map.region ? field_pictures(comparison, static_cast<int>(m), runs)
                                             : map_pictures(comparison, static_cast<int>(m), runs);
    std::vector<ConvergenceLine> lines;
    for (std::size_t p = 0; p < comparison.planners.size(); ++p) {
      const std::string& label = comparison.planners[p].label;
      lines.push_back(line_of(label, runs_of(runs, static_cast<int>(m), static_cast<int>(p))));
      files.push_back({file_name(kPlan, map.name + "_" + label),
                       png_of(pictures.alone(p, fmt::format("{}: {}", map.name, label)))});
      // Maps and labels that differ may join to the same name.
      const auto same = [&](const FileText& file) { return file.name == files.back().name; };
      for (int other = 2; std::count_if(files.begin(), files.end(), same) > 1; ++other) {
        files.back().name = file_name(kPlan, fmt::format("{}_{}_{}", map.name, label, other));
      }
    }
    files.push_back({file_name(kSheet, map.name), png_of(pictures.sheet())});
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

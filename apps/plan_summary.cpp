#include "apps/plan_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/left_out.h"
#include "apps/summary_rows.h"
#include "apps/terminal_text.h"
#include "evaluate/planned_coverage.h"
#include "evaluate/results.h"
#include "planner/free_space.h"
#include "planner/headland_edges.h"
#include "planner/worked_rows.h"
#include "terrains/geo_frame.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kCellsTold = 8;

int manoeuvres_of(const Path& path, PathKind kind) {
  std::vector<int> seen;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind == kind) seen.push_back(segment.manoeuvre);
  }
  std::sort(seen.begin(), seen.end());
  return static_cast<int>(std::unique(seen.begin(), seen.end()) - seen.begin());
}

double length_of_m(const Path& path, PathKind kind) {
  double sum_m = 0.0;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind == kind) sum_m += length_m(segment);
  }
  return sum_m;
}

double reverse_length_m(const Path& path) {
  double sum_m = 0.0;
  for (const PathSegment& segment : path.segments) {
    if (segment.gear == Gear::kReverse) sum_m += length_m(segment);
  }
  return sum_m;
}

// What the grid planner counts, and what driving made of it.
std::string grid_rows(const PlanResult& result) {
  if (!result.grid_plan) return "";
  const GridPlan& plan = *result.grid_plan;
  const GridDrive& drive = *result.grid_drive;
  return summary_row(
             "on the grid", fmt::format("{} cells", plan.counts.distinct_cells),
             fmt::format("{} repeats, {} turns, {} U-turns, cost {:.4g}", plan.counts.repeats,
                         plan.counts.turns, plan.counts.u_turns, plan.cost)) +
         summary_row("passes", fmt::format("{}", drive.plan.passes.size()),
                     fmt::format("{} of them added, {} runs of the plan left out",
                                 drive.added_passes, drive.left_out.size()));
}

std::string headland_rows(const Plan& plan) {
  std::string text = summary_row("headland", fmt::format("{:.2f} m", plan.headland_width_m),
                                 plan.headland_edges.empty() ? "" : "where it is widest");
  for (const PlannedEdge& edge : plan.headland_edges) {
    text +=
        summary_row("  " + edge_name(edge.hole, edge.edge), fmt::format("{:.2f} m", edge.width_m),
                    fmt::format("{} pass{}, from ({:.1f}, {:.1f}) to ({:.1f}, {:.1f}) m",
                                edge.passes, edge.passes == 1 ? "" : "es", edge.from_W.x(),
                                edge.from_W.y(), edge.to_W.x(), edge.to_W.y()));
  }
  return text;
}

// What the plan works comes first, and then what it leaves out.
std::string work_rows(const Job& job, const PlanResult& result, const CoverageFigures& coverage) {
  return summary_row("works",
                     fmt::format("{:.2f} %", 100.0 * coverage.covered_m2 / coverage.workable_m2),
                     fmt::format("of {}; {:.0f} m² stay unworked", hectares(coverage.workable_m2),
                                 coverage.missed_m2)) +
         left_out_rows(result.path, coverage, job.scenario.path);
}

}  // namespace

CoverageFigures coverage_of(const Job& job, const PlanResult& result) {
  return planned_coverage(job.stage.field, job.stage.vehicle, result.path,
                          job.scenario.coverage_cell_m);
}

std::string over_worked_row(const Stage& stage, const Path& path, const PathOptions& options) {
  const DrivenOverWorked over = driven_over_worked(stage.field, stage.vehicle, path);
  if (over.stretches == 0) {
    return options.keep_off_worked ? summary_row("over worked rows", "0 m", "implement up") : "";
  }
  return summary_row(
      "over worked rows", fmt::format("{:.0f} m", over.length_m),
      fmt::format("implement up, in {}, the longest from x {:.1f}, y {:.1f} m",
                  counted(static_cast<std::size_t>(over.stretches), "place", "places"),
                  over.p_W.x(), over.p_W.y()));
}

std::string predicted_row(const PlanResult& result) {
  if (!result.predicted) return "";
  const PredictedEnergy& predicted = *result.predicted;
  return summary_row(
      "energy predicted", fmt::format("{:.1f} Wh", predicted.energy_wh),
      fmt::format("{} times lowered, {} changes of gear, {:.0f} quarter turns raised",
                  predicted.cycles, predicted.cusps, predicted.raised_quarters));
}

std::string path_notes(const Path& path) {
  std::string text;
  if (!path.cut_back_m.empty()) {
    text += fmt::format("  {} cut back by up to {:.1f} m to make room for turns\n",
                        counted(path.cut_back_m.size(), "end of a pass", "ends of passes"),
                        *std::max_element(path.cut_back_m.begin(), path.cut_back_m.end()));
  }
  if (path.abrupt_turns > 0) {
    text += fmt::format("  turns whose curvature jumps, as no continuous one fits: {}\n",
                        path.abrupt_turns);
  }
  if (path.abrupt_joints > 0) {
    text += fmt::format("  ends of continuous turns where curvature jumps to a bent pass's: {}\n",
                        path.abrupt_joints);
  }
  const TightestPlace& tightest = path.tightest;
  if (std::isfinite(tightest.clearance_m) && path.violations.empty()) {
    const double kept_m = std::max(0.0, tightest.clearance_m);
    text += fmt::format(
        "  a pass brings the hull within {:.2f} m of an edge, or {:.2f} m of an obstacle, at x "
        "{:.1f}, y {:.1f} m\n",
        kept_m, kObstacleClearances * kept_m, tightest.p_W.x(), tightest.p_W.y());
  }
  return text;
}

std::string grid_notes(const PlanResult& result) {
  if (!result.grid_drive) return "";
  const GridDrive& drive = *result.grid_drive;
  std::string text;
  if (drive.unworked_ratio > 0.0) {
    text += fmt::format("  {:.2f} % of the free cells cannot be worked:\n",
                        100.0 * drive.unworked_ratio);
  }
  for (std::size_t i = 0; i < drive.unworked.size(); ++i) {
    if (i == kCellsTold) {
      return text + fmt::format("  and {}, all in {}\n",
                                counted(drive.unworked.size() - i, "more cell", "more cells"),
                                kGridPlanFile);
    }
    const UnworkedCell& cell = drive.unworked[i];
    text += fmt::format("  {:.0f} % of cell [{}, {}]: {}\n", 100.0 * cell.share, cell.cell.column,
                        cell.cell.row, cell.why);
  }
  return text;
}

std::string plan_summary(const Job& job, const PlanResult& result,
                         const CoverageFigures& coverage) {
  std::string text =
      headline(job) + "\n" + work_rows(job, result, coverage) +
      summary_row("planner", result.plan.planner) + grid_rows(result) +
      summary_row("swath direction",
                  fmt::format("{:.1f} deg", degrees(result.plan.swath_direction_rad)),
                  "counter-clockwise from east") +
      headland_rows(result.plan) +
      summary_row("path", fmt::format("{:.0f} m", length_m(result.path)),
                  fmt::format("{:.0f} m of it in reverse", reverse_length_m(result.path)));
  text += predicted_row(result);
  for (const PathKind kind : kEveryPathKind) {
    const int count = manoeuvres_of(result.path, kind);
    if (count == 0) continue;
    text += summary_row(fmt::format("{} x {}", count, path_kind_name(kind)),
                        fmt::format("{:.0f} m", length_of_m(result.path, kind)));
  }
  text += over_worked_row(job.stage, result.path, job.scenario.path) + path_notes(result.path) +
          grid_notes(result) + notes_text(job.stage.notes) + notes_text(result.notes);
  for (const PathViolation& violation : result.path.violations) {
    text += fmt::format("  does not fit at x {:.1f}, y {:.1f} m: {}\n", violation.p_W.x(),
                        violation.p_W.y(), violation.what);
  }
  return text;
}

Json plan_summary_json(const Job& job, const PlanResult& result, const CoverageFigures& coverage) {
  Json json;
  json["headland"] = {{"version", HEADLAND_VERSION}};
  json["scenario"] = {{"name", job.scenario.name},
                      {"field_area_m2", field_area_m2(job.stage.field)},
                      {"seed", job.scenario.seed}};
  json["coverage"] = {{"workable_m2", coverage.workable_m2},
                      {"worked_m2", coverage.covered_m2},
                      {"unworked_m2", coverage.missed_m2},
                      {"worked_ratio", coverage.covered_m2 / coverage.workable_m2}};
  const LeftOutGround left_out = left_out_ground(result.path, coverage);
  json["left_out_m2"] = left_out.area_m2;
  json["left_out_ratio"] = left_out.ratio;
  json["planner"] = result.plan.planner;
  json["swath_direction_rad"] = result.plan.swath_direction_rad;
  json["headland_width_m"] = result.plan.headland_width_m;
  for (const PlannedEdge& edge : result.plan.headland_edges) {
    json["headland_edges"].push_back({{"hole", edge.hole},
                                      {"edge", edge.edge},
                                      {"passes", edge.passes},
                                      {"width_m", edge.width_m},
                                      {"from_W", {edge.from_W.x(), edge.from_W.y()}},
                                      {"to_W", {edge.to_W.x(), edge.to_W.y()}}});
  }
  if (result.grid_plan) {
    json["grid"] = {{"repeats", result.grid_plan->counts.repeats},
                    {"turns", result.grid_plan->counts.turns},
                    {"u_turns", result.grid_plan->counts.u_turns},
                    {"cost", result.grid_plan->cost},
                    {"added_passes", result.grid_drive->added_passes},
                    {"runs_left_out", result.grid_drive->left_out.size()},
                    {"unworked_ratio", result.grid_drive->unworked_ratio},
                    {"unworked_cells", result.grid_drive->unworked.size()}};
  }
  json["path_length_m"] = length_m(result.path);
  json["reverse_length_m"] = reverse_length_m(result.path);
  for (const PathKind kind : kEveryPathKind) {
    json["by_kind"][std::string(path_kind_name(kind))] = {
        {"count", manoeuvres_of(result.path, kind)}, {"length_m", length_of_m(result.path, kind)}};
  }
  if (result.predicted) {
    Json& predicted = json["predicted"];
    predicted["energy_wh"] = result.predicted->energy_wh;
    for (const PathKind kind : kEveryPathKind) {
      predicted["by_kind_wh"][std::string(path_kind_name(kind))] =
          result.predicted->by_kind_wh[static_cast<std::size_t>(kind)];
    }
    predicted["working_m"] = result.predicted->working_m;
    predicted["raised_m"] = result.predicted->raised_m;
    predicted["working_quarters"] = result.predicted->working_quarters;
    predicted["raised_quarters"] = result.predicted->raised_quarters;
    predicted["pivot_quarters"] = result.predicted->pivot_quarters;
    predicted["cycles"] = result.predicted->cycles;
    predicted["cusps"] = result.predicted->cusps;
  }
  const DrivenOverWorked over = driven_over_worked(job.stage.field, job.stage.vehicle, result.path);
  json["over_worked_rows_m"] = over.length_m;
  json["abrupt_turns"] = result.path.abrupt_turns;
  json["abrupt_joints"] = result.path.abrupt_joints;
  json["cut_back_m"] = result.path.cut_back_m;
  json["left_out"] = Json::array();
  for (const LeftOutPass& pass : result.path.left_out) {
    json["left_out"].push_back({{"pass", pass.pass},
                                {"x_m", pass.p_W.x()},
                                {"y_m", pass.p_W.y()},
                                {"area_m2", pass.area_m2},
                                {"why", pass.why}});
  }
  const TightestPlace& tightest = result.path.tightest;
  if (std::isfinite(tightest.clearance_m)) {
    json["tightest"] = {{"clearance_m", tightest.clearance_m},
                        {"x_m", tightest.p_W.x()},
                        {"y_m", tightest.p_W.y()}};
  }
  json["violations"] = result.path.violations.size();
  json["notes"] = job.stage.notes;
  for (const std::string& note : result.notes) json["notes"].push_back(note);
  return json;
}

std::string track_summary(const TrackReport& report) {
  std::string text =
      fmt::format("track made drivable: {}, {} cut, at most {:.2f} m from its points\n",
                  counted(static_cast<std::size_t>(report.pieces), "piece", "pieces"),
                  counted(static_cast<std::size_t>(report.cut_corners), "corner", "corners"),
                  report.max_deviation_m);
  for (const std::string& note : report.notes) text += "  " + note + "\n";
  return text;
}

Json track_json(const TrackReport& report) {
  return {{"pieces", report.pieces},
          {"cut_corners", report.cut_corners},
          {"max_deviation_m", report.max_deviation_m},
          {"notes", report.notes}};
}

}  // namespace headland

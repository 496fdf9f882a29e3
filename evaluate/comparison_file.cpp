#include "evaluate/comparison_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_region_json.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

// A text as a field of a CSV table, RFC 4180.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

const std::string& map_name(const Comparison& comparison, int map) {
  return comparison.maps[static_cast<std::size_t>(map)].name;
}

// How what planners are compared on is called in the files.
const char* map_word(const Comparison& comparison) {
  return is_of_fields(comparison) ? "field" : "map";
}

const ComparedPlanner& planner_of(const Comparison& comparison, int planner) {
  return comparison.planners[static_cast<std::size_t>(planner)];
}

std::string drive_columns(const ComparedRun& run) {
  if (!run.driven) return ",,,";
  const DrivenPlan& driven = *run.driven;
  if (!driven.refusal.empty()) return ",,," + csv_text(driven.refusal);
  return fmt::format(",{},{},", outcome_name(driven.outcome), grade_name(driven.verdict));
}

// Calls `visit(map, planner, runs)` for every pair.
template <typename Visit>
void each_pair(const Comparison& comparison, const std::vector<ComparedRun>& runs, Visit visit) {
  for (int m = 0; m < static_cast<int>(comparison.maps.size()); ++m) {
    for (int p = 0; p < static_cast<int>(comparison.planners.size()); ++p) {
      visit(m, p, runs_of(runs, m, p));
    }
  }
}

Json parameters_json(const Parameters& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&, &key = name](const auto& one) { json[key] = one; }, value);
  }
  return json;
}

// Limits that are none are left out.
Json stop_json(const SearchStop& stop) {
  Json json = Json::object();
  if (stop.iterations < std::numeric_limits<int>::max()) json["iterations"] = stop.iterations;
  if (stop.evaluations > 0) json["evaluations"] = stop.evaluations;
  if (stop.seconds > 0.0) json["seconds"] = stop.seconds;
  if (stop.stagnation > 0) json["stagnation"] = stop.stagnation;
  return json;
}

Json cell_json(const GridCell& cell) { return {cell.column, cell.row}; }

Json cost_json(const GridCost& cost, const std::filesystem::path& file) {
  if (cost.measured) {
    return {{"objective", grid_objective_name(cost.objective)}, {"file", file.string()}};
  }
  switch (cost.objective) {
    case GridObjective::kLength:
      return {{"objective", "length"}};
    case GridObjective::kWeighted:
      return {{"objective", "weighted"},
              {"repeat", cost.weights.repeat},
              {"turn", cost.weights.turn},
              {"u_turn", cost.weights.u_turn}};
    case GridObjective::kTractor:
    case GridObjective::kMeasured:  // has measured costs
      break;
  }
  const TractorEnergy& tractor = cost.tractor;
  return {{"objective", "tractor"},
          {"tractor",
           {{"mass_kg", tractor.mass_kg},
            {"friction", tractor.friction},
            {"gravity_m_s2", tractor.gravity_m_s2},
            {"turn_speed_m_s", tractor.turn_speed_m_s},
            {"voltage_v", tractor.voltage_v},
            {"turn_current_a", tractor.turn_current_a},
            {"length_weight", tractor.length_weight},
            {"height_weight", tractor.height_weight},
            {"turn_weight", tractor.turn_weight}}}};
}

Json asked_json(const Comparison& comparison) {
  Json json;
  json["name"] = comparison.name;
  json["seed"] = comparison.seed;
  json["repeats"] = comparison.repeats;
  json["equal_budget"] = comparison.budget == Budget::kNone          ? Json()
                         : comparison.budget == Budget::kEvaluations ? Json("evaluations")
                                                                     : Json("seconds");
  const bool of_fields = is_of_fields(comparison);
  if (!of_fields || comparison.cost.measured)
    json["cost"] = cost_json(comparison.cost, comparison.cost_file);
  for (const ComparedMap& map : comparison.maps) {
    if (of_fields) {
      json["fields"].push_back(region_json(map));
      continue;
    }
    json["maps"].push_back({{"name", map.name},
                            {"columns", map.map.columns},
                            {"rows", map.map.rows},
                            {"cell_m", map.map.cell_m},
                            {"free_cells", free_cell_count(map.map)},
                            {"start", map.start ? cell_json(*map.start) : Json("free")},
                            {"end", map.end ? cell_json(*map.end) : Json("free")},
                            {"closed", map.closed}});
  }
  if (comparison.drive) {
    const Scenario& drive = *comparison.drive;
    json["drive"] = {
        {"vehicle", drive.vehicle},
        {"working_width_m", drive.working_width_m},
        {"soil", soil_text(drive.soil)},
        {"terrain", drive.terrain.file.empty() ? drive.terrain.generator
                                               : drive.terrain.file.filename().string()},
        {"terrain_seed", drive.terrain.seed},
        {"rate_hz", drive.simulation.rate_hz},
        {"clearance_m", drive.path.clearance_m}};
  }
  for (const ComparedPlanner& planner : comparison.planners) {
    json["planners"].push_back({{"label", planner.label},
                                {"name", planner.name},
                                {"source", of_fields ? find_region_planner(planner.name, "").source
                                                     : find_grid_planner(planner.name, "").source},
                                {"parameters", parameters_json(planner.parameters)},
                                {"stop", stop_json(planner.stop)}});
    if (of_fields) {
      json["planners"].back()["sweeps"] = planner.sweeps == PartSweeps::kOwn ? "own" : "any";
    }
  }
  return json;
}

Json result_json(const Comparison& comparison, int map, int planner,
                 const std::vector<const ComparedRun*>& runs) {
  const RunCounts counts = run_counts(runs);
  Json json = {{map_word(comparison), map_name(comparison, map)},
               {"planner", planner_of(comparison, planner).label},
               {"runs",
                {{"asked", counts.asked},
                 {"planned", counts.planned},
                 {"refused", counts.refused},
                 {"not_run", counts.not_run},
                 {"with_jumps", counts.with_jumps}}}};
  if (counts.refused > 0) json["refusal"] = counts.refusal;
  for (const ComparedFigure& figure : compared_figures(comparison)) {
    const auto spread = spread_of(figure, runs);
    if (!spread) continue;
    json["figures"][std::string(figure.key)] = {{"mean", spread->mean},
                                                {"standard_deviation", spread->deviation},
                                                {"median", spread->median},
                                                {"best", spread->best},
                                                {"worst", spread->worst}};
  }
  if (const ComparedRun* best = best_run(runs)) {
    json["best"]["repeat"] = best->repeat;
    if (is_of_fields(comparison)) {
      json["best"]["visits"] = visits_json(*comparison.maps[static_cast<std::size_t>(map)].region,
                                           planner_of(comparison, planner).sweeps, best->region);
    }
    for (const GridCell& cell : best->plan.cells) json["best"]["path"].push_back(cell_json(cell));
  }
  return json;
}

Json drive_json(const DrivenPlan& driven) {
  if (!driven.refusal.empty()) return {{"refusal", driven.refusal}};
  return {{"outcome", outcome_name(driven.outcome)},
          {"outcome_detail", driven.outcome_detail},
          {"verdict", grade_name(driven.verdict)}};
}

Json run_json(const Comparison& comparison, const ComparedRun& run) {
  Json json = {{map_word(comparison), map_name(comparison, run.map)},
               {"planner", planner_of(comparison, run.planner).label},
               {"repeat", run.repeat},
               {"seed", run.seed},
               {"state", run_state_name(run.state)}};
  if (run.state == RunState::kRefused) json["refusal"] = run.refusal;
  if (run.state != RunState::kPlanned) return json;
  for (const ComparedFigure& figure : compared_figures(comparison)) {
    if (has_figure(figure, run)) json["figures"][std::string(figure.key)] = figure.value(run);
  }
  if (run.driven) json["drive"] = drive_json(*run.driven);
  json["stopped_by"] = stop_reason_name(search_of(run).stopped_by);
  json["convergence"] = Json::array();
  for (const ConvergencePoint& point : search_of(run).convergence) {
    json["convergence"].push_back({point.iteration, point.evaluations, point.cost});
  }
  return json;
}

// A p value that the blocks are too few for is null.
Json p_json(double p, bool too_few) { return too_few ? Json() : Json(p); }

Json ranks_json(const Comparison& comparison, const ComparisonRanks& ranks) {
  Json json;
  json["figure"] = comparison.tests.figure;
  json["block"] = comparison.tests.blocks == BlockKind::kMaps ? map_word(comparison) : "run";
  json["alpha"] = comparison.tests.alpha;
  json["blocks"] = ranks.blocks.size();
  json["blocks_left_out"] = ranks.blocks_left_out;
  json["failed_runs"] = ranks.failures;
  for (std::size_t p = 0; p < ranks.average_ranks.size(); ++p) {
    json["average_rank"][comparison.planners[p].label] = ranks.average_ranks[p];
  }
  if (const auto& test = ranks.friedman) {
    json["friedman"] = {{"chi_square", test->chi_square},
                        {"tie_correction", test->tie_correction},
                        {"chi_square_p", test->chi_square_p},
                        {"iman_davenport_f", test->f},
                        {"iman_davenport_p", test->f_p}};
  }
  if (ranks.control >= 0) json["control"] = planner_of(comparison, ranks.control).label;
  if (ranks.distance > 0.0) json["bonferroni_dunn_distance"] = ranks.distance;
  for (const PlannerPair& pair : ranks.pairs) {
    json["wilcoxon"].push_back({{"first", planner_of(comparison, pair.first).label},
                                {"second", planner_of(comparison, pair.second).label},
                                {"first_better", pair.test.wins},
                                {"second_better", pair.test.losses},
                                {"ties", pair.test.ties},
                                {"rank_sum_first_better", pair.test.rank_sum_wins},
                                {"rank_sum_second_better", pair.test.rank_sum_losses},
                                {"median_difference", pair.test.median_difference},
                                {"exact", pair.test.exact},
                                {"p", p_json(pair.test.p, ranks.pairs_too_few)},
                                {"holm_p", p_json(pair.holm_p, ranks.pairs_too_few)}});
  }
  json["notes"] = ranks.notes;
  return json;
}

}  // namespace

std::string comparison_runs_csv(const Comparison& comparison,
                                const std::vector<ComparedRun>& runs) {
  std::string text =
      fmt::format("{},planner,repeat,seed,state,stopped_by,refusal", map_word(comparison));
  if (comparison.drive) text += ",outcome,verdict,drive_refusal";
  for (const ComparedFigure& figure : compared_figures(comparison))
    text += fmt::format(",{}", figure.key);
  text += "\n";
  for (const ComparedRun& run : runs) {
    const bool planned = run.state == RunState::kPlanned;
    text += fmt::format("{},{},{},{},{},{},{}", csv_text(map_name(comparison, run.map)),
                        csv_text(planner_of(comparison, run.planner).label), run.repeat, run.seed,
                        run_state_name(run.state),
                        planned ? stop_reason_name(search_of(run).stopped_by) : "",
                        csv_text(run.refusal));
    if (comparison.drive) text += drive_columns(run);
    for (const ComparedFigure& figure : compared_figures(comparison)) {
      text += has_figure(figure, run) ? fmt::format(",{}", figure.value(run)) : ",";
    }
    text += "\n";
  }
  return text;
}

std::string comparison_table_csv(const Comparison& comparison,
                                 const std::vector<ComparedRun>& runs) {
  std::string text =
      fmt::format("{},planner,asked,planned,refused,not_run,with_jumps", map_word(comparison));
  for (const ComparedFigure& figure : compared_figures(comparison)) {
    text += fmt::format(",{0}_mean,{0}_sd,{0}_median,{0}_best,{0}_worst", figure.key);
  }
  text += "\n";
  each_pair(comparison, runs, [&](int map, int planner, const auto& own) {
    const RunCounts counts = run_counts(own);
    text += fmt::format("{},{},{},{},{},{},{}", csv_text(map_name(comparison, map)),
                        csv_text(planner_of(comparison, planner).label), counts.asked,
                        counts.planned, counts.refused, counts.not_run, counts.with_jumps);
    for (const ComparedFigure& figure : compared_figures(comparison)) {
      const auto spread = spread_of(figure, own);
      text += spread ? fmt::format(",{},{},{},{},{}", spread->mean, spread->deviation,
                                   spread->median, spread->best, spread->worst)
                     : ",,,,,";
    }
    text += "\n";
  });
  return text;
}

Json comparison_json(const Comparison& comparison, const std::vector<ComparedRun>& runs,
                     const ComparisonRanks& ranks, const std::string& version) {
  Json json;
  json["headland"] = {{"version", version}};
  json["comparison"] = asked_json(comparison);
  each_pair(comparison, runs, [&](int map, int planner, const auto& own) {
    json["results"].push_back(result_json(comparison, map, planner, own));
  });
  json["ranks"] = ranks_json(comparison, ranks);
  for (const ComparedRun& run : runs) json["runs"].push_back(run_json(comparison, run));
  return json;
}

}  // namespace headland

#include "evaluate/grid_plan_file.h"

#include <fmt/format.h>

#include "evaluate/geojson.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kShareDecimals = 4;

}  // namespace

std::string grid_plan_json(const GridMap& map, const GridPlan& plan, const GridDrive& drive) {
  Json json;
  json["planner"] = plan.planner;
  json["map"] = {{"columns", map.columns},
                 {"rows", map.rows},
                 {"cell_m", map.cell_m},
                 {"origin_x_m", map.origin_W.x()},
                 {"origin_y_m", map.origin_W.y()},
                 {"direction_rad", map.direction_rad},
                 {"free_cells", free_cell_count(map)}};
  json["steps"] = plan.counts.steps;
  json["repeats"] = plan.counts.repeats;
  json["turns"] = plan.counts.turns;
  json["u_turns"] = plan.counts.u_turns;
  json["jumps"] = plan.jumps;
  json["cost"] = plan.cost;
  json["iterations"] = plan.iterations;
  json["evaluations"] = plan.evaluations;
  json["stopped_by"] = stop_reason_name(plan.stopped_by);
  json["added_passes"] = drive.added_passes;
  json["runs_left_out"] = Json::array();
  for (const LeftOutRun& run : drive.left_out) {
    json["runs_left_out"].push_back({{"from", {run.first.column, run.first.row}},
                                     {"to", {run.last.column, run.last.row}},
                                     {"why", run.why}});
  }
  json["unworked_ratio"] = rounded(drive.unworked_ratio, kShareDecimals);
  json["unworked"] = Json::array();
  for (const UnworkedCell& unworked : drive.unworked) {
    const Eigen::Vector2d middle_W = centre_W(map, unworked.cell);
    json["unworked"].push_back({{"column", unworked.cell.column},
                                {"row", unworked.cell.row},
                                {"x_m", middle_W.x()},
                                {"y_m", middle_W.y()},
                                {"share", rounded(unworked.share, kShareDecimals)},
                                {"why", unworked.why}});
  }
  std::string cells;
  for (const GridCell& cell : plan.cells) {
    cells += fmt::format("{}{} {}", cells.empty() ? "" : ", ", cell.column, cell.row);
  }
  json["cells"] = cells;
  return json_text(json, 2) + "\n";
}

}  // namespace headland

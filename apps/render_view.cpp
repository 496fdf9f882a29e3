#include "apps/render_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluate/coverage.h"
#include "evaluate/duration_text.h"
#include "evaluate/results.h"
#include "render/grid_picture.h"
#include "render/moment_view.h"
#include "render/run_event.h"
#include "render/run_moment.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr std::string_view kEventPrefix = "event:";
constexpr std::array<std::string_view, 5> kViews = {"map", "perspective", "chase", "elevation",
                                                    kGridView};

double last_moment_s(const RunRecord& run) {
  return run.samples.empty() ? 0.0 : run.samples.back().time_s;
}

// The cells of grid_plan.json in order.
std::vector<GridCell> cells_of(const std::filesystem::path& file) {
  const nlohmann::ordered_json json = parse_json(file);
  const auto fault = [&](const std::string& given) {
    return InputError(file.string(), "cells", given, "column row, column row, ...");
  };
  if (!json.is_object() || !json.contains("cells") || !json["cells"].is_string()) throw fault("");
  const std::string text = json["cells"];
  std::vector<GridCell> cells;
  for (std::size_t at = 0; at < text.size();) {
    GridCell cell;
    int read = 0;
    if (std::sscanf(text.c_str() + at, "%9d %9d%n", &cell.column, &cell.row, &read) != 2) {
      throw fault(text.substr(at, 20));
    }
    cells.push_back(cell);
    at = std::min(text.size(), at + static_cast<std::size_t>(read) + 2);
  }
  return cells;
}

Image draw_grid(const Job& job, const ViewRequest& request) {
  if (request.at_s || request.overlay || request.exaggeration) {
    throw InputError("--view", "", "grid", "takes no --at, --overlay or --exaggeration");
  }
  if (!job.stage.grid) {
    throw InputError("--view", "", "grid", "the run was not planned on a grid map");
  }
  const GridMap& map = *job.stage.grid;
  const std::filesystem::path file = job.folder / kGridPlanFile;
  GridFigure figure;
  figure.title = job.scenario.name;
  figure.path = cells_of(file);
  for (const GridCell& cell : figure.path) {
    if (cell.column < 0 || cell.row < 0 || cell.column >= map.columns || cell.row >= map.rows) {
      throw InputError(file.string(), "cells", fmt::format("{} {}", cell.column, cell.row),
                       fmt::format("within {} columns and {} rows", map.columns, map.rows));
    }
  }
  const nlohmann::ordered_json json = parse_json(file);
  try {
    figure.lines = {fmt::format("{}: {} steps, {} repeated, {} turns, {} U-turns",
                                json.value("planner", ""), json.value("steps", 0),
                                json.value("repeats", 0), json.value("turns", 0),
                                json.value("u_turns", 0))};
  } catch (const nlohmann::json::type_error&) {
    throw InputError(file.string(), "planner, steps, repeats, turns, u_turns", "",
                     "a text and four numbers are needed, as 'headland plan' writes them");
  }
  return draw_grid_plan(map, figure);
}

RunEvent event_of(const std::string& name, const RecordedRun& recorded) {
  const std::optional<RunEvent> event = find_event(name, recorded.path, recorded.run);
  if (event) return *event;
  throw InputError("--view", "event", name, "this did not happen in the run");
}

}  // namespace

std::vector<std::string> view_names() {
  std::vector<std::string> names(kViews.begin(), kViews.end());
  for (const EventEntry& event : run_events()) {
    names.push_back(fmt::format("{}{}", kEventPrefix, event.name));
  }
  return names;
}

MomentScene::MomentScene(const Job& job, const RecordedRun& recorded,
                         std::optional<double> moment_s)
    : run(moment_s ? run_until(recorded.run, *moment_s) : recorded.run),
      coverage(measure_coverage(job.stage.field, run.footprints, job.scenario.working_width_m,
                                job.scenario.coverage_cell_m)),
      scene{job.stage.field,
            job.stage.terrain,
            job.stage.vehicle,
            recorded.path,
            run,
            coverage,
            nullptr,
            job.scenario.path_file.filename().string(),
            moment_s,
            fmt::format("{}", fmt::join(recorded.missing, "; "))} {}

Image draw_requested(const Job& job, const RecordedRun& recorded, const ViewRequest& request) {
  const bool of_event = request.view.starts_with(kEventPrefix);
  if (!of_event && std::find(kViews.begin(), kViews.end(), request.view) == kViews.end()) {
    throw InputError("--view", "", request.view, unknown_name("view", request.view, view_names()));
  }
  if (request.view == kGridView) return draw_grid(job, request);
  std::optional<double> moment_s = request.at_s;
  MomentOptions moment;
  moment.overlay = request.overlay;
  if (of_event) {
    if (request.at_s) throw InputError("--at", "", request.view, "an event has its own time");
    const RunEvent event = event_of(request.view.substr(kEventPrefix.size()), recorded);
    moment.camera = MomentCamera::kCloseUp;
    moment.title = event.title;
    moment.value = event.value;
    moment_s = event.time_s;
  }
  const double last_s = last_moment_s(recorded.run);
  if (moment_s && *moment_s > last_s && !of_event) {
    throw InputError("--at", "", fmt::format("{:g} s", *moment_s),
                     fmt::format("the run ends after {:.1f} s", last_s));
  }
  const bool is_moment = of_event || request.view == "chase";
  if (is_moment && request.exaggeration) {
    throw InputError("--exaggeration", "", request.view,
                     "views of the machine are drawn to scale; perspective and elevation take it");
  }
  const MomentScene until(job, recorded, is_moment && !moment_s ? last_s : moment_s);
  const ViewOptions options{request.overlay, request.exaggeration};
  if (is_moment) return draw_moment(until.scene, request.size, moment);
  if (request.view == "perspective") return draw_view(until.scene, request.size, options);
  if (request.view == "elevation") return draw_elevation(until.scene, request.size, options);
  if (request.exaggeration) {
    throw InputError("--exaggeration", "", request.view,
                     "maps have no heights; perspective and elevation take it");
  }
  return request.overlay ? draw_quantity_map(until.scene, request.size, *request.overlay)
                         : draw_field_map(until.scene, request.size);
}

}  // namespace headland

#include "apps/left_out.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/summary_rows.h"
#include "apps/terminal_text.h"

namespace headland {
namespace {

constexpr std::size_t kLeftOutTold = 8;  // passes

std::string passes_text(std::size_t count) {
  return count == 1 ? "1 pass" : fmt::format("{} passes", count);
}

bool drives_into_corners(const PlannerChoice& planner) {
  const auto corners = planner.parameters.find("headland_corners");
  return corners != planner.parameters.end() &&
         word(planner.parameters, "headland_corners") == "covered";
}

bool has_edges_without(const PlannerChoice& planner) {
  return std::ranges::any_of(planner.headland_edges, [](const EdgeHeadland& edge) {
    return edge.passes ? *edge.passes == 0 : edge.width_m == 0.0;
  });
}

std::vector<std::string> remedies(const std::vector<PlannerChoice>& planners,
                                  const PathOptions& options) {
  std::vector<std::string> all{"a smaller vehicle or one that turns tighter"};
  if (std::ranges::any_of(planners, drives_into_corners)) {
    all.emplace_back(
        "planner.headland_corners: rounded, which leaves the corners but has closed rounds");
  }
  if (std::ranges::any_of(planners, has_edges_without)) {
    all.emplace_back("a headland along the edges that planner.headland_edges gives none");
  }
  if (options.keep_off_worked) all.emplace_back("path.keep_off_worked: false");
  return all;
}

}  // namespace

std::string left_out_rows(const Path& path, double field_m2) {
  if (path.left_out.empty()) return "";
  const double sum_m2 = left_out_m2(path);
  std::string text =
      summary_row("LEFT OUT", fmt::format("{:.0f} m²", sum_m2),
                  fmt::format("{:.2f} % of the field: {} that no turn leads to or from{}",
                              100.0 * sum_m2 / field_m2, passes_text(path.left_out.size()),
                              path.left_out.size() > 1 ? ", the largest first" : ""));
  for (std::size_t i = 0; i < path.left_out.size(); ++i) {
    if (i == kLeftOutTold) {
      return text + fmt::format("    and {} more\n", passes_text(path.left_out.size() - i));
    }
    const LeftOutPass& pass = path.left_out[i];
    text += fmt::format("    {:.1f} m²: {}\n", pass.area_m2, terminal_text(pass.why));
  }
  return text;
}

std::string left_out_warning(const Path& path, double field_m2,
                             const std::vector<PlannerChoice>& planners,
                             const PathOptions& options) {
  const double sum_m2 = left_out_m2(path);
  if (!(sum_m2 > kLeftOutWarned * field_m2)) return "";
  const LeftOutPass& largest = path.left_out.front();
  return fmt::format(
      "the plan leaves out {} for {:.0f} m², {:.1f} % of the field, the largest for {:.0f} m² at x "
      "{:.1f}, y {:.1f} m; what may help: {}",
      passes_text(path.left_out.size()), sum_m2, 100.0 * sum_m2 / field_m2, largest.area_m2,
      largest.p_W.x(), largest.p_W.y(), fmt::join(remedies(planners, options), "; "));
}

std::string unworked_cells_warning(const GridDrive& drive, const FieldSource& field) {
  if (!(drive.unworked_ratio > kLeftOutWarned)) return "";
  std::string text = fmt::format("the plan leaves {:.1f} % of the free cells' ground unworked",
                                 100.0 * drive.unworked_ratio);
  if (!drive.unworked.empty()) {
    const UnworkedCell& most = *std::ranges::max_element(drive.unworked, {}, &UnworkedCell::share);
    text += fmt::format(", as {:.0f} % of cell [{}, {}]: {}", 100.0 * most.share, most.cell.column,
                        most.cell.row, most.why);
  }
  text += "; what may help: a smaller vehicle or one that turns tighter";
  if (!field.grid_map.empty()) {
    text +=
        fmt::format("; more ground around the map (field.margin_m, {:g} m now)", field.margin_m);
  }
  return text;
}

void print_warning(const std::string& text) {
  if (!text.empty()) fmt::print(stderr, "headland: warning: {}\n", terminal_text(text));
}

void warn_of_left_out(const Job& job, const PlanResult& result) {
  print_warning(left_out_warning(result.path, field_area_m2(job.stage.field),
                                 {job.scenario.planner}, job.scenario.path));
  if (result.grid_drive) {
    print_warning(unworked_cells_warning(*result.grid_drive, job.scenario.field));
  }
}

}  // namespace headland

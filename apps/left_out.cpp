#include "apps/left_out.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <variant>

#include "apps/summary_rows.h"
#include "apps/terminal_text.h"

namespace headland {
namespace {

constexpr std::size_t kLeftOutTold = 8;  // passes

std::string passes_text(std::size_t count) { return counted(count, "pass", "passes"); }

bool drives_into_corners(const PlannerChoice& planner) {
  const auto corners = planner.parameters.find("headland_corners");
  return corners != planner.parameters.end() && std::get<std::string>(corners->second) == "covered";
}

bool has_edges_without(const PlannerChoice& planner) {
  return std::ranges::any_of(planner.headland_edges, [](const EdgeHeadland& edge) {
    return edge.passes ? *edge.passes == 0 : edge.width_m == 0.0;
  });
}

// The remedy with the names of the fields it is one of; empty where it is of none.
std::string remedy_of(const std::vector<PlannedField>& fields, bool (*has)(const PlannerChoice&),
                      std::string_view remedy) {
  std::vector<std::string> names;
  bool any = false;
  for (const PlannedField& field : fields) {
    if (!has(field.planner)) continue;
    any = true;
    if (!field.name.empty()) names.push_back(fmt::format("'{}'", field.name));
  }
  if (!any) return "";
  if (names.empty()) return std::string(remedy);
  return fmt::format("{} (field{} {})", remedy, names.size() == 1 ? "" : "s",
                     fmt::join(names, ", "));
}

std::vector<std::string> remedies(const std::vector<PlannedField>& fields,
                                  const PathOptions& options) {
  std::vector<std::string> all{
      "a smaller vehicle or one that turns tighter",
      remedy_of(
          fields, drives_into_corners,
          "planner.headland_corners: rounded, which leaves the corners but has closed rounds"),
      remedy_of(fields, has_edges_without,
                "a headland along the edges that planner.headland_edges gives none")};
  if (options.keep_off_worked) {
    all.emplace_back("path.keep_off_worked: false, as keeping off rows may be why");
  }
  std::erase(all, "");
  return all;
}

}  // namespace

LeftOutGround left_out_ground(const Path& path, const CoverageFigures& coverage) {
  const double area_m2 = std::min(left_out_m2(path), coverage.missed_m2);
  return {area_m2, area_m2 / coverage.workable_m2};
}

std::string left_out_rows(const Path& path, const CoverageFigures& coverage,
                          const PathOptions& options) {
  if (path.left_out.empty()) return "";
  const LeftOutGround ground = left_out_ground(path, coverage);
  std::string text =
      summary_row("LEFT OUT", fmt::format("{:.0f} m²", ground.area_m2),
                  fmt::format("{:.2f} %: {} that cannot be reached or left{}", 100.0 * ground.ratio,
                              passes_text(path.left_out.size()),
                              path.left_out.size() > 1 ? ", the largest first" : ""));
  if (options.keep_off_worked) {
    text += "    that wheels keep off rows (path.keep_off_worked) may be why\n";
  }
  for (std::size_t i = 0; i < path.left_out.size(); ++i) {
    if (i == kLeftOutTold) {
      return text + fmt::format("    and {} more\n", passes_text(path.left_out.size() - i));
    }
    const LeftOutPass& pass = path.left_out[i];
    text += fmt::format("    {:.1f} m²: {}\n", pass.area_m2, terminal_text(pass.why));
  }
  return text;
}

std::string left_out_warning(const Path& path, const CoverageFigures& coverage,
                             const std::vector<PlannedField>& fields, const PathOptions& options) {
  const LeftOutGround ground = left_out_ground(path, coverage);
  if (!(ground.ratio > kLeftOutWarned)) return "";
  const LeftOutPass& largest = path.left_out.front();
  return fmt::format(
      "the plan leaves out {} for {:.0f} m², {:.1f} % of what is to be worked, the largest for "
      "{:.0f} m² at x {:.1f}, y {:.1f} m; what may help: {}",
      passes_text(path.left_out.size()), ground.area_m2, 100.0 * ground.ratio, largest.area_m2,
      largest.p_W.x(), largest.p_W.y(), fmt::join(remedies(fields, options), "; "));
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

void warn_of_left_out(const Job& job, const PlanResult& result, const CoverageFigures& coverage) {
  print_warning(
      left_out_warning(result.path, coverage, {{"", job.scenario.planner}}, job.scenario.path));
  if (result.grid_drive) {
    print_warning(unworked_cells_warning(*result.grid_drive, job.scenario.field));
  }
}

}  // namespace headland

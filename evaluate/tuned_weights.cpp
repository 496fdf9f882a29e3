#include "evaluate/tuned_weights.h"

#include <fmt/format.h>

#include "evaluate/comparison_reader.h"
#include "evaluate/scenario_grid.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"

namespace headland {

std::string weights_yaml(const GridCost& cost, const std::string& comment) {
  std::string text;
  std::size_t begin = 0;
  while (begin < comment.size()) {
    const std::size_t end = std::min(comment.find('\n', begin), comment.size());
    text += "# " + comment.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  YAML::Emitter out;
  out << YAML::BeginMap;
  emit_grid_cost(out, cost, {});
  out << YAML::EndMap;
  return text + out.c_str() + "\n";
}

void plan_by_weights(const std::filesystem::path& file, PlannerChoice& planner) {
  const YamlSection top = read_yaml(file);
  refuse_unknown_keys(top, {"cost"});
  if (!read_section(top, "cost")) {
    throw InputError(top.source, place_of(top, "cost"), "",
                     "the section is missing: objective and weights, as headland tune writes them");
  }
  if (!read_cost_file(top, file.parent_path()).empty()) {
    throw InputError(top.source, "cost.file", "",
                     "weights are needed; measured costs go by --cost");
  }
  const GridCost cost = read_grid_cost(top);
  if (!planner.grid) {
    throw InputError(
        "--weights", "", file.string(),
        fmt::format("only for planners on grid maps; {} has no weights", planner.name));
  }
  planner.grid->cost = cost;
  planner.cost_file.clear();
}

}  // namespace headland

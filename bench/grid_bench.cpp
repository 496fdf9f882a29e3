// What grid planners stand on: the table of all distances against plainer ways to the same, and
// maps of a million cells.
// Usage: grid_bench [--json] [--only TEXT], of figures whose name has the text. Half a minute.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <queue>
#include <string>
#include <string_view>
#include <vector>

#include "bench/figures.h"
#include "planner/grid_distances.h"
#include "planner/grid_planners.h"
#include "terrains/grid_map_file.h"
#include "terrains/grid_map_generator.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

constexpr int kUnknown = std::numeric_limits<int>::max() / 2;

using Matrix = std::vector<std::vector<int>>;

// A breadth-first search from every cell, as it is written in textbooks.
Matrix searched(const GridGraph& graph) {
  Matrix steps;
  for (int start = 0; start < graph.size(); ++start) {
    std::vector<int> from_start(graph.cells.size(), kUnknown);
    std::queue<int> queue;
    at(from_start, start) = 0;
    queue.push(start);
    while (!queue.empty()) {
      const int node = queue.front();
      queue.pop();
      for (const int next : at(graph.beside, node)) {
        if (next < 0 || at(from_start, next) < kUnknown) continue;
        at(from_start, next) = at(from_start, node) + 1;
        queue.push(next);
      }
    }
    steps.push_back(std::move(from_start));
  }
  return steps;
}

// Floyd's algorithm, Eq (3) of Wang et al. 2025 (10.20944/preprints202504.0101.v1).
Matrix by_floyd(const GridGraph& graph) {
  const std::size_t n = graph.cells.size();
  Matrix steps(n, std::vector<int>(n, kUnknown));
  for (std::size_t i = 0; i < n; ++i) {
    steps[i][i] = 0;
    for (const int next : graph.beside[i]) {
      if (next >= 0) steps[i][static_cast<std::size_t>(next)] = 1;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        steps[i][j] = std::min(steps[i][j], steps[i][k] + steps[k][j]);
      }
    }
  }
  return steps;
}

template <typename Work>
double median_ms(int times, Work work) {
  std::vector<double> taken_ms;
  for (int i = 0; i < times; ++i) {
    const double begun_s = cpu_seconds();
    work();
    taken_ms.push_back(1e3 * (cpu_seconds() - begun_s));
  }
  return median(taken_ms);
}

void require_same(const GridGraph& graph, const DistanceTable& table, const Matrix& steps) {
  for (int i = 0; i < graph.size(); ++i) {
    for (int j = 0; j < graph.size(); ++j) {
      if (table(i, j) != at(at(steps, i), j)) throw std::runtime_error("distances differ");
    }
  }
}

void measure_table(const std::string& name, std::vector<Figure>& figures) {
  const GridGraph graph =
      grid_graph(read_grid_map(HEADLAND_SOURCE_DIR "/examples/maps/" + name + ".txt", 1.0), name);
  DistanceTable table;
  Matrix plain;
  Matrix floyd;
  const double ours_ms = median_ms(15, [&] { table = distance_table(graph, name); });
  const double plain_ms = median_ms(5, [&] { plain = searched(graph); });
  const double floyd_ms = median_ms(1, [&] { floyd = by_floyd(graph); });
  require_same(graph, table, plain);
  require_same(graph, table, floyd);
  const std::string what = fmt::format("all pairs, {}, {} cells", name, graph.size());
  figures.push_back({what, ours_ms, "ms", name == "env_IV" ? "under 20 ms" : ""});
  figures.push_back({what + ": plain searches / ours", plain_ms / ours_ms, "times", ""});
  figures.push_back({what + ": Floyd / ours", floyd_ms / ours_ms, "times", ""});
}

// Planned until a few seconds are over, the most between two looks at whether to end, and what the
// process came to need at most.
void measure_large(const GridMap& map, const GridPlannerEntry& planner,
                   std::vector<Figure>& figures) {
  constexpr double kSearch_s = 5.0;
  GridPlanRequest request;
  request.map = map;
  request.cost.objective = GridObjective::kWeighted;
  request.parameters = resolve_parameters(planner.parameters, {}, "grid_bench", "");
  request.stop = {std::numeric_limits<int>::max(), 0, kSearch_s, 0};
  const double begun_s = cpu_seconds();
  double looked_s = begun_s;
  double longest_s = 0.0;
  request.cancelled = [&] {
    const double now_s = cpu_seconds();
    longest_s = std::max(longest_s, now_s - looked_s);
    looked_s = now_s;
    return false;
  };
  const std::string what = fmt::format("{} x {}, {}", map.columns, map.rows, planner.name);
  try {
    const GridPlan plan = planner.plan(request);
    longest_s = std::max(longest_s, cpu_seconds() - looked_s);
    figures.push_back({what, cpu_seconds() - begun_s, "s", ""});
    figures.push_back({what + ": without a look at whether to end", longest_s, "s", "under 1 s"});
    figures.push_back({what + ": cost", plan.cost, "", ""});
    figures.push_back({what + ": peak memory so far", peak_memory_bytes() / 1048576.0, "MiB", ""});
  } catch (const InputError& refused) {
    figures.push_back({what, 0.0, "refused", refused.what()});
  }
}

void run(std::string_view only, bool json) {
  std::vector<Figure> figures;
  const auto asked = [&](const std::string& name) { return name.find(only) != std::string::npos; };
  for (const char* name : {"env_I", "env_II", "env_III", "env_IV"}) {
    if (asked(fmt::format("all pairs, {}", name))) measure_table(name, figures);
  }
  const GridMap large = made_up_grid_map({kMaxGridSide, kMaxGridSide, 0.1, 300, 1}, "grid_bench");
  for (const GridPlannerEntry& planner : grid_planners()) {
    if (asked(fmt::format("1000 x 1000, {}", planner.name))) {
      measure_large(large, planner, figures);
    }
  }
  print(figures, json);
}

}  // namespace
}  // namespace headland::bench

int main(int argc, char** argv) {
  std::string_view only;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::string_view(argv[i]) == "--only") only = argv[i + 1];
  }
  headland::bench::run(only, headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

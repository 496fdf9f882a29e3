#include "bench/paper_scenes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "bench/figures.h"
#include "evaluate/metrics.h"
#include "evaluate/planner_cost.h"
#include "evaluate/rank_tests.h"
#include "planner/drivable_path.h"
#include "planner/path_energy.h"
#include "planner/region_energy.h"
#include "planner/region_generator.h"
#include "planner/region_planners.h"
#include "sim/simulation.h"
#include "terrains/soil.h"
#include "terrains/soil_map.h"
#include "terrains/terrain_source.h"

namespace headland::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVehicle = "transplanter";
constexpr int kRegions = 3;
constexpr double kArea_m2 = 3000.0;
constexpr double kWidth_m = 5.0;  // between lines: as many as the paper's way is long
constexpr double kNotDriven = std::numeric_limits<double>::quiet_NaN();
constexpr double kMargin_m = 10.0;  // ground around the region to turn on

struct PaperScene {
  const char* name;
  bool start = false;
  bool end = false;
  double printed = 0.0;  // the least length, by enumeration
};
constexpr PaperScene kScenes[] = {{"scene_1", true, false, 6630.03},
                                  {"scene_2", true, true, 6853.97},
                                  {"scene_3", false, false, 6152.53}};

struct SceneRegion {
  std::vector<WorkedPart> parts;
  RegionProblem by_length;
  RegionProblem by_energy;
  Field field;  // with the margin
  Heightfield terrain;
};

SceneRegion region_of(const PaperScene& scene, int number, const DriveCost& cost) {
  const RegionRecipe recipe{5, -1, kArea_m2, static_cast<std::uint64_t>(number + 1)};
  const Field inside = made_up_region(recipe, "papers");
  SceneRegion region;
  region.field = inside;
  region.field.boundary = buffered(from_field(inside), kMargin_m, Join::kRound).parts.front().outer;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : inside.boundary) box.extend(p_W);
  TerrainSource rolling;
  rolling.generator = "rolling";
  for (const GeneratorEntry& entry : generators()) {
    if (entry.name != rolling.generator) continue;
    rolling.parameters = resolve_parameters(
        entry.parameters, {{"amplitude_m", 2.0}, {"wavelength_m", 60.0}}, "papers", "terrain");
  }
  rolling.seed = recipe.seed;
  region.terrain = read_terrain(rolling, region.field, "papers");
  region.parts = worked_parts(region_parts(from_field(inside), {}), kWidth_m, PartSweeps::kOwn);
  std::optional<Eigen::Vector2d> start_W;
  std::optional<Eigen::Vector2d> end_W;
  if (scene.start) start_W = box.min();
  if (scene.end) end_W = box.max();
  region.by_length = region_problem(region.parts, start_W, end_W);
  region.by_energy = region.by_length;
  price_by_energy(region.parts, cost, &region.terrain, region.by_energy);
  return region;
}

RegionPlan planned(const RegionProblem& problem, std::string_view name, std::uint64_t seed) {
  const RegionPlannerEntry& planner = find_region_planner(name, "papers");
  RegionRequest request;
  request.problem = problem;
  request.parameters = resolve_parameters(planner.parameters, {}, "papers", "planner");
  request.seed = seed;
  return planner.plan(request);
}

// Its lines as they follow each other, joined by the transplanter's turns.
Path path_of(const SceneRegion& region, const RegionPlan& plan, const Vehicle& vehicle) {
  Plan lines;
  for (const RegionVisit visit : plan.visits) {
    const Polyline way_W = way_of(region.parts, visit);
    for (std::size_t i = 0; i + 1 < way_W.size(); i += 2) {
      lines.passes.push_back({PassKind::kSwath, {way_W[i], way_W[i + 1]}});
    }
  }
  return make_path(region.field, vehicle, lines, {});
}

struct DrivenScene {
  double length_m = 0.0;  // as the paper counts it
  double told_wh = 0.0;
  double wh = 0.0;
};

DrivenScene driven(const SceneRegion& region, const RegionPlan& plan, const Vehicle& vehicle,
                   const DriveCost& cost) {
  const Path path = path_of(region, plan, vehicle);
  const SoilMap soil = uniform_soil(*find_soil("firm"));
  const RunRecord run =
      simulate({region.field, region.terrain, soil, vehicle, path, SimulationOptions{}, {}});
  DrivenScene scene;
  scene.length_m = plan_cost(region.by_length, plan.visits);
  scene.told_wh = predicted_energy(path, &region.terrain, cost).energy_wh;
  scene.wh = run.outcome == Outcome::kFinished ? measure_run(path, run, {}).energy_wh : kNotDriven;
  return scene;
}

Json scene_json(const PaperScene& scene, const std::vector<SceneRegion>& regions, int runs,
                const Vehicle& vehicle, const DriveCost& cost) {
  Json json = {{"scene", scene.name}, {"printed_least", scene.printed}};
  for (const std::string_view planner : {"region_iga", "region_shade", "region_ga", "region_pso",
                                         "region_de", "region_local_search"}) {
    std::vector<double> gaps;
    std::vector<double> dearer;
    for (const SceneRegion& region : regions) {
      const double least_m = planned(region.by_length, "region_exact", 1).cost;
      const double least_wh = planned(region.by_energy, "region_exact", 1).cost;
      for (int seed = 1; seed <= runs; ++seed) {
        const RegionPlan plan =
            planned(region.by_length, planner, static_cast<std::uint64_t>(seed));
        gaps.push_back(100.0 * (plan.cost / least_m - 1.0));
        dearer.push_back(100.0 * (plan_cost(region.by_energy, plan.visits) / least_wh - 1.0));
      }
    }
    json["planners"].push_back({{"planner", planner},
                                {"median_gap_percent", median(gaps)},
                                {"median_above_least_energy_percent", median(dearer)}});
  }
  for (const SceneRegion& region : regions) {
    const DrivenScene shortest =
        driven(region, planned(region.by_length, "region_exact", 1), vehicle, cost);
    const DrivenScene measured =
        driven(region, planned(region.by_energy, "region_exact", 1), vehicle, cost);
    json["driven"].push_back({{"shortest_m", shortest.length_m},
                              {"shortest_told_wh", shortest.told_wh},
                              {"shortest_wh", shortest.wh},
                              {"measured_m", measured.length_m},
                              {"measured_told_wh", measured.told_wh},
                              {"measured_wh", measured.wh}});
  }
  return json;
}

void print_scene(const Json& scene) {
  fmt::print("003, {}: the paper's least length is {:.2f}\n", scene["scene"].get<std::string>(),
             scene["printed_least"].get<double>());
  fmt::print("  {:<22}{:>24}{:>28}\n", "planner, by length", "above the least length %",
             "above the least energy %");
  for (const Json& one : scene["planners"]) {
    fmt::print("  {:<22}{:>24.2f}{:>28.2f}\n", one["planner"].get<std::string>(),
               one["median_gap_percent"].get<double>(),
               one["median_above_least_energy_percent"].get<double>());
  }
  for (const Json& one : scene["driven"]) {
    fmt::print(
        "  driven: shortest plan {:.1f} m, told {:.1f}, took {:.1f} Wh; by measured costs "
        "{:.1f} m, {:.1f}, {:.1f} Wh\n",
        one["shortest_m"].get<double>(), one["shortest_told_wh"].get<double>(),
        one["shortest_wh"].get<double>(), one["measured_m"].get<double>(),
        one["measured_told_wh"].get<double>(), one["measured_wh"].get<double>());
  }
  std::fflush(stdout);
}

}  // namespace

Json run_scenes(const Scratch& scratch, const std::string& only, int runs, bool as_json) {
  const Vehicle vehicle = load_vehicle(kVehicle);
  Json all = Json::array();
  for (const PaperScene& scene : kScenes) {
    if (std::string_view(scene.name).find(only) == std::string_view::npos) continue;
    measure_vehicle(scratch, kVehicle, 2);
    std::vector<std::string> notes;
    const DriveCost cost =
        read_drive_cost(scratch.folder / (std::string(kVehicle) + ".yaml"), vehicle, "firm", notes);
    std::vector<SceneRegion> regions;
    for (int i = 0; i < kRegions; ++i) regions.push_back(region_of(scene, i, cost));
    const Json json = scene_json(scene, regions, runs, vehicle, cost);
    if (!as_json) print_scene(json);
    all.push_back(json);
  }
  return all;
}

}  // namespace headland::bench

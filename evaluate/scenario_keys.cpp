#include "evaluate/scenario_keys.h"

namespace headland {
namespace {

constexpr NumberKey kNumbers[] = {
    {"terrain.cell_m",
     {kMinCell_m, kMaxCell_m, true},
     [](Scenario& s) -> double& { return s.terrain.cell_m; }},
    {"terrain.margin_m",
     {kMinMargin_m, kMaxMargin_m},
     [](Scenario& s) -> double& { return s.terrain.margin_m; }},
    {"terrain.micro_relief.rms_m",
     {0.0, kMaxRoughness_m},
     [](Scenario& s) -> double& { return s.terrain.micro_relief.rms_m; }},
    {"terrain.micro_relief.correlation_m",
     {kMinCorrelation_m, kMaxCorrelation_m},
     [](Scenario& s) -> double& { return s.terrain.micro_relief.correlation_m; }},
    {"implement.working_width_m",
     {0.2, 60.0},
     [](Scenario& s) -> double& { return s.working_width_m; }},
    {"path.clearance_m", {0.0, 20.0}, [](Scenario& s) -> double& { return s.path.clearance_m; }},
    {"path.tolerance_m",
     {kMinTrackTolerance_m, kMaxTrackTolerance_m},
     [](Scenario& s) -> double& { return s.path_tolerance_m; }},
    {"simulation.rate_hz",
     {60.0, 2000.0},
     [](Scenario& s) -> double& { return s.simulation.rate_hz; }},
    {"simulation.record_hz",
     {0.01, 2000.0},
     [](Scenario& s) -> double& { return s.simulation.record_hz; }},
    {"simulation.soc_start",
     {0.05, 1.0},
     [](Scenario& s) -> double& { return s.simulation.soc_start; }},
    {"simulation.max_time_s",
     {0.0, 1e6},
     [](Scenario& s) -> double& { return s.simulation.max_time_s; }},
    {"simulation.max_overrun_m",
     {0.0, 1000.0},
     [](Scenario& s) -> double& { return s.simulation.max_overrun_m; }},
    {"simulation.footprint_spacing_m",
     {0.01, 1.0},
     [](Scenario& s) -> double& { return s.simulation.footprint_spacing_m; }},
    {"simulation.steering_latency_s",
     {0.0, 2.0},
     [](Scenario& s) -> double& { return s.simulation.steering_latency_s; }},
    {"positioning.noise_m",
     {0.0, 1.0},
     [](Scenario& s) -> double& { return s.simulation.positioning.noise_m; }},
    {"positioning.noise_time_s",
     {0.0, 3600.0},
     [](Scenario& s) -> double& { return s.simulation.positioning.noise_time_s; }},
    {"positioning.latency_s",
     {0.0, 2.0},
     [](Scenario& s) -> double& { return s.simulation.positioning.latency_s; }},
    {"coverage.cell_m", {0.02, 5.0}, [](Scenario& s) -> double& { return s.coverage_cell_m; }},
};

constexpr LimitKey kLimits[] = {
    {"verdict.coverage_ratio_min", true, 1.0,
     [](Scenario& s) -> Threshold& { return s.verdict.coverage_ratio_min; }},
    {"verdict.overlap_ratio_max", false, 10.0,
     [](Scenario& s) -> Threshold& { return s.verdict.overlap_ratio_max; }},
    {"verdict.outside_area_ratio_max", false, 10.0,
     [](Scenario& s) -> Threshold& { return s.verdict.outside_area_ratio_max; }},
    {"verdict.slip_max", false, 1.0, [](Scenario& s) -> Threshold& { return s.verdict.slip_max; }},
    {"verdict.load_transfer_max", false, 1.0,
     [](Scenario& s) -> Threshold& { return s.verdict.load_transfer_max; }},
    {"verdict.track_rms_working_m_max", false, 100.0,
     [](Scenario& s) -> Threshold& { return s.verdict.track_rms_working_m_max; }},
    {"verdict.track_error_m_max", false, 100.0,
     [](Scenario& s) -> Threshold& { return s.verdict.track_error_m_max; }},
    {"verdict.boundary_overrun_m_max", false, 1000.0,
     [](Scenario& s) -> Threshold& { return s.verdict.boundary_overrun_m_max; }},
    {"verdict.belly_contact_m_max", false, 10.0,
     [](Scenario& s) -> Threshold& { return s.verdict.belly_contact_m_max; }},
    {"verdict.reserve_soc_min", true, 1.0,
     [](Scenario& s) -> Threshold& { return s.verdict.reserve_soc_min; }},
    {"verdict.ledger_residual_ratio_max", false, 1.0,
     [](Scenario& s) -> Threshold& { return s.verdict.ledger_residual_ratio_max; }},
};

// Sections, words, flags, coordinates and whole numbers.
constexpr std::string_view kOtherKeys[] = {
    "name",
    "field",
    "field.file",
    "field.grid_map",
    "field.cell_m",
    "field.margin_m",
    "field.layer",
    "field.part",
    "field.crs",
    "field.boundary",
    "field.holes",
    "field.to_work",
    "field.obstacles",
    "field.obstacles.kind",
    "field.obstacles.at",
    "field.obstacles.radius_m",
    "field.obstacles.line",
    "field.obstacles.thickness_m",
    "field.obstacles.height_m",
    "field.entry",
    "terrain",
    "terrain.file",
    "terrain.crs",
    "terrain.generator",
    "terrain.micro_relief",
    "terrain.seed",
    "soil",
    "soil.name",
    "soil.cone_index_kpa",
    "soil.friction",
    "soil.rolling_resistance",
    "soil.slip_stiffness",
    "soil.lateral_gamma_rad",
    "soil.texture",
    "soil.file",
    "soil.layer",
    "soil.crs",
    "soil.cell_m",
    "soil.default",
    "soil.default.name",
    "soil.default.cone_index_kpa",
    "soil.default.friction",
    "soil.default.rolling_resistance",
    "soil.default.slip_stiffness",
    "soil.default.lateral_gamma_rad",
    "soil.default.texture",
    "vehicle",
    "implement",
    "planner",
    "planner.name",
    "planner.ab_line",
    "planner.headland_edges",
    "planner.headland_edges.at",
    "planner.headland_edges.hole",
    "planner.headland_edges.edge",
    "planner.headland_edges.passes",
    "planner.headland_edges.width_m",
    "planner.start",
    "planner.end",
    "planner.closed",
    "planner.direction_deg",
    "planner.predict",
    "planner.cost",
    "planner.cost.file",
    "planner.cost.objective",
    "planner.cost.repeat",
    "planner.cost.turn",
    "planner.cost.u_turn",
    "planner.cost.tractor",
    "planner.stop",
    "planner.stop.iterations",
    "planner.stop.evaluations",
    "planner.stop.seconds",
    "planner.stop.stagnation",
    "planner.perturb",
    "planner.perturb.changes",
    "planner.perturb.seed",
    "path",
    "path.file",
    "path.allow_overrun",
    "path.keep_off_worked",
    "path.continuous_turns",
    "simulation",
    "positioning",
    "coverage",
    "verdict",
    "seed",
};

}  // namespace

std::span<const NumberKey> number_keys() { return kNumbers; }

std::span<const LimitKey> limit_keys() { return kLimits; }

std::vector<std::string> scenario_key_paths() {
  std::vector<std::string> paths(std::begin(kOtherKeys), std::end(kOtherKeys));
  for (const NumberKey& key : kNumbers) paths.emplace_back(key.path);
  for (const LimitKey& key : kLimits) {
    const std::string path(key.path);
    paths.insert(paths.end(), {path, path + ".warn", path + ".fail"});
  }
  return paths;
}

std::vector<std::string> keys_in_section(std::string_view section) {
  const std::string prefix = section.empty() ? "" : std::string(section) + ".";
  std::vector<std::string> keys;
  for (const std::string& path : scenario_key_paths()) {
    if (!path.starts_with(prefix)) continue;
    const std::string key = path.substr(prefix.size());
    if (!key.empty() && key.find('.') == std::string::npos) keys.push_back(key);
  }
  return keys;
}

}  // namespace headland

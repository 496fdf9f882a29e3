#include "evaluate/report_data.h"

#include <algorithm>
#include <cmath>

#include "evaluate/geojson.h"
#include "evaluate/ground_patches.h"
#include "evaluate/metrics.h"
#include "evaluate/report_assumptions.h"
#include "evaluate/report_movements.h"
#include "evaluate/report_series.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

Json place(const Eigen::Vector2d& p_W) { return {rounded(p_W.x(), 2), rounded(p_W.y(), 2)}; }

Json ring_json(const Ring& ring) {
  Json json = Json::array();
  for (const Eigen::Vector2d& p_W : ring) json.push_back(place(p_W));
  return json;
}

Json field_json(const RunPageSource& source) {
  const Field& field = source.stage.field;
  const Heightfield& terrain = source.stage.terrain;
  Json json;
  json["area_m2"] = rounded(field_area_m2(field), 1);
  json["boundary"] = ring_json(field.boundary);
  json["holes"] = Json::array();
  for (const Ring& hole : field.holes) json["holes"].push_back(ring_json(hole));
  json["obstacles"] = Json::array();
  for (const Obstacle& obstacle : field.obstacles) {
    json["obstacles"].push_back({{"kind", obstacle_kind_name(obstacle.kind)},
                                 {"at", place(obstacle.p_W)},
                                 {"to", place(obstacle.p_W + obstacle.run_W)},
                                 {"radius_m", obstacle.radius_m},
                                 {"height_m", obstacle.height_m}});
  }
  json["soil"] = soil_text(source.scenario.soil);
  json["terrain"] = source.scenario.terrain.file.empty()
                        ? source.scenario.terrain.generator
                        : source.scenario.terrain.file.filename().string();
  json["terrain_is_file"] = !source.scenario.terrain.file.empty();
  double low_m =
      surface_at(terrain, field.boundary.front().x(), field.boundary.front().y()).height_m;
  double high_m = low_m;
  std::vector<double> slopes;
  for (int row = 0; row < terrain.rows; ++row) {
    for (int column = 0; column < terrain.columns; ++column) {
      const Eigen::Vector2d p_W = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(column, row);
      if (!inside_ring(field.boundary, p_W)) continue;
      const SurfacePoint ground = surface_at(terrain, p_W.x(), p_W.y());
      low_m = std::min(low_m, ground.height_m);
      high_m = std::max(high_m, ground.height_m);
      slopes.push_back(ground.gradient.norm());
    }
  }
  json["height_m"] = {rounded(low_m, 2), rounded(high_m, 2)};
  if (!slopes.empty()) {
    std::sort(slopes.begin(), slopes.end());
    json["slope_median"] = rounded(slopes[slopes.size() / 2], 4);
    json["slope_95"] = rounded(slopes[slopes.size() * 19 / 20], 4);
  }
  return json;
}

Json vehicle_json(const Vehicle& vehicle) {
  const Axle* axles[] = {&vehicle.rear, &vehicle.rear, &vehicle.front, &vehicle.front};
  Json json;
  json["name"] = vehicle.name;
  json["description"] = vehicle.description;
  json["steering"] = steering_word(vehicle.steering.kind);
  json["mass_kg"] = total_mass_kg(vehicle);
  json["wheelbase_m"] = wheelbase_m(vehicle);
  json["length_m"] = vehicle.body.length_m;
  json["width_m"] = vehicle.body.width_m;
  json["turning_radius_m"] = min_turning_radius_m(vehicle);
  json["work_speed_mps"] = vehicle.driver.work_speed_mps;
  json["implement"] = vehicle.implement.name;
  json["working_width_m"] = vehicle.implement.working_width_m;
  json["trailed"] = vehicle.implement.trailing.has_value();
  json["battery_wh"] = nominal_energy_wh(vehicle.battery);
  json["empty_soc"] = vehicle.battery.empty_soc;
  json["motor_power_w"] = vehicle.motor.max_power_w * motor_count(vehicle);
  json["side_tip_rad"] = side_stability_angle_rad(vehicle);
  json["nose_up_tip_rad"] = nose_up_stability_angle_rad(vehicle);
  // How far each wheel turns for a steering angle of the vehicle: the page draws it turning.
  for (std::size_t i = 0; i < std::size(axles); ++i) {
    const double left_m = (i % 2 == 0 ? 0.5 : -0.5) * axles[i]->track_m;
    json["wheels_B"].push_back({axles[i]->x_B_m, left_m});
  }
  return json;
}

// The planned lines, thinned where they are straight.
Json planned_json(const Path& path) {
  constexpr double kTurn_rad = 0.04;
  constexpr double kFurthest_m = 25.0;
  Json json = Json::array();
  for (const PathSegment& segment : path.segments) {
    if (segment.points.empty()) continue;
    Json line = Json::array();
    const PathPoint* kept = nullptr;
    for (const PathPoint& point : segment.points) {
      const bool end = &point == &segment.points.back();
      if (kept != nullptr && !end && std::abs(point.heading_rad - kept->heading_rad) < kTurn_rad &&
          (point.p_W - kept->p_W).norm() < kFurthest_m) {
        continue;
      }
      kept = &point;
      line.push_back(rounded(point.p_W.x(), 2));
      line.push_back(rounded(point.p_W.y(), 2));
    }
    json.push_back({{"kind", path_kind_name(segment.kind)},
                    {"gear", gear_name(segment.gear)},
                    {"line", std::move(line)}});
  }
  return json;
}

// Figures need the whole record.
Json judged_json(const RunPageSource& source) {
  Json json = Json::array();
  if (!source.recorded.missing.empty()) return json;
  const Metrics metrics =
      measure_run(source.recorded.path, source.recorded.run, coverage_figures(source.coverage));
  for (const JudgedFigure& figure :
       judged_figures(source.recorded.run, metrics, source.scenario.verdict)) {
    json.push_back({{"what", figure.what},
                    {"value", figure.value},
                    {"warn", figure.warn},
                    {"fail", figure.fail},
                    {"at_least", figure.at_least},
                    {"grade", grade_name(figure.grade)}});
  }
  return json;
}

Json limits_json(const VerdictLimits& limits) {
  const auto pair = [](const Threshold& limit) { return Json{limit.warn, limit.fail}; };
  return {{"slip", pair(limits.slip_max)},
          {"load_transfer", pair(limits.load_transfer_max)},
          {"track_error_m", pair(limits.track_error_m_max)},
          {"reserve_soc", pair(limits.reserve_soc_min)}};
}

Json patches_json(const CoverageRaster& coverage) {
  constexpr double kLeast_m2 = 0.5;
  constexpr std::size_t kMost = 200;
  Json json = Json::array();
  for (const GroundPatch& patch : missed_patches(coverage, kLeast_m2)) {
    if (json.size() == kMost) break;
    json.push_back({{"at", place(patch.p_W)}, {"area_m2", rounded(patch.area_m2, 2)}});
  }
  return json;
}

// Worked once, twice, three times or more, missed; and worked outside.
Json areas_json(const CoverageRaster& coverage) {
  const double cell_m2 = coverage.cell_m * coverage.cell_m;
  std::array<double, 5> areas{};
  for (std::size_t i = 0; i < coverage.times.size(); ++i) {
    const std::size_t times = std::min<std::size_t>(coverage.times[i], 3);
    if (coverage.in_field[i] != 0) areas[times == 0 ? 3 : times - 1] += cell_m2;
    if (coverage.in_field[i] == 0 && times > 0) areas[4] += cell_m2;
  }
  return {{"once", areas[0]},
          {"twice", areas[1]},
          {"more", areas[2]},
          {"missed", areas[3]},
          {"outside", areas[4]}};
}

Json assumptions_json(const Vehicle& vehicle) {
  Json json = Json::array();
  for (const Assumption& assumption : assumptions_of(vehicle.folder / "drive.yaml")) {
    json.push_back({{"key", assumption.key}, {"value", assumption.value}, {"why", assumption.why}});
  }
  return json;
}

Json scenario_json(const Scenario& scenario) {
  Json json;
  json["name"] = scenario.name;
  json["seed"] = scenario.seed;
  json["planner"] = scenario.path_file.empty() ? scenario.planner.name : "";
  json["path_file"] = scenario.path_file.filename().string();
  json["text"] = scenario_yaml(scenario);
  return json;
}

}  // namespace

Json run_page_json(const RunPageSource& source, const std::string& version) {
  const RecordedRun& recorded = source.recorded;
  Json json;
  json["kind"] = "run";
  json["version"] = version;
  json["missing"] = recorded.missing;
  json["scenario"] = scenario_json(source.scenario);
  json["metrics"] = recorded.metrics;
  json["judged"] = judged_json(source);
  json["limits"] = limits_json(source.scenario.verdict);
  json["areas_m2"] = areas_json(source.coverage);
  json["field"] = field_json(source);
  json["vehicle"] = vehicle_json(source.stage.vehicle);
  json["planned"] = planned_json(recorded.path);
  json["series"] = series_json(recorded.run.samples, source.wh_per_m);
  json["footprints"] = footprints_json(recorded.run.footprints);
  json["movements"] = movements_json(recorded.path, recorded.run.segments);
  json["segment_kinds"] = Json::array();
  for (const PathSegment& segment : recorded.path.segments) {
    json["segment_kinds"].push_back(path_kind_name(segment.kind));
  }
  json["tracking"] = tracking_histogram_json(recorded.run.samples);
  json["missed_patches"] = patches_json(source.coverage);
  json["assumptions"] = assumptions_json(source.stage.vehicle);
  return json;
}

}  // namespace headland

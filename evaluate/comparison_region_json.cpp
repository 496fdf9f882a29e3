#include "evaluate/comparison_region_json.h"

#include <numbers>

namespace headland {
namespace {

using RegionJson = nlohmann::ordered_json;

constexpr double kDegrees = 180.0 / std::numbers::pi;

RegionJson point_json(const Eigen::Vector2d& p_W) { return {p_W.x(), p_W.y()}; }

RegionJson place_or_free(const std::optional<Eigen::Vector2d>& p_W) {
  return p_W ? point_json(*p_W) : RegionJson("free");
}

RegionJson ring_json(const Ring& ring) {
  RegionJson json = RegionJson::array();
  for (const Eigen::Vector2d& p_W : ring) json.push_back(point_json(p_W));
  return json;
}

RegionJson cost_or_null(const std::optional<double>& cost) {
  return cost ? RegionJson(*cost) : RegionJson();
}

}  // namespace

nlohmann::ordered_json region_json(const ComparedMap& field) {
  const ComparedRegion& region = *field.region;
  RegionJson json = {
      {"name", field.name},
      {"area_m2", field_area_m2(region.field)},
      {"width_m", region.options.width_m},
      {"method", decomposition_name(region.options.decomposition)},
      {"least_area_m2", region.options.least_m2},
      {"small_parts", region.options.small == SmallParts::kDrop ? "drop" : "merge"},
      {"merge", region.options.merge},
      {"start", place_or_free(region.start_W)},
      {"end", place_or_free(region.end_W)},
      {"dropped_parts", region.parts.dropped_W.size()},
      {"dropped_m2", dropped_m2(region.parts)},
      {region.cost ? "least_energy_wh" : "least_length_m",
       {{"own", cost_or_null(region.least_own)}, {"any", cost_or_null(region.least_any)}}},
      {"boundary", ring_json(region.field.boundary)}};
  json["holes"] = RegionJson::array();
  for (const Ring& hole : region.field.holes) json["holes"].push_back(ring_json(hole));
  for (const RegionPart& part : region.parts.parts) {
    json["parts"].push_back({{"area_m2", signed_area_m2(part.outline_W)},
                             {"sweep_deg", part.sweep_rad * kDegrees},
                             {"outline", ring_json(corners_of(part.outline_W))}});
  }
  return json;
}

nlohmann::ordered_json visits_json(const ComparedRegion& region, PartSweeps sweeps,
                                   const RegionPlan& plan) {
  const RegionProblem problem = region_problem(region, sweeps);
  const std::vector<WorkedPart> parts = worked_parts(region, sweeps);
  RegionJson json = RegionJson::array();
  for (const RegionVisit visit : plan.visits) {
    const RegionVariant& variant = variant_of(problem, visit);
    const PartSweep& sweep = sweep_of(parts, visit);
    json.push_back({{"part", visit.part},
                    {"variant", visit.variant},
                    {"sweep_deg", sweep.direction_rad * kDegrees},
                    {"entry", point_json(variant.entry_W)},
                    {"exit", point_json(variant.exit_W)},
                    {region.cost ? "energy_wh" : "length_m", variant.cost}});
  }
  return json;
}

}  // namespace headland

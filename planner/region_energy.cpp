#include "planner/region_energy.h"

#include <fmt/format.h>

#include "planner/indexed.h"
#include "planner/line_energy.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Two points a line, which is worked; between lines the implement is raised.
double way_wh(const Polyline& way_W, const DriveCost& cost, const Heightfield* terrain) {
  double sum_wh = 0.0;
  for (std::size_t i = 1; i < way_W.size(); ++i) {
    sum_wh += line_wh(i % 2 == 1 ? cost.working : cost.raised, terrain, way_W[i - 1], way_W[i]);
  }
  return sum_wh;
}

}  // namespace

void price_links(const DriveCost& cost, const Heightfield* terrain, RegionProblem& problem) {
  std::vector<const RegionVariant*> all;
  for (std::vector<RegionVariant>& variants : problem.parts) {
    for (RegionVariant& variant : variants) {
      variant.number = all.size();
      all.push_back(&variant);
    }
  }
  if (all.size() > kMostPricedVariants) {
    throw InputError(kRegionPlanSource, "parts", fmt::format("{} ways to work them", all.size()),
                     fmt::format("at most {} in all with measured costs", kMostPricedVariants));
  }
  RegionLinks links;
  for (const RegionVariant* one : all) {
    for (const RegionVariant* next : all) {
      links.between_wh.push_back(line_wh(cost.transit, terrain, one->exit_W, next->entry_W));
    }
    links.from_start_wh.push_back(
        problem.start_W ? line_wh(cost.transit, terrain, *problem.start_W, one->entry_W) : 0.0);
    links.to_end_wh.push_back(
        problem.end_W ? line_wh(cost.transit, terrain, one->exit_W, *problem.end_W) : 0.0);
  }
  problem.links = std::move(links);
}

void price_by_energy(const std::vector<WorkedPart>& parts, const DriveCost& cost,
                     const Heightfield* terrain, RegionProblem& problem) {
  for (int part = 0; part < problem.size(); ++part) {
    for (int variant = 0; variant < static_cast<int>(at(problem.parts, part).size()); ++variant) {
      at(at(problem.parts, part), variant).cost =
          way_wh(way_of(parts, {part, variant}), cost, terrain);
    }
  }
  price_links(cost, terrain, problem);
}

}  // namespace headland

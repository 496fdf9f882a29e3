#include "planner/algorithms/decomposed.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "planner/algorithms/region_exact.h"
#include "planner/algorithms/region_local_search.h"
#include "planner/edge_filling.h"
#include "planner/headland_order.h"
#include "planner/headland_rings.h"
#include "planner/line_energy.h"
#include "planner/polygon.h"
#include "planner/region_energy.h"
#include "planner/region_parts.h"
#include "planner/request_check.h"
#include "planner/swath_cells.h"
#include "planner/swath_plan.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Dynamic programming for more would take longer than all else.
constexpr int kMostExactPieces = 12;
constexpr std::size_t kCorners = 4;  // that a piece may be begun at

// The ground with fewer corners, grown so that nothing of it is outside.
PolygonSet outlined(const PolygonSet& ground, double width_m) {
  const double bend_m = 0.5 * width_m;
  return buffered(simplified(ground, bend_m), bend_m, Join::kMitre);
}

std::vector<PolygonSet> parts_of(const PolygonSet& ground, const PlanRequest& request) {
  const double width_m = request.working_width_m;
  PartsOptions options;
  const std::string& decomposition = word(request.parameters, "decomposition");
  for (const Decomposition each :
       {Decomposition::kConvex, Decomposition::kTrapezoidal, Decomposition::kBoustrophedon}) {
    if (decomposition_name(each) == decomposition) options.decomposition = each;
  }
  options.width_m = width_m;
  options.least_m2 = kLeastPart * width_m * width_m;
  options.small = SmallParts::kMerge;
  options.merge = true;
  std::vector<PolygonSet> parts;
  for (const RegionPart& part :
       region_parts(outlined(ground, width_m), options, request.cancelled).parts) {
    PolygonSet inside = intersection(ground, {{PolygonPart{part.outline_W, {}}}});
    if (!inside.parts.empty()) parts.push_back(std::move(inside));
  }
  return parts;
}

// Swaths of each part in its own direction, or of all of them in one where that costs no more.
std::vector<SwathGrid> grids_of(const PlanRequest& request, const Headland& headland) {
  SwathGround ground = swath_ground(headland);
  const SwathGridCost cost = swath_cost(request, ground, headland.narrow);
  std::vector<SwathGrid> whole{chosen_swaths(request, ground, headland.narrow)};
  const bool given =
      request.ab_line_W || number_unless_word(request.parameters, "swath_direction_deg");
  if (given || headland.inner.parts.empty()) return whole;
  std::vector<SwathGrid> grids;
  double sum = 0.0;
  PlanRequest for_part = request;
  for (const PolygonSet& part : parts_of(headland.inner, request)) {
    ground.inner = part;
    for_part.field.boundary = part.parts.front().outer;  // whose edges are directions to try
    for_part.field.holes = part.parts.front().holes;
    grids.push_back(chosen_swaths(for_part, ground, headland.narrow));
    sum += cost(grids.back());
  }
  return sum < cost(whole.front()) ? grids : whole;
}

// Swaths that are driven one after the other.
struct Piece {
  const SwathGrid* grid = nullptr;
  SwathCell cell;
};

CellVisit visit_by_corner(int corner) { return {0, (corner & 1) != 0, (corner & 2) != 0}; }

std::vector<Piece> pieces_of(const std::vector<SwathGrid>& grids, const PlanRequest& request) {
  std::vector<Piece> pieces;
  for (const SwathGrid& grid : grids) {
    for (SwathCell& cell : patterned_cells(grid, request)) {
      pieces.push_back({&grid, std::move(cell)});
    }
  }
  return pieces;
}

std::vector<RegionVisit> order_of(const std::vector<Piece>& pieces,
                                  const std::optional<Eigen::Vector2d>& start_W,
                                  const PlanRequest& request) {
  RegionRequest region;
  region.problem.start_W = start_W;
  const bool priced = request.cost != nullptr && kCorners * pieces.size() <= kMostPricedVariants;
  const auto pass_cost = [&](const Pass& pass) {
    if (!priced) return length_m(pass.points_W);
    return line_wh(request.cost->working, request.terrain, pass.points_W.front(),
                   pass.points_W.back());
  };
  for (const Piece& piece : pieces) {
    std::vector<RegionVariant>& variants = region.problem.parts.emplace_back();
    for (int corner = 0; corner < static_cast<int>(kCorners); ++corner) {
      const std::vector<Pass> passes = passes_of(*piece.grid, piece.cell, visit_by_corner(corner));
      RegionVariant variant{passes.front().points_W.front(), passes.back().points_W.back(), 0.0};
      for (const Pass& pass : passes) variant.cost += pass_cost(pass);
      variants.push_back(variant);
    }
  }
  if (priced) price_links(*request.cost, request.terrain, region.problem);
  region.seed = request.seed;
  region.cancelled = request.cancelled;
  if (region.problem.size() <= kMostExactPieces) return plan_region_exact(region).visits;
  region.parameters =
      resolve_parameters(region_local_search_parameters(), {}, "plan", "region_local_search");
  return plan_region_local_search(region).visits;
}

void append_pieces(const std::vector<SwathGrid>& grids, const PlanRequest& request,
                   std::vector<Pass>& passes) {
  const std::vector<Piece> pieces = pieces_of(grids, request);
  if (pieces.empty()) return;
  const auto start_W = end_of(passes, request.field.entry_W);
  std::vector<Pass> swaths;
  for (const RegionVisit& visit : order_of(pieces, start_W, request)) {
    const Piece& piece = pieces[static_cast<std::size_t>(visit.part)];
    for (Pass& pass : passes_of(*piece.grid, piece.cell, visit_by_corner(visit.variant))) {
      swaths.push_back(std::move(pass));
    }
  }
  if (is_optimised(request)) swaths = improved_order(std::move(swaths), request, start_W);
  for (Pass& pass : swaths) passes.push_back(std::move(pass));
}

}  // namespace

std::span<const ParameterSpec> decomposed_parameters() {
  static const std::vector<ParameterSpec> kParameters = [] {
    std::vector<ParameterSpec> all(headland_parameters().begin(), headland_parameters().end());
    all.push_back({"decomposition",
                   std::string("convex"),
                   0.0,
                   0.0,
                   {"convex", "trapezoidal", "boustrophedon"},
                   "how the ground inside the headland is cut into parts"});
    for (const ParameterSpec& spec : swath_parameters()) {
      all.push_back(spec);
      // Across parts it is the order of the parts that counts.
      if (spec.name == "swath_order") std::erase(all.back().choices, "optimised");
    }
    return all;
  }();
  return kParameters;
}

Plan plan_decomposed(const PlanRequest& asked_for) {
  check_swath_parameters(asked_for.parameters, "plan", "");
  const PlanRequest request = checked(asked_for);
  const Headland headland = make_headland(request, asked_rounds(request));
  const std::vector<SwathGrid> grids = grids_of(request, headland);
  Plan plan;
  plan.planner = "decomposed";
  plan.remedies.off_rows = ways_off_rows(request);
  plan.swath_direction_rad = grids.front().direction_rad;
  plan.headland_width_m = headland.width_m;
  plan.headland_edges = headland.edges;
  if (differs_by_edge(headland)) {
    plan.kept_whole = headland.inside;
    for (const SwathGrid& grid : grids) {
      plan.kept_whole = kept_whole(request, headland.edged, *plan.kept_whole, grid.direction_rad);
    }
  }
  append_rings_before(headland, request, plan.passes);
  const bool headland_first = word(request.parameters, "headland_order") == "first";
  if (headland_first) append_passes_beside(request, headland, grids, plan.passes);
  append_pieces(grids, request, plan.passes);
  if (!headland_first) append_passes_beside(request, headland, grids, plan.passes);
  append_rings_after(headland, request, plan.passes);
  for (const Pass& pass : plan.passes) plan.planned_length_m += length_m(pass.points_W);
  return plan;
}

}  // namespace headland

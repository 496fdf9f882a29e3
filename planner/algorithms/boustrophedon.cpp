#include "planner/algorithms/boustrophedon.h"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "planner/edge_filling.h"
#include "planner/edge_passes.h"
#include "planner/fill_passes.h"
#include "planner/free_space.h"
#include "planner/headland_by_edge.h"
#include "planner/headland_order.h"
#include "planner/headland_rings.h"
#include "planner/pass_order.h"
#include "planner/request_check.h"
#include "planner/swath_plan.h"
#include "planner/work_line.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

bool covers_corners(const Parameters& parameters) {
  return word(parameters, "headland_corners") == "covered";
}

// Patches are worked from the largest on until no more than this is left of the field; smaller ones
// than the smallest are not worth their way.
constexpr double kLeftRatio = 0.002;
constexpr double kLargestPatch_m2 = 4.0;
constexpr double kSmallestPatch_m2 = 0.125;

void append_swaths(const SwathGrid& grid, const PlanRequest& request, std::vector<Pass>& passes) {
  for (Pass& pass : ordered_swaths(grid, request, end_of(passes, request.field.entry_W))) {
    passes.push_back(std::move(pass));
  }
}

void append_filling(const PlanRequest& request, double direction_rad, const FreeSpace& space,
                    WorkedGround& ground, std::vector<Pass>& passes) {
  FillOptions options;
  options.working_width_m = request.working_width_m;
  options.turning_radius_m = request.turning_radius_m;
  options.clearance_m = request.clearance_m;
  options.overhang_m = number(request.parameters, "overhang_m");
  options.directions_rad = {direction_rad};
  options.cancelled = request.cancelled;
  std::vector<Pass> filling;
  options.least_patch_m2 = kLargestPatch_m2;
  for (; options.least_patch_m2 >= kSmallestPatch_m2; options.least_patch_m2 *= 0.5) {
    for (Pass& pass : fill_passes(space, options, ground)) filling.push_back(std::move(pass));
    if (to_work_m2(ground) <= kLeftRatio * field_area_m2(request.field)) break;
  }
  for (Pass& pass : ordered(std::move(filling), end_of(passes, request.field.entry_W), space,
                            request.turning_radius_m, request.cancelled)) {
    passes.push_back(std::move(pass));
  }
}

Plan plan_along(const SwathGrid& grid, const Headland& headland, const PlanRequest& request) {
  Plan plan;
  plan.planner = "boustrophedon";
  plan.remedies.off_rows = ways_off_rows(request);
  plan.swath_direction_rad = grid.direction_rad;
  plan.headland_width_m = headland.width_m;
  plan.headland_edges = headland.edges;
  if (differs_by_edge(headland)) {
    plan.kept_whole = kept_whole(request, headland.edged, headland.inside, grid.direction_rad);
  }
  return plan;
}

// Of the passes of one round, in the order of its rings.
void set_gaps(std::span<EdgePass> round) {
  for (std::size_t begin = 0, end = 0; begin < round.size(); begin = end) {
    while (end < round.size() && round[end].ring == round[begin].ring) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      const EdgePass& before = round[i == begin ? end - 1 : i - 1];
      round[i].gap_m = (round[i].line_W.front() - before.line_W.back()).norm();
    }
  }
}

// Appends a round's passes as far as they lie along edges that have it, and works their ground.
void append_round(const PlanRequest& request, const FreeSpace& space, const PolygonSet& field,
                  double distance_m, int round, const Headland& headland, WorkedGround& ground,
                  std::vector<EdgePass>& edges) {
  const EdgeOptions options{number(request.parameters, "overhang_m"), 1.0};
  if (!differs_by_edge(headland)) {
    for (EdgePass& edge : edge_round(request, space, field, distance_m, round, options, ground)) {
      edges.push_back(std::move(edge));
    }
    return;
  }
  WorkedGround wanted = ground;
  leave_to_work(
      wanted, zone_beside(headland.edged, {round + 1}, distance_m + 0.5 * request.working_width_m));
  const std::size_t first = edges.size();
  for (EdgePass& edge : edge_round(request, space, field, distance_m, round, options, wanted)) {
    for (Polyline& line_W :
         stretches_along(headland.edged, edge.line_W, distance_m, request.working_width_m, round)) {
      edge.closed = edge.closed && line_W.size() == edge.line_W.size();
      const Pass pass{PassKind::kHeadlandPass, line_W};
      work_driven(ground, work_line(pass, request.implement_x_B_m).points, request.implement_x_B_m,
                  request.working_width_m);
      edges.push_back({edge.round, edge.ring, edge.around_hole, edge.closed, std::move(line_W)});
    }
  }
  set_gaps(std::span(edges).subspan(first));
}

// Everything that can be reached is worked, corners too.
Plan plan_whole(const PlanRequest& request, int rounds) {
  const double width_m = request.working_width_m;
  const double first_m = edge_distance_m(request);
  const FreeSpace space = free_space(request.field, hull_of(request));
  WorkedGround ground = ground_to_work(request.field);
  const PolygonSet field = from_field(request.field, kObstacleClearances * request.clearance_m);
  const Headland headland = headland_ground(request, field, rounds, first_m);
  std::vector<EdgePass> edges;
  for (int round = 0; round < headland.rounds; ++round) {
    append_round(request, space, field, first_m + round * width_m, round, headland, ground, edges);
  }
  const SwathGrid grid = chosen_swaths(request, swath_ground(headland), headland.narrow);
  Plan plan = plan_along(grid, headland, request);
  work_swaths(ground, grid, width_m);
  const bool headland_first = word(request.parameters, "headland_order") == "first";
  if (headland_first) append_filling(request, grid.direction_rad, space, ground, plan.passes);
  append_edge_passes_before(edges, request, plan.passes);
  append_swaths(grid, request, plan.passes);
  append_edge_passes_after(edges, request, plan.passes);
  if (!headland_first) append_filling(request, grid.direction_rad, space, ground, plan.passes);
  for (const Pass& pass : plan.passes) plan.planned_length_m += length_m(pass.points_W);
  return plan;
}

}  // namespace

std::span<const ParameterSpec> boustrophedon_parameters() {
  static const std::vector<ParameterSpec> kParameters = [] {
    std::vector<ParameterSpec> all(headland_parameters().begin(), headland_parameters().end());
    all.push_back({"headland_corners",
                   std::string("rounded"),
                   0.0,
                   0.0,
                   {"covered", "rounded"},
                   "rounds right into the corners, or past them in arcs that leave them unworked"});
    all.push_back(
        {"overhang_m",
         0.0,
         0.0,
         10.0,
         {},
         "with headland_corners covered: how far the implement may work beyond the field"});
    all.insert(all.end(), swath_parameters().begin(), swath_parameters().end());
    return all;
  }();
  return kParameters;
}

void check_boustrophedon(const Parameters& parameters, const std::string& source,
                         const std::string& where) {
  check_swath_parameters(parameters, source, where);
  const double overhang_m = number(parameters, "overhang_m");
  if (overhang_m > 0.0 && !covers_corners(parameters)) {
    throw InputError(source, key_path(where, "overhang_m"), fmt::format("{}", overhang_m),
                     "only with headland_corners covered");
  }
}

Plan plan_boustrophedon(const PlanRequest& asked_for) {
  check_boustrophedon(asked_for.parameters, "plan", "");
  if (covers_corners(asked_for.parameters) && asked_for.forward_only) {
    throw InputError("plan", "headland_corners", "covered",
                     "rounded with a trailed implement, which cannot be backed into a corner");
  }
  const PlanRequest request = checked(asked_for);
  const int rounds = asked_rounds(request);
  if (covers_corners(request.parameters)) return plan_whole(request, rounds);
  const Headland headland = make_headland(request, rounds);
  const SwathGrid grid = chosen_swaths(request, swath_ground(headland), headland.narrow);
  Plan plan = plan_along(grid, headland, request);
  append_rings_before(headland, request, plan.passes);
  const bool headland_first = word(request.parameters, "headland_order") == "first";
  if (headland_first) append_passes_beside(request, headland, {&grid, 1}, plan.passes);
  append_swaths(grid, request, plan.passes);
  if (!headland_first) append_passes_beside(request, headland, {&grid, 1}, plan.passes);
  append_rings_after(headland, request, plan.passes);
  for (const Pass& pass : plan.passes) plan.planned_length_m += length_m(pass.points_W);
  return plan;
}

}  // namespace headland

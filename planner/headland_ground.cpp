#include "planner/headland_ground.h"

#include <utility>

#include "planner/headland_depth.h"
#include "planner/headland_edges.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Swaths spread evenly may lie closer than a working width, by this share of it.
constexpr double kLeastSpacing = 0.9;

std::vector<PlannedEdge> planned_edges(const EdgeRounds& edges, double width_m, double first_m) {
  std::vector<PlannedEdge> planned;
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    const FieldEdge& edge = edges.edges[i];
    const int rounds = edges.rounds[i];
    planned.push_back({edge.hole, edge.edge, rounds, headland_width_m(rounds, first_m, width_m),
                       edge.line_W.front(), edge.line_W.back()});
  }
  return planned;
}

// Edges with fewer rounds than turning needs.
std::vector<NarrowEdge> narrow_edges(const PlanRequest& request, const EdgeRounds& edges,
                                     double first_m) {
  const int enough = rounds_for_turning(request);
  std::vector<NarrowEdge> narrow;
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    const int rounds = edges.rounds[i];
    if (rounds >= enough) continue;
    narrow.push_back(
        {edges.edges[i].line_W, headland_width_m(rounds, first_m, request.working_width_m)});
  }
  return narrow;
}

// What lies further beyond the field than the implement may work, around it and in its holes.
PolygonSet beyond_edges(const PlanRequest& request) {
  const auto overhang = request.parameters.find("overhang_m");
  const double over_m =
      kOverEdge_m +
      (overhang == request.parameters.end() ? 0.0 : std::get<double>(overhang->second));
  Eigen::AlignedBox2d box;
  for (const Vector2d& p_W : request.field.boundary) box.extend(p_W);
  const Vector2d margin = Vector2d::Constant(2.0 * (over_m + request.working_width_m));
  const Vector2d low_W = box.min() - margin;
  const Vector2d high_W = box.max() + margin;
  const PolygonSet around{
      {PolygonPart{{low_W, {high_W.x(), low_W.y()}, high_W, {low_W.x(), high_W.y()}}, {}}}};
  const PolygonSet field{{PolygonPart{request.field.boundary, request.field.holes}}};
  return difference(around, buffered(field, over_m, Join::kMitre));
}

// Where edges have different numbers of rounds.
Headland ground_by_edge(const PlanRequest& request, const PolygonSet& field, double first_m,
                        const EdgeRounds& edges, Headland headland) {
  const double width_m = request.working_width_m;
  headland.edged = edged_ground(field, edges);
  headland.narrow = narrow_edges(request, edges, first_m);
  const EdgedGround& edged = headland.edged;
  const double hull_m = 0.5 * request.vehicle_width_m + request.clearance_m;
  headland.drivable =
      difference(field, united(std::vector<PolygonSet>{zone_beside(edged, {1}, first_m),
                                                       zone_beside(edged, {0, 0}, hull_m)}));
  std::vector<PolygonSet> zones;
  zones.reserve(static_cast<std::size_t>(headland.rounds) + 1);
  for (int round = 0; round < headland.rounds; ++round) {
    zones.push_back(zone_beside(edged, {round + 1}, first_m + (round + 0.5) * width_m));
  }
  // An implement no wider than the hull would take it over an edge without headland.
  zones.push_back(zone_beside(edged, {0, 0}, hull_m - kLeastSpacing * 0.5 * width_m));
  headland.inside = difference(field, united(zones));
  headland.inner = headland.inside;
  if (headland.least_rounds == 0) headland.beyond = beyond_edges(request);
  return headland;
}

}  // namespace

bool differs_by_edge(const Headland& headland) { return !headland.edged.ground.parts.empty(); }

SwathGround swath_ground(const Headland& headland) {
  return {headland.inner, headland.drivable, headland.beyond};
}

Headland headland_ground(const PlanRequest& request, const PolygonSet& field, int rounds,
                         double first_m) {
  const double width_m = request.working_width_m;
  Headland headland;
  headland.rounds = rounds;
  headland.least_rounds = rounds;
  headland.width_m = headland_width_m(rounds, first_m, width_m);
  if (!request.headland_edges.empty()) {
    const EdgeRounds edges = edge_rounds(request, rounds, first_m);
    const RoundsOfAll of_all = rounds_of_all(edges, !request.field.obstacles.empty());
    headland.rounds = of_all.most;
    headland.least_rounds = of_all.least;
    headland.width_m = headland_width_m(of_all.most, first_m, width_m);
    headland.edges = planned_edges(edges, width_m, first_m);
    if (!is_one_number(of_all)) {
      return ground_by_edge(request, field, first_m, edges, std::move(headland));
    }
  }
  headland.drivable = buffered(field, -first_m, Join::kRound);
  headland.inner = buffered(field, -headland.width_m, Join::kRound);
  return headland;
}

PolygonSet kept_whole(const PlanRequest& request, const EdgedGround& edged,
                      const PolygonSet& inside, double direction_rad) {
  constexpr int kGrazed = -1;
  const int enough = rounds_for_turning(request);
  EdgedGround grazed = edged;
  for_each_edge(grazed, [&](const Vector2d& a_W, const Vector2d& b_W, int& rounds) {
    if (rounds < enough && is_grazed(b_W - a_W, direction_rad)) rounds = kGrazed;
  });
  return difference(inside, zone_beside(grazed, {kGrazed, kGrazed}, turning_depth_m(request)));
}

}  // namespace headland

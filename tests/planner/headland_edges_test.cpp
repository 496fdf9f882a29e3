#include "planner/headland_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/algorithms/boustrophedon.h"
#include "planner/algorithms/decomposed.h"
#include "planner/drivable_path.h"
#include "planner/edge_zones.h"
#include "planner/headland_by_edge.h"
#include "planner/headland_order.h"
#include "planner/planned_vehicle.h"
#include "terrains/input_error.h"
#include "tests/planner/field_shapes.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kGridRounding_m2 = 1e-3;  // of set operations, along a few hundred metres
constexpr double kOfChords = 2e-3;         // arcs made of chords are so much shorter or smaller

Field plain_square() { return field_of("square", rectangle_ring(0, 0, 150, 150)); }

EdgeHeadland by_place(double x, double y, int passes) {
  EdgeHeadland edge;
  edge.at_W = Eigen::Vector2d(x, y);
  edge.passes = passes;
  return edge;
}

EdgeHeadland by_number(int hole, int edge, int passes) {
  EdgeHeadland named;
  named.hole = hole;
  named.edge = edge;
  named.passes = passes;
  return named;
}

std::string refusal_by_edges(const PlanRequest& request) {
  try {
    plan_boustrophedon(request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

PlanRequest request_by_edges(const Vehicle& vehicle, const Field& field,
                             const std::string& planner) {
  PlanRequest request = tractor_request(field, planner);
  set_vehicle(request, vehicle);
  return request;
}

TEST(FieldEdges, LieBetweenCornersHoweverManyPointsTheyHave) {
  Field field = field_of("square", {{0, 0}, {50, 0}, {100, 0.5}, {150, 0}, {150, 150}, {0, 150}});
  field.holes = {reversed(regular_ring({75, 75}, 20, 64)),
                 reversed(rectangle_ring(20, 20, 30, 40))};
  const std::vector<FieldEdge> edges = edges_of(field);
  ASSERT_EQ(edges.size(), 4U + 1U + 4U);
  EXPECT_EQ(edges[0].line_W.size(), 4U);
  EXPECT_EQ(edges[0].edge, 1);
  // A round hole is one edge that closes.
  EXPECT_EQ(edges[4].hole, 1);
  EXPECT_EQ(edges[4].line_W.front(), edges[4].line_W.back());
  EXPECT_EQ(edges[8].hole, 2);
  EXPECT_EQ(edges[8].edge, 4);
}

TEST(FieldEdges, AChamferedCornerIsOneCorner) {
  // A quarter circle of 1 m drawn with six points, and one of 60 m with thirty.
  Ring ring{{0, 0}, {150, 0}};
  for (int i = 0; i <= 5; ++i) {
    ring.emplace_back(149 + std::cos(i * kPi / 10), 149 + std::sin(i * kPi / 10));
  }
  for (int i = 0; i <= 29; ++i) {
    ring.emplace_back(60 + 60 * std::cos(kPi / 2 + i * kPi / 58),
                      90 + 60 * std::sin(kPi / 2 + i * kPi / 58));
  }
  const std::vector<FieldEdge> edges = edges_of(field_of("rounded", ring));
  EXPECT_EQ(edges.size(), 3U);
}

TEST(FieldEdges, ABendIsOneCornerHoweverWide) {
  for (const double radius_m : {2.0, 3.0, 5.0, 7.0, 9.0}) {
    Ring ring{{0, 0}, {150, 0}};
    for (int i = 0; i <= 18; ++i) {
      const double at_rad = i * kPi / 36;
      ring.emplace_back(150 - radius_m + radius_m * std::cos(at_rad),
                        150 - radius_m + radius_m * std::sin(at_rad));
    }
    ring.emplace_back(0, 150);
    EXPECT_EQ(edges_of(field_of("rounded", ring)).size(), 4U) << radius_m << " m";
  }
  Field field = plain_square();
  field.holes = {reversed(regular_ring({75, 75}, 6, 64))};
  EXPECT_EQ(edges_of(field).size(), 4U + 1U) << "a round hole";
}

TEST(FieldEdges, WidthsAreCoveredByPasses) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  EdgeHeadland wide = by_place(75, 0, 0);
  wide.passes.reset();
  const auto rounds_for = [&](double width_m) {
    wide.width_m = width_m;
    request.headland_edges = {wide};
    return edge_rounds(request, 2, 4.5).rounds[0];
  };
  EXPECT_EQ(rounds_for(0.0), 0);
  EXPECT_EQ(rounds_for(0.1), 1);
  EXPECT_EQ(rounds_for(9.0), 1);
  EXPECT_EQ(rounds_for(9.1), 2);
  EXPECT_EQ(rounds_for(27.0), 3);
}

TEST(FieldEdges, OneForTheWholeRingYieldsToOneForAnEdge) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  request.field.holes = {reversed(rectangle_ring(60, 60, 90, 90))};
  request.headland_edges = {by_place(75, 61, 3), by_number(1, 0, 1), by_number(0, 2, 0)};
  const EdgeRounds edges = edge_rounds(request, 2, 4.5);
  EXPECT_EQ(std::ranges::count(edges.rounds, 3), 1);
  EXPECT_EQ(std::ranges::count(edges.rounds, 1), 3);
  EXPECT_EQ(std::ranges::count(edges.rounds, 0), 1);
  EXPECT_EQ(std::ranges::count(edges.rounds, 2), 3);
}

TEST(FieldEdges, WhatIsNotThereIsRefused) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  const auto refused = [&](std::vector<EdgeHeadland> edges) {
    request.headland_edges = std::move(edges);
    return refusal_by_edges(request);
  };
  EXPECT_THAT(refused({by_number(0, 5, 1)}),
              HasSubstr("headland_edges[0]: 'edge 5': the boundary has 4 edges"));
  EXPECT_THAT(refused({by_number(1, 0, 1)}), HasSubstr("'hole 1': the field has no holes"));
  EXPECT_THAT(refused({by_place(75, 0, 1), by_place(75, -60, 0)}),
              HasSubstr("headland_edges[1]: 'at (75, -60) m': a place on an edge"));
  EXPECT_THAT(refused({by_place(75, 0, 1), by_number(0, 1, 0)}),
              HasSubstr("headland_edges[1]: 'edge 1': headland_edges[0] names it already"));
  EdgeHeadland wide = by_place(75, 0, 0);
  wide.passes.reset();
  wide.width_m = 200.0;
  EXPECT_THAT(refused({wide}), HasSubstr("'width_m 200': at most 20 passes of 9 m each"));
  EXPECT_THAT(refused({by_number(0, 1, 21)}), HasSubstr("'passes 21': 0 to 20 passes"));
  EXPECT_THAT(refused({by_number(0, 1, -1)}), HasSubstr("'passes -1': 0 to 20 passes"));
}

double zone_m2(const Field& field, std::vector<int> rounds, double distance_m) {
  EdgeRounds edges{edges_of(field), std::move(rounds), 0};
  return area_m2(zone_beside(edged_ground(from_field(field), edges), {1}, distance_m));
}

TEST(EdgeZones, RunStraightOnToTheNeighbourAndRoundAboutCorners) {
  EXPECT_NEAR(zone_m2(plain_square(), {1, 0, 0, 0}, 10.0), 1500.0, kGridRounding_m2);
  EXPECT_NEAR(zone_m2(plain_square(), {1, 1, 0, 0}, 10.0), 2 * 1500.0 - 100.0, kGridRounding_m2);
  // A neighbour leans out by 45 degrees: the strip goes on to it, a triangle more.
  const Field leaning = field_of("leaning", {{0, 0}, {100, 0}, {150, 50}, {150, 100}, {0, 100}});
  EXPECT_NEAR(zone_m2(leaning, {1, 0, 0, 0, 0}, 10.0), 1000.0 + 50.0, kGridRounding_m2);
  // Round about a corner that sticks into the field.
  const Field bay = field_of("bay", {{0, 0}, {200, 0}, {200, 90}, {90, 90}, {90, 180}, {0, 180}});
  const double quarter_m2 = kPi * 100.0 / 4.0;
  EXPECT_NEAR(zone_m2(bay, {0, 0, 1, 0, 0, 0}, 10.0), 1100.0 + quarter_m2, kOfChords * quarter_m2);
  EXPECT_NEAR(zone_m2(bay, {0, 0, 1, 1, 0, 0}, 10.0), 1100.0 + quarter_m2 + 900.0,
              kOfChords * quarter_m2);
}

TEST(EdgeZones, DoNotReachAcrossGroundThatIsNoField) {
  // Two arms 5 m apart; the inner side of the left one has a headland 12 m wide.
  const Field arms = field_of(
      "arms", {{0, 0}, {105, 0}, {105, 100}, {55, 100}, {55, 40}, {50, 40}, {50, 100}, {0, 100}});
  EXPECT_NEAR(zone_m2(arms, {0, 0, 0, 0, 0, 1, 0, 0}, 12.0), 60.0 * 12.0 + kPi * 144.0 / 4.0,
              kOfChords * kPi * 144.0);
}

// With turning radii below and well above the working width.
struct Alike {
  const char* vehicle = "";
  Field field;
};

std::vector<Alike> alike_cases() {
  std::vector<Alike> cases;
  for (const char* vehicle : {"transplanter", "horticultural_tractor"}) {
    cases.push_back({vehicle, field_of("wide", rectangle_ring(0, 0, 60, 45))});
    cases.push_back({vehicle, field_of("sharp", {{0, 0}, {80, 0}, {60, 45}, {0, 45}})});
  }
  return cases;
}

TEST(HeadlandByEdge, AlikeEdgesAreAsOneForAll) {
  for (const Alike& alike : alike_cases()) {
    const Vehicle vehicle = load_vehicle(alike.vehicle);
    PlanRequest request = request_by_edges(vehicle, alike.field, "boustrophedon");
    const Headland whole = make_headland(request, 3);
    const Plan plan = plan_boustrophedon(request);
    const Path path = make_path(alike.field, vehicle, plan, {});
    for (int edge = 1; edge <= 4; ++edge) request.headland_edges.push_back(by_number(0, edge, 3));
    const Headland by_edge = make_headland(request, 1);
    EXPECT_EQ(by_edge.width_m, whole.width_m);
    EXPECT_EQ(area_m2(by_edge.inner), area_m2(whole.inner));
    ASSERT_EQ(by_edge.rings.size(), whole.rings.size());
    for (std::size_t i = 0; i < whole.rings.size(); ++i) {
      EXPECT_EQ(by_edge.rings[i].line_W, whole.rings[i].line_W);
    }
    // The same when one edge is given what all have.
    const int rounds = rounds_for_turning(request);
    request.headland_edges = {by_number(0, 1, rounds)};
    const Plan named = plan_boustrophedon(request);
    EXPECT_EQ(named.headland_edges.size(), 4U);
    ASSERT_EQ(named.passes.size(), plan.passes.size());
    EXPECT_EQ(named.planned_length_m, plan.planned_length_m);
    EXPECT_EQ(length_m(make_path(alike.field, vehicle, named, {})), length_m(path));
  }
}

// Rounds that all edges have are closed, and those of one edge more do not break at its corners.
TEST(HeadlandByEdge, RoundsThatAllEdgesHaveStayClosed) {
  for (const Alike& alike : alike_cases()) {
    const Vehicle vehicle = load_vehicle(alike.vehicle);
    for (const int passes : {3, 4, 5}) {
      PlanRequest request = request_by_edges(vehicle, alike.field, "boustrophedon");
      request.headland_edges = {by_number(0, 1, passes)};
      const Headland headland = make_headland(request, 3);
      EXPECT_EQ(std::ranges::count_if(headland.rings, is_closed), 3);
      EXPECT_EQ(std::ssize(headland.rings), passes);
    }
  }
}

// Two neighbours with a round more: it runs round their corner in one stretch.
TEST(HeadlandByEdge, ARoundRunsOnAroundTheCornerOfTwoEdgesThatHaveIt) {
  for (const Alike& alike : alike_cases()) {
    const Vehicle vehicle = load_vehicle(alike.vehicle);
    PlanRequest request = request_by_edges(vehicle, alike.field, "boustrophedon");
    request.headland_edges = {by_number(0, 1, 4), by_number(0, 2, 4)};
    const Headland headland = make_headland(request, 3);
    EXPECT_EQ(std::ssize(headland.rings), 4);
  }
}

// A round that one edge lacks bends no wider in the others' corners, where it would leave short
// swaths of their own.
TEST(HeadlandByEdge, ARoundFewerLeavesNoMoreInCorners) {
  PlanRequest request =
      request_by_edges(load_vehicle("transplanter"), plain_square(), "boustrophedon");
  const Headland whole = make_headland(request, 4);
  ASSERT_EQ(whole.inner.parts.size(), 1U);
  request.headland_edges = {by_number(0, 1, 3)};
  const Headland by_edge = make_headland(request, 4);
  EXPECT_EQ(by_edge.rings.size(), 4U);
  EXPECT_EQ(by_edge.inner.parts.size(), 1U);
  EXPECT_NEAR(area_m2(by_edge.inner), area_m2(by_edge.inside), kGridRounding_m2);
}

TEST(HeadlandByEdge, MoreRoundsThanAnEdgeCanBeGivenAreThoseOfTheOthers) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  request.working_width_m = 1.0;
  request.vehicle_width_m = 0.8;
  request.headland_edges = {by_number(0, 1, 20)};
  const double first_m = first_round(request).distance_m;
  const Headland headland = headland_ground(request, from_field(request.field), 25, first_m);
  const double width_m = headland_width_m(25, first_m, 1.0);
  EXPECT_DOUBLE_EQ(headland.width_m, width_m);
  EXPECT_NEAR(area_m2(headland.inside),
              (150.0 - 2.0 * width_m) * (150.0 - width_m - headland_width_m(20, first_m, 1.0)),
              kGridRounding_m2);
}

TEST(HeadlandByEdge, EveryEdgeHasItsWidth) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  request.headland_edges = {by_place(75, 0, 0), by_place(150, 75, 3), by_place(0, 75, 1)};
  const Headland headland = make_headland(request, 2);
  EXPECT_DOUBLE_EQ(headland.width_m, 27.0);
  EXPECT_NEAR(area_m2(headland.inside), (150.0 - 27.0 - 9.0) * (150.0 - 18.0), kGridRounding_m2);
  // One round along three edges, one along the upper and right ones, one along the right one alone:
  // each comes to its neighbour's headland, or to the lower edge where it turns off.
  ASSERT_EQ(headland.rings.size(), 3U);
  for (const HeadlandRing& ring : headland.rings) {
    EXPECT_FALSE(is_closed(ring));
    for (const Eigen::Vector2d& p_W : ring.line_W) {
      EXPECT_GT(p_W.y(), 4.5 - 0.05) << "as far from the lower edge as any round is from its own";
      EXPECT_LT(p_W.y(), 150.0 - 4.5 + 0.05);
    }
  }
  const Polyline& alone = headland.rings[2].line_W;
  for (const Eigen::Vector2d& p_W : alone) {
    EXPECT_GT(p_W.x(), 150.0 - 27.0);
    EXPECT_LT(p_W.y(), 150.0 - 18.0) << "the upper edge's own headland";
  }
  EXPECT_GT(length_m(alone), 150.0 - 18.0 - 4.5 - 1.03 * 5.0);
}

TEST(HeadlandByEdge, TreesHaveTheOthersRounds) {
  PlanRequest request = tractor_request(plain_square(), "boustrophedon");
  request.field.obstacles = {{ObstacleKind::kTree, {75, 75}, 0.5, 8.0}};
  for (int edge = 1; edge <= 4; ++edge) request.headland_edges.push_back(by_number(0, edge, 0));
  const Headland headland = make_headland(request, 1);
  ASSERT_EQ(headland.rings.size(), 1U);
  EXPECT_TRUE(headland.rings.front().around_hole);
}

// Swaths run along an edge without headland rather than into it, right beside it.
TEST(HeadlandByEdge, SwathsRunAlongAnEdgeWithoutHeadland) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = field_of("wide", rectangle_ring(0, 0, 60, 80));
  for (Plan (*plan_function)(const PlanRequest&) : {&plan_boustrophedon, &plan_decomposed}) {
    PlanRequest request = request_by_edges(
        vehicle, field, plan_function == &plan_decomposed ? "decomposed" : "boustrophedon");
    EXPECT_NEAR(plan_function(request).swath_direction_rad, kPi / 2, 1e-9) << "the long way";
    request.headland_edges = {by_place(30, 0, 0)};
    const Plan plan = plan_function(request);
    EXPECT_NEAR(plan.swath_direction_rad, 0.0, 1e-9);
    ASSERT_EQ(plan.headland_edges.size(), 4U);
    EXPECT_EQ(plan.headland_edges[0].passes, 0);
    const Path path = make_path(field, vehicle, plan, {});
    EXPECT_TRUE(path.violations.empty());
    std::vector<PolygonSet> strips;
    for (const Pass& pass : plan.passes) {
      strips.push_back(strip(pass.points_W, request.working_width_m));
    }
    const PolygonSet beside{{PolygonPart{rectangle_ring(15, 0.05, 45, 1), {}}}};
    EXPECT_LT(area_m2(difference(beside, united(strips))), 1e-3);
  }
}

TEST(HeadlandByEdge, SwathsIntoAnEdgeWithoutHeadlandAreRefusedWithTheWidthThatWouldDo) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = field_of("wide", rectangle_ring(0, 0, 60, 80));
  PlanRequest request = request_by_edges(vehicle, field, "boustrophedon");
  request.headland_edges = {by_place(30, 0, 0)};
  request.parameters["swath_direction_deg"] = 90.0;
  try {
    make_path(field, vehicle, plan_boustrophedon(request), {});
    FAIL() << "there is no room to turn";
  } catch (const PlanInfeasible& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("it needs a headland of "));
  }
}

// Three sides of a square have the round: begun after the gap, it is driven without crossing it.
TEST(HeadlandByEdge, PassesIntoCornersBeginAfterTheGap) {
  const std::vector<Polyline> sides = {
      {{0, 0}, {30, 0}}, {{30, 0}, {30, 30}}, {{30, 30}, {0, 30}}};  // none along x = 0
  const auto first_side = [&](double gap_m) {
    std::vector<EdgePass> edges;
    edges.reserve(sides.size());
    for (const Polyline& side : sides) edges.push_back({0, 0, false, false, side});
    edges[0].gap_m = gap_m;
    PlanRequest request = tractor_request(plain_square(), "boustrophedon");
    request.field.entry_W = Eigen::Vector2d(28, 2);
    std::vector<Pass> passes;
    append_edge_passes(edges, true, request, passes);
    return passes.front().points_W;
  };
  EXPECT_EQ(first_side(0.0), sides[1]) << "the nearest, of a ring without a gap";
  EXPECT_EQ(first_side(30.0), sides[0]);
}

TEST(HeadlandByEdge, CornersAreCoveredAlongEdgesThatHaveHeadland) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Field field = field_of("wide", rectangle_ring(0, 0, 40, 30));
  PlanRequest request = request_by_edges(vehicle, field, "boustrophedon");
  request.parameters["headland_corners"] = std::string("covered");
  request.headland_edges = {by_place(20, 0, 0)};
  const Plan plan = plan_boustrophedon(request);
  for (const Pass& pass : plan.passes) {
    if (pass.kind != PassKind::kHeadlandPass) continue;
    const Eigen::Vector2d along = pass.points_W.back() - pass.points_W.front();
    const bool by_lower_edge = pass.points_W.front().y() < 2.0 && pass.points_W.back().y() < 2.0;
    EXPECT_FALSE(by_lower_edge && std::abs(along.x()) > 10.0) << "a round along the lower edge";
  }
  EXPECT_TRUE(make_path(field, vehicle, plan, {}).violations.empty());
}

}  // namespace
}  // namespace headland

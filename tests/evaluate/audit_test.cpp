#include "evaluate/audit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "evaluate/audit_file.h"
#include "evaluate/plan_file.h"
#include "planner/arcs.h"
#include "planner/drivable_path.h"
#include "planner/planned_vehicle.h"
#include "planner/planners.h"
#include "terrains/input_error.h"
#include "tests/evaluate/results_folder.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kAuditCell_m = 0.25;
constexpr double kAState_m = 2.0 * kPathSpacing_m;  // where a stretch begins and ends
constexpr double kACell_m2 = kAuditCell_m * 2.0;    // a row of cells per metre of edge

Field audited_field() {
  Field field;
  field.name = "square";
  field.boundary = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  return field;
}

const AuditTotals& totals_of(const Audit& audit, AuditFault fault) {
  return audit.totals[static_cast<std::size_t>(fault)];
}

Audit audited(const Field& field, const Vehicle& vehicle, std::vector<Eigen::Vector2d> points_W) {
  return audit_path(field, vehicle, {{std::move(points_W), true, false}}, kAuditCell_m);
}

std::vector<Eigen::Vector2d> circle(double radius_m, double chord_m) {
  std::vector<Eigen::Vector2d> points_W;
  const double step_rad = 2.0 * std::asin(0.5 * chord_m / radius_m);
  for (double angle_rad = 0.0; angle_rad < std::numbers::pi; angle_rad += step_rad) {
    points_W.push_back(Eigen::Vector2d(30.0, 30.0) +
                       radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return points_W;
}

TEST(Audit, TellsHowFarAndHowLongTheHullIsOutside) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  const Audit audit = audited(audited_field(), vehicle, {{10, 30}, {62, 30}});
  ASSERT_EQ(audit.places.size(), 1U);
  const AuditPlace& place = audit.places.front();
  EXPECT_EQ(place.fault, AuditFault::kOutside);
  // The front meets the boundary at x 60 and ends 2 m and itself beyond.
  EXPECT_NEAR(place.from_m, 50.0 - front_m, kAState_m);
  EXPECT_NEAR(place.length_m, 2.0 + front_m, kAState_m);
  EXPECT_NEAR(place.worst, 2.0 + front_m, 1e-9);
  EXPECT_NEAR(place.p_W.x(), 62.0 + front_m, 1e-9);
  EXPECT_NEAR(audit.length_m, 52.0, 1e-9);
  EXPECT_FALSE(passes(audit));
  // Negative control: the same line, short of the boundary.
  EXPECT_TRUE(passes(audited(audited_field(), vehicle, {{10, 30}, {59.0 - front_m, 30}})));
}

TEST(Audit, TellsHolesFromObstacles) {
  const Vehicle vehicle = load_vehicle("transplanter");
  Field field = audited_field();
  field.holes.push_back({{20, 20}, {20, 24}, {24, 24}, {24, 20}});
  field.obstacles.push_back({ObstacleKind::kTree, {40.0, 30.5}, 0.3, 5.0});
  const Audit through_hole = audited(field, vehicle, {{10, 22}, {34, 22}});
  EXPECT_EQ(totals_of(through_hole, AuditFault::kInHole).places, 1);
  EXPECT_EQ(totals_of(through_hole, AuditFault::kOutside).places, 0);
  EXPECT_NEAR(totals_of(through_hole, AuditFault::kInHole).length_m, 4.0 + vehicle.body.length_m,
              2.0 * kAState_m);
  const Audit into_tree = audited(field, vehicle, {{30, 30}, {50, 30}});
  EXPECT_EQ(totals_of(into_tree, AuditFault::kInObstacle).places, 1);
  EXPECT_EQ(totals_of(into_tree, AuditFault::kInHole).places, 0);
  EXPECT_TRUE(passes(audited(field, vehicle, {{10, 50}, {50, 50}})));
}

// Chords of a circle tell its radius, however fine they are.
TEST(Audit, ComparesCurvesWithTheSteering) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const double least_m = min_turning_radius_m(vehicle);
  for (const double chord_m : {0.05, 0.25, 1.0}) {
    EXPECT_EQ(totals_of(audited(audited_field(), vehicle, circle(1.05 * least_m, chord_m)),
                        AuditFault::kTooTight)
                  .places,
              0)
        << chord_m;
    const Audit tight = audited(audited_field(), vehicle, circle(0.9 * least_m, chord_m));
    EXPECT_EQ(totals_of(tight, AuditFault::kTooTight).places, 1) << chord_m;
    // 2 %: chords of 1 m on a circle of 2 m are shorter than their arcs.
    EXPECT_NEAR(totals_of(tight, AuditFault::kTooTight).worst, 0.9 * least_m, 0.02 * least_m);
  }
}

// Past trees at the end of a 9 m bar that swings along an arc: the directions of its chords are
// half an edge's turn off, which is 0.13 m there.
TEST(Audit, KnowsWhereABarSwingsThoughPathsArePoints) {
  const Vehicle vehicle = load_vehicle("utility_tractor");
  const double radius_m = planning_turning_radius_m(vehicle);
  const Pose begin{{30.0, 20.0}, 0.0};
  const std::vector<Arc> arcs = {{3.0, 0.0}, {9.0, 1.0 / radius_m}, {3.0, 0.0}};
  PathSegment turn = sample(begin, arcs, kPathSpacing_m)[0];
  Path path;
  path.segments.push_back(turn);
  // The bar's outer end swings on this circle about the arc's centre.
  const double bar_x_m = std::abs(vehicle.implement.x_B_m) + 0.5 * kImplementDepth_m;
  const double swing_m = std::hypot(radius_m + 0.5 * vehicle.implement.working_width_m, bar_x_m);
  const Eigen::Vector2d centre_W = pose_along(begin, arcs[0], 3.0).p_W + radius_m * left_of(0.0);
  const auto faults_at = [&](double gap_m) {
    constexpr double kTree_m = 0.2;
    Field field = audited_field();
    field.obstacles.push_back({ObstacleKind::kTree,
                               centre_W + (swing_m + kTree_m + gap_m) * direction_of(-0.9), kTree_m,
                               5.0});
    const Audit audit = audit_path(field, vehicle, lines_of(path), kAuditCell_m);
    return totals_of(audit, AuditFault::kInObstacle).places;
  };
  EXPECT_EQ(faults_at(0.02), 0);
  EXPECT_EQ(faults_at(-0.05), 1);
}

TEST(Audit, ACornerOfLongEdgesIsTightUnlessTheVehiclePivots) {
  const std::vector<Eigen::Vector2d> corner = {{20, 20}, {40, 20}, {40, 40}};
  const Audit audit = audited(audited_field(), load_vehicle("transplanter"), corner);
  ASSERT_EQ(audit.places.size(), 1U);
  EXPECT_EQ(audit.places[0].fault, AuditFault::kTooTight);
  EXPECT_NEAR((audit.places[0].p_W - Eigen::Vector2d(40, 20)).norm(), 0.0, 1e-12);
  // Rounded by 0.1 m: r (sqrt(2) - 1) = 0.1.
  EXPECT_NEAR(audit.places[0].worst, 0.1 / (std::numbers::sqrt2 - 1.0), 1e-9);
  EXPECT_TRUE(passes(audited(audited_field(), load_vehicle("skid_steer_robot"), corner)));
  // A bend of 4 degrees is rounded within 0.1 m by any radius up to 160 m.
  EXPECT_TRUE(passes(
      audited(audited_field(), load_vehicle("transplanter"), {{10, 20}, {30, 20}, {50, 21.4}})));
}

TEST(Audit, BacksOutOfShortLegsAndFindsTurnsThatAreLeftOut) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Audit backing = audited(audited_field(), vehicle, {{20, 30}, {35, 30}, {28, 30}, {40, 30}});
  EXPECT_EQ(backing.gear_changes, 2);
  EXPECT_NEAR(backing.reverse_length_m, 7.0, 1e-9);
  EXPECT_EQ(totals_of(backing, AuditFault::kTooTight).places, 0);
  // One cusp before the first work: it is come to in reverse.
  const Audit entered = audit_path(
      audited_field(), vehicle,
      {{{{30, 30}, {20, 30}}, false, false}, {{{20, 30}, {50, 30}}, true, true}}, kAuditCell_m);
  EXPECT_EQ(entered.gear_changes, 1);
  EXPECT_NEAR(entered.reverse_length_m, 10.0, 1e-9);
  EXPECT_EQ(totals_of(entered, AuditFault::kTooTight).places, 0);
  // Row after row without a turn between: 40 m is no reversing.
  const Audit rows = audited(audited_field(), vehicle, {{10, 30}, {50, 30}, {10, 30.01}});
  EXPECT_EQ(rows.gear_changes, 0);
  EXPECT_EQ(totals_of(rows, AuditFault::kTooTight).places, 1);
}

// Three rows; the way from the second to the third leads across the first or around its end.
TEST(Audit, MetresOverWorkedGroundAreThoseOfWheelsAcrossRows) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const auto over_m = [&](double crossing_x_m) {
    const double row_y_m = 30.0;
    std::vector<PathLine> lines{{{{10, row_y_m}, {30, row_y_m}}, true, false}};
    lines.push_back({{{crossing_x_m, 40}, {crossing_x_m, 20}}, false, false});
    return audit_path(audited_field(), vehicle, lines, kAuditCell_m).over_worked.length_m;
  };
  // Each axle crosses it, both at once where the row is wider than the wheelbase.
  const double row_m = kRowShare * vehicle.implement.working_width_m;
  const double crossed_m = row_m + std::min(row_m, wheelbase_m(vehicle));
  EXPECT_NEAR(over_m(20.0), crossed_m, 4.0 * kGroundCell_m);
  EXPECT_EQ(over_m(40.0), 0.0);
}

TEST(Audit, JumpsAreWhatDoesNotGoOnWhereItEnded) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const auto two_lines = [&](double gap_m) {
    return audit_path(
        audited_field(), vehicle,
        {{{{10, 20}, {30, 20}}, true, false}, {{{30.0 + gap_m, 20}, {50, 20}}, true, false}},
        kAuditCell_m);
  };
  EXPECT_TRUE(passes(two_lines(0.04)));
  const Audit apart = two_lines(0.5);
  ASSERT_EQ(apart.places.size(), 1U);
  EXPECT_EQ(apart.places[0].fault, AuditFault::kJump);
  EXPECT_NEAR(apart.places[0].worst, 0.5, 1e-9);
  EXPECT_NEAR(apart.places[0].from_m, 20.0, 1e-9);
}

TEST(Audit, CountsWhatTheImplementCoversAndMisses) {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.implement.x_B_m = 0.0;
  const double width_m = vehicle.implement.working_width_m;
  const double length_m = 40.0;
  const auto rows = [&](double apart_m, bool second_down) {
    return audit_path(audited_field(), vehicle,
                      {{{{10, 20}, {10 + length_m, 20}}, true, false},
                       {{{10, 20 + apart_m}, {10 + length_m, 20 + apart_m}}, second_down, false}},
                      kAuditCell_m);
  };
  const double edge_m2 = (length_m + width_m) * kACell_m2;
  const Audit beside = rows(width_m, true);
  EXPECT_NEAR(beside.coverage.covered_m2, 2.0 * width_m * length_m, edge_m2);
  EXPECT_EQ(beside.coverage.overlap_m2, 0.0);
  EXPECT_NEAR(rows(0.75 * width_m, true).coverage.overlap_m2, 0.25 * width_m * length_m, edge_m2);
  EXPECT_NEAR(rows(width_m, false).coverage.covered_m2, width_m * length_m, edge_m2);
  // A gap of a metre between the rows is no patch of its own: it opens to the rest at both ends.
  ASSERT_EQ(rows(width_m + 1.0, true).missed.size(), 1U);
  EXPECT_NEAR(beside.missed.front().area_m2, beside.coverage.missed_m2, 1e-9);
}

// Pictures wear the grade, texts and exit codes tell passes().
TEST(Audit, IsGradedAsItPasses) {
  const auto graded = [](double to_x_m) {
    return audit_path(audited_field(), load_vehicle("transplanter"),
                      {{{{10, 20}, {to_x_m, 20}}, true, false}}, kAuditCell_m);
  };
  const Audit inside = graded(50.0);
  ASSERT_TRUE(passes(inside));
  const Verdict missed = audit_verdict(inside);
  EXPECT_EQ(missed.grade, Grade::kPass);
  ASSERT_FALSE(missed.reasons.empty()) << "nearly all of the field is not worked";
  EXPECT_EQ(missed.reasons.front().grade, Grade::kWarn);
  ASSERT_FALSE(passes(graded(65.0)));
  EXPECT_EQ(audit_verdict(graded(65.0)).grade, Grade::kFail);
}

TEST(Audit, RefusesAPathWithoutLength) {
  EXPECT_THROW(audited(audited_field(), load_vehicle("transplanter"), {{10, 10}, {10, 10}}),
               InputError);
}

class AuditFiles : public test::ResultsFolder {};

// Ours as GeoJSON and the same points as another tool's CSV: one answer, and nothing against it.
TEST_F(AuditFiles, AnswerIsTheSameWhoeverMadeThePath) {
  const Field field = audited_field();
  PlanRequest request;
  request.field = field;
  set_vehicle(request, vehicle_);
  const PlannerEntry& planner = find_planner("boustrophedon", "test");
  request.parameters = resolve_parameters(planner.parameters, {}, "test", "planner");
  const Path path = make_path(field, vehicle_, planner.plan(request), {});
  const auto ours = write("path.geojson", path_geojson(path, field.frame));
  std::string csv = "x,y,implement\n";
  for (const PathSegment& segment : path.segments) {
    for (const PathPoint& point : segment.points) {
      csv +=
          fmt::format("{:.6f},{:.6f},{:d}\n", point.p_W.x(), point.p_W.y(), segment.implement_down);
    }
  }
  const auto theirs = write("other.csv", csv);
  const auto audit_of = [&](const std::filesystem::path& file) {
    return audit_path(field, vehicle_, read_path_lines(file, field), kAuditCell_m);
  };
  const Audit a = audit_of(ours);
  const Audit b = audit_of(theirs);
  EXPECT_TRUE(passes(a));
  EXPECT_TRUE(passes(b));
  EXPECT_GT(a.coverage.covered_m2, 0.95 * a.coverage.workable_m2);
  EXPECT_NEAR(a.length_m, length_m(path), 1e-3 * length_m(path));  // chords of its arcs
  EXPECT_EQ(a.states, b.states);
  EXPECT_EQ(a.gear_changes, b.gear_changes);
  EXPECT_EQ(a.coverage.covered_m2, b.coverage.covered_m2);
  EXPECT_EQ(a.coverage.overlap_m2, b.coverage.overlap_m2);
}

}  // namespace
}  // namespace headland

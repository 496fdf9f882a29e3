#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <random>

#include "planner/arcs.h"
#include "planner/drivable_path.h"
#include "planner/track_pieces.h"
#include "terrains/field_source.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/made_up_vehicle.h"

namespace headland {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

constexpr double kTolerance_m = 0.3;
constexpr double kTrackRounding_m = 1e-9;

Field square(double side_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {side_m, 0.0}, {side_m, side_m}, {0.0, side_m}};
  return field;
}

void append_line(Track& track, const Vector2d& a, const Vector2d& b, double step_m) {
  const int steps = static_cast<int>((b - a).norm() / step_m);
  for (int i = 0; i <= steps; ++i) track.points_W.emplace_back(a + (b - a) * i / steps);
}

void expect_continuous(const Path& path, double radius_m) {
  const PathPoint* last = nullptr;
  for (const PathSegment& segment : path.segments) {
    ASSERT_GE(segment.points.size(), 2U);
    if (last != nullptr) {
      EXPECT_LT((segment.points.front().p_W - last->p_W).norm(), 1e-6);
      EXPECT_LT(std::abs(wrap_angle(segment.points.front().heading_rad - last->heading_rad)), 1e-6);
    }
    for (const PathPoint& point : segment.points) {
      EXPECT_LE(std::abs(point.curvature_per_m), 1.0 / radius_m + kTrackRounding_m);
    }
    last = &segment.points.back();
  }
}

TEST(TrackPieces, StraightTrackIsOnePieceWithinItsNoise) {
  Track track;
  append_line(track, {10.0, 20.0}, {110.0, 20.0}, 2.0);
  std::mt19937_64 random(1);
  for (Vector2d& p : track.points_W) {
    p.y() += 0.1 * (2.0 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1.0);
  }
  const TrackPieces found = track_pieces(track, kTolerance_m, 4.0, 0.0);
  ASSERT_EQ(found.pieces.size(), 1U);
  EXPECT_EQ(found.cut_corners, 0);
  EXPECT_GT(found.pieces[0].max_deviation_m, 0.0);
  EXPECT_LE(found.pieces[0].max_deviation_m, 0.2 + kTrackRounding_m) << "peak to peak of the noise";
  EXPECT_NEAR(length_m(found.pieces[0].arcs), 100.0, 0.01);
}

TEST(TrackPieces, BendsWiderThanTheRadiusAreFollowedWithinTheTolerance) {
  Track track;
  const double bend_m = 15.0;
  for (int i = 0; i <= 60; ++i) {
    track.points_W.emplace_back(50.0 + bend_m * std::cos(kPi * i / 60.0),
                                50.0 + bend_m * std::sin(kPi * i / 60.0));
  }
  const TrackPieces found = track_pieces(track, kTolerance_m, 4.0, 0.0);
  ASSERT_EQ(found.pieces.size(), 1U);
  EXPECT_LE(found.pieces[0].max_deviation_m, kTolerance_m);
  for (const Arc& arc : found.pieces[0].arcs) {
    EXPECT_LE(std::abs(arc.curvature_per_m), 1.0 / 4.0 + kTrackRounding_m);
  }
}

TEST(TrackPieces, BreaksCutAndShortPiecesAreDropped) {
  Track track;
  append_line(track, {10.0, 10.0}, {60.0, 10.0}, 1.0);
  track.break_before.push_back(track.points_W.size());
  append_line(track, {60.0, 15.0}, {58.0, 15.0}, 1.0);
  track.break_before.push_back(track.points_W.size());
  append_line(track, {60.0, 20.0}, {10.0, 20.0}, 1.0);
  const TrackPieces found = track_pieces(track, kTolerance_m, 4.0, 0.0);
  EXPECT_EQ(found.pieces.size(), 2U);
  ASSERT_EQ(found.dropped_W.size(), 1U);
  EXPECT_NEAR(found.dropped_W[0].y(), 15.0, kTrackRounding_m);
}

TEST(MakeDrivable, RightAngleBecomesOneArcOfTheVehiclesRadius) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  const double radius_m = planning_turning_radius_m(vehicle);
  Track track;
  track.points_W = {{20.0, 20.0}, {60.0, 20.0}, {60.0, 60.0}};
  TrackReport report;
  const Path path = make_drivable(square(100.0), vehicle, track, kTolerance_m, {}, &report);
  EXPECT_EQ(report.pieces, 2);
  EXPECT_EQ(report.cut_corners, 1);
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_THAT(report.notes[0], HasSubstr("corner tighter than 2.60 m at (60.0, 20.0) m"));
  ASSERT_EQ(path.segments.size(), 3U);
  EXPECT_EQ(path.segments[0].kind, PathKind::kSwath);
  EXPECT_EQ(path.segments[1].kind, PathKind::kTurn);
  EXPECT_EQ(path.segments[2].kind, PathKind::kSwath);
  EXPECT_NEAR(length_m(path.segments[1]), kPi / 2.0 * radius_m, 0.01);
  expect_continuous(path, radius_m);
}

TEST(MakeDrivable, GridPlanWithRightAnglesAtRowEndsIsJoinedByTurns) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Track track;
  for (int row = 0; row < 6; ++row) {
    const double x = 20.0 + 2.0 * row;
    const bool up = row % 2 == 0;
    track.points_W.emplace_back(x, up ? 20.0 : 80.0);
    track.points_W.emplace_back(x, up ? 80.0 : 20.0);
  }
  TrackReport report;
  const Path path = make_drivable(square(100.0), vehicle, track, kTolerance_m, {}, &report);
  EXPECT_EQ(report.pieces, 6);
  EXPECT_EQ(report.cut_corners, 10);
  EXPECT_TRUE(path.violations.empty());
  EXPECT_LE(report.max_deviation_m, kTolerance_m);
  expect_continuous(path, planning_turning_radius_m(vehicle));
  int u_turns = 0;
  for (const PathSegment& segment : path.segments) {
    if (segment.kind == PathKind::kUTurn && segment.gear == Gear::kForward) ++u_turns;
  }
  EXPECT_GE(u_turns, 5);
}

TEST(MakeDrivable, ImplementFollowsTheTrack) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Track track;
  append_line(track, {20.0, 20.0}, {20.0, 80.0}, 1.0);
  const Path path = make_drivable(square(100.0), vehicle, track, kTolerance_m, {}, nullptr);
  ASSERT_EQ(path.segments.size(), 1U);
  const double behind_m = -vehicle.implement.x_B_m;
  EXPECT_NEAR(path.segments[0].points.front().p_W.y(), 20.0 + behind_m, kTrackRounding_m);
  EXPECT_NEAR(path.segments[0].points.back().p_W.y(), 80.0 + behind_m, kTrackRounding_m);
}

TEST(MakeDrivable, TrackOutsideTheFieldIsRefusedOrRecorded) {
  const Vehicle vehicle = made_up_vehicle(2.6, 2.0);
  Track track;
  append_line(track, {20.0, 20.0}, {20.0, 105.0}, 1.0);
  try {
    make_drivable(square(100.0), vehicle, track, kTolerance_m, {}, nullptr);
    FAIL() << "accepted";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), HasSubstr("pass 1 (swath) takes the hull"));
    EXPECT_THAT(infeasible.what(), HasSubstr("beyond the boundary at (2"));
  }
  PathOptions options;
  options.allow_overrun = true;
  const Path path = make_drivable(square(100.0), vehicle, track, kTolerance_m, options, nullptr);
  ASSERT_EQ(path.violations.size(), 1U);
  const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
  EXPECT_NEAR(path.violations[0].overrun_m, 5.0 - vehicle.implement.x_B_m + front_m,
              kTrackRounding_m);
}

TEST(MakeDrivable, TrackOfScrapsIsRefused) {
  Track track;
  track.points_W = {{10.0, 10.0}, {12.0, 10.0}};
  try {
    make_drivable(square(50.0), made_up_vehicle(2.6, 2.0), track, kTolerance_m, {}, nullptr);
    FAIL() << "accepted";
  } catch (const PlanInfeasible& infeasible) {
    EXPECT_THAT(infeasible.what(), HasSubstr("no piece of 5 m"));
  }
}

// The combine's log of a real field, for a tractor of 4.4 m radius.
TEST(MakeDrivable, CombinesLogBecomesOnePath) {
  const std::filesystem::path folder = HEADLAND_SOURCE_DIR "/../shared/data/gartner";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  FieldSource source;
  source.file = folder / "boundary.geojson";
  const Field field = read_field(source, "test");
  const Track track = read_track(folder / "driven_track.csv", field);
  const Vehicle vehicle = made_up_vehicle(4.4, 9.0);
  PathOptions options;
  options.allow_overrun = true;
  TrackReport report;
  const Path path = make_drivable(field, vehicle, track, 0.5, options, &report);
  expect_continuous(path, planning_turning_radius_m(vehicle));
  const auto left_out = std::count_if(
      report.notes.begin(), report.notes.end(),
      [](const std::string& note) { return note.find("left out") != std::string::npos; });
  EXPECT_EQ(report.pieces + left_out,
            static_cast<int>(track.break_before.size()) + 1 + report.cut_corners);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_THAT(report.notes[0], testing::StartsWith("52 of 69 pauses longer than 9 s taken as "
                                                   "breaks: the place jumps by more than 18.7 m"));
  EXPECT_LE(report.max_deviation_m, 0.5);
  double logged_m = 0.0;
  for (std::size_t i = 1; i < track.points_W.size(); ++i) {
    logged_m += (track.points_W[i] - track.points_W[i - 1]).norm();
  }
  // Turns instead of the log's straight jumps between rows make it a little longer.
  EXPECT_GT(length_m(path), logged_m);
  EXPECT_LT(length_m(path), 1.05 * logged_m);
}

}  // namespace
}  // namespace headland

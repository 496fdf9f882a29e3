// Moments of a run: what was so then, and where it is on the picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/moment_view.h"
#include "render/run_event.h"
#include "render/run_moment.h"
#include "terrains/input_error.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

constexpr PictureSize kMomentSize{640, 400};

RunSample sample_of(double time_s, double x_m, double yaw_rad) {
  RunSample sample;
  sample.time_s = time_s;
  sample.travel_m = x_m;
  sample.p_WB = {x_m, 20.0, 100.0};
  sample.yaw_rad = yaw_rad;
  return sample;
}

TEST(RunMoment, LiesBetweenItsSamplesTheShortWayRound) {
  RunRecord run;
  const double pi = std::numbers::pi;
  run.samples = {sample_of(0.0, 0.0, pi - 0.1), sample_of(2.0, 4.0, -pi + 0.1)};
  const std::optional<RunSample> middle = sample_at(run, 1.0);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->p_WB.x(), 2.0, 1e-12);
  EXPECT_NEAR(std::cos(middle->yaw_rad), -1.0, 1e-12) << "through west, not through east";
  EXPECT_EQ(sample_at(run, -1.0)->time_s, 0.0);
  EXPECT_EQ(sample_at(run, 9.0)->time_s, 2.0);
  EXPECT_FALSE(sample_at(RunRecord{}, 1.0));
}

TEST(RunMoment, KnowsNothingOfWhatCameLater) {
  RunRecord run;
  for (int i = 0; i <= 10; ++i) {
    run.samples.push_back(sample_of(i, 2.0 * i, 0.0));
    FootprintSample footprint;
    footprint.time_s = i;
    run.footprints.push_back(footprint);
  }
  const RunRecord until = run_until(run, 4.5);
  EXPECT_EQ(until.footprints.size(), 5U);
  EXPECT_NEAR(until.samples.back().time_s, 4.5, 1e-12);
  EXPECT_NEAR(until.distance_m, 9.0, 1e-12);
  EXPECT_NEAR(until.duration_s, 4.5, 1e-12);
}

TEST(RunEvent, IsFoundWhereItHappened) {
  RunRecord run;
  for (int i = 0; i <= 10; ++i) run.samples.push_back(sample_of(i, i, 0.0));
  run.samples[3].steer_rad = -0.5;
  run.samples[7].steer_rad = 0.4;
  run.samples[9].steer_rad = 0.6;  // on a swath
  Path path;
  path.segments.resize(2);
  path.segments[1].kind = PathKind::kUTurn;
  for (int i = 0; i < 9; ++i) run.samples[static_cast<std::size_t>(i)].segment = 1;
  const std::optional<RunEvent> turn = find_event("tightest_turn", path, run);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->time_s, 3.0);
  EXPECT_FALSE(find_event("collision", path, run));
  run.outcome = Outcome::kHitObstacle;
  ASSERT_TRUE(find_event("collision", path, run));
  EXPECT_EQ(find_event("collision", path, run)->time_s, 10.0);
  EXPECT_FALSE(find_event("end", path, RunRecord{}));
  try {
    find_event("worst_case", path, run);
    FAIL() << "an unknown event was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'worst_case': one of worst_slip, "));
  }
}

// A vehicle in the middle of a level field.
MadeRun standing(double x_m) {
  MadeRun made = level_run(60.0, 40.0, 20.0);
  made.vehicle = rolling_run(60.0, 2.0).vehicle;
  made.run.samples = {sample_of(0.0, x_m, 0.0)};
  return made;
}

TEST(MomentView, ChasesFromBehindWithTheMachineInTheMiddle) {
  const MadeRun made = standing(30.0);
  const Box box{0.0, 0.0, 640.0, 360.0};
  const FieldView view = chase_view(made.scene(), made.run.samples[0], 0.0, box);
  EXPECT_LT(view.camera.eye_D.x(), 30.0 - made.vehicle.body.rear_overhang_m);
  EXPECT_GT(view.camera.eye_D.z(), made.vehicle.body.height_m);
  EXPECT_NEAR(pixel_of(view.camera, {30.0, 20.0, 0.0}).x(), 320.0, 1.0);
  // Straight ahead lies above it on the picture.
  EXPECT_LT(pixel_of(view.camera, {45.0, 20.0, 0.0}).y(),
            pixel_of(view.camera, {30.0, 20.0, 0.0}).y());
}

TEST(MomentView, ShowsTheMomentAskedForAndTheSameEachTime) {
  const MadeRun here = standing(30.0);
  const MadeRun there = standing(12.0);
  MomentOptions options;
  for (const MomentCamera camera : {MomentCamera::kChase, MomentCamera::kCloseUp}) {
    options.camera = camera;
    const Image first = draw_moment(here.scene(), kMomentSize, options);
    EXPECT_EQ(first.rgba, draw_moment(here.scene(), kMomentSize, options).rgba);
    EXPECT_NE(first.rgba, draw_moment(there.scene(), kMomentSize, options).rgba);
  }
}

TEST(MomentView, RefusesARunWithoutSamples) {
  const MadeRun made = level_run(60.0, 40.0, 20.0);
  EXPECT_THROW(draw_moment(made.scene(), kMomentSize, {}), InputError);
}

}  // namespace
}  // namespace headland

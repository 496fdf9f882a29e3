// Moments of a run: what was so then, and where it is on the picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
    EXPECT_THAT(error.what(),
                testing::HasSubstr("'worst_case': unknown event; did you mean 'worst_slip'?"));
  }
}

TEST(RunEvent, OfPeaksAreTheirTimesAndValuesAndNoneWithoutAPeak) {
  RunRecord run;
  run.peaks.slip = {0.25, 1.5};
  run.peaks.load_transfer_ratio = {-0.4, 2.5};
  run.peaks.cross_track_working_m = {-0.12, 3.5};
  run.peaks.cross_track_turning_m = {0.08, 4.5};
  run.peaks.battery_power_w = {2345.0, 5.5};
  run.peaks.boundary_overrun_m = {0.6, 6.5};
  run.peaks.belly_contact_m = {0.012, 7.5};
  const struct {
    const char* name;
    double time_s;
    const char* value;
  } expected[] = {{"worst_slip", 1.5, "25 % over half a second"},
                  {"load_transfer", 2.5, "40 % of the load shifted to one side"},
                  {"tracking", 3.5, "12 cm right of the path"},
                  {"power", 5.5, "2.35 kW from the battery"},
                  {"boundary_overrun", 6.5, "0.60 m beyond the boundary"},
                  {"belly_contact", 7.5, "12 mm into the ground"}};
  for (const auto& event : expected) {
    const std::optional<RunEvent> found = find_event(event.name, {}, run);
    ASSERT_TRUE(found) << event.name;
    EXPECT_EQ(found->time_s, event.time_s) << event.name;
    EXPECT_EQ(found->value, event.value);
    EXPECT_FALSE(find_event(event.name, {}, RunRecord{})) << event.name;
  }
  // The error on turns is the larger one now, to the other side.
  run.peaks.cross_track_turning_m.value = 0.2;
  EXPECT_EQ(find_event("tracking", {}, run)->time_s, 4.5);
  EXPECT_EQ(find_event("tracking", {}, run)->value, "20 cm left of the path");
  // A peak of a run that diverged has no place in it.
  run.peaks.slip.time_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(find_event("worst_slip", {}, run));
}

TEST(RunEvent, TheSteepestPlaceIsThatOfPitchAndRollTogether) {
  RunRecord run;
  for (int i = 0; i <= 4; ++i) run.samples.push_back(sample_of(i, i, 0.0));
  EXPECT_FALSE(find_event("steepest", {}, run)) << "level";
  run.samples[1].pitch_rad = std::atan(0.35);
  run.samples[2].pitch_rad = -std::atan(0.3);
  run.samples[2].roll_rad = std::atan(0.4);
  run.samples[3].roll_rad = -std::atan(0.45);
  const std::optional<RunEvent> steepest = find_event("steepest", {}, run);
  ASSERT_TRUE(steepest);
  EXPECT_EQ(steepest->time_s, 2.0);
  EXPECT_EQ(steepest->value, "50 % slope") << "0.3 and 0.4 at right angles";
  run.samples[2].roll_rad = 0.0;
  EXPECT_EQ(find_event("steepest", {}, run)->time_s, 3.0) << "less steep now";
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

double length_m(const std::vector<Eigen::Vector2d>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

TEST(MomentView, TellsTheEndOfAClosedPassFromItsBeginning) {
  MadeRun made = standing(20.0);
  PathSegment around;  // a circle from (20, 20) back to there
  constexpr double kRadius_m = 10.0;
  constexpr int kPieces = 200;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPieces;
    around.points.push_back(
        {{20.0 + kRadius_m * std::sin(angle), 20.0 + kRadius_m * (1.0 - std::cos(angle))},
         angle,
         0.0});
  }
  made.path.segments = {around};
  RunSample now = made.run.samples.front();
  now.segment = 0;
  now.travel_m = 0.0;
  made.run.samples = {now};
  const double reach_m = length_m(planned_ahead(made.scene(), now));
  EXPECT_GT(reach_m, 30.0) << "the way ahead at the beginning";
  // In the same place when all of it is driven, a little more than planned.
  now.travel_m = 2.0 * std::numbers::pi * kRadius_m + 0.5;
  now.time_s = 60.0;
  made.run.samples.push_back(now);
  EXPECT_LT(length_m(planned_ahead(made.scene(), now)), 0.5) << "nothing is left ahead";
  // Driven a metre more than planned, half way round: the place counts, not the metre.
  now.p_WB = {20.0, 40.0, 100.0};
  now.travel_m = std::numbers::pi * kRadius_m + 1.0;
  EXPECT_LT((planned_ahead(made.scene(), now).front() - now.p_WB.head<2>()).norm(), 0.2);
}

Rgba moment_colour(const Image& image, const FieldView& view, const Eigen::Vector3d& p_D) {
  const Eigen::Vector3d p = pixel_of(view.camera, p_D);
  const auto x = static_cast<std::size_t>(p.x());
  const auto y = static_cast<std::size_t>(p.y());
  const std::size_t i = 4 * (y * static_cast<std::size_t>(image.width) + x);
  return {image.rgba.at(i), image.rgba.at(i + 1), image.rgba.at(i + 2), image.rgba.at(i + 3)};
}

int levels_apart(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

constexpr PictureSize kChaseSize{1280, 800};
// The picture without its strip.
FieldView chase_of(const MadeRun& made, bool overlay) {
  const Page page = page_of(kChaseSize);
  const Box box{0.0, 0.0, 1280.0, 800.0 - std::round(page.px(overlay ? 92 : 76))};
  const RunSample& now = made.run.samples.back();
  return chase_view(made.scene(), now, trailing_heading_rad(made.run, now.time_s), box);
}

TEST(MomentView, ColoursTheWayDrivenByItsQuantity) {
  MadeRun made = standing(30.0);
  const RunSample now = made.run.samples.front();
  made.run.samples.clear();
  // Across the view ahead: much power on the right half of it, little on the left.
  for (int i = 0; i <= 80; ++i) {
    RunSample sample = sample_of(0.1 * i, 0.25 * i, 0.0);
    sample.p_WB = {45.0, 10.0 + 0.25 * i, 100.0};
    sample.battery_power_w = i <= 40 ? 4000.0 : 1000.0;
    made.run.samples.push_back(sample);
  }
  made.run.samples.push_back(now);
  made.run.samples.back().time_s = 100.0;
  made.run.samples.back().battery_power_w = 1000.0;
  MomentOptions options;
  options.overlay = PathQuantity::kPower;
  const QuantityScale scale = way_colours(made.run, PathQuantity::kPower).scale;
  const Image image = draw_moment(made.scene(), kChaseSize, options);
  const FieldView view = chase_of(made, true);
  constexpr int kLevelRounding = 2;  // levels of 255
  constexpr double kLift_m = 0.04;
  const Eigen::Vector3d right_D(45.0, 15.0, kLift_m);
  const Eigen::Vector3d left_D(45.0, 25.0, kLift_m);
  EXPECT_LE(levels_apart(moment_colour(image, view, right_D), quantity_colour(scale, 4000.0)),
            kLevelRounding);
  EXPECT_LE(levels_apart(moment_colour(image, view, left_D), quantity_colour(scale, 1000.0)),
            kLevelRounding);
  // Negative control: not beside it.
  const Eigen::Vector3d beside_D(46.5, 15.0, kLift_m);
  EXPECT_GT(levels_apart(moment_colour(image, view, beside_D), quantity_colour(scale, 4000.0)), 30);
}

// Furrows lie where the implement went, as many across as its width asks for, once it was there.
TEST(MomentView, DrawsAsManyFurrowsAsTheStripIsWideWhereItWasWorked) {
  MadeRun made = standing(30.0);
  made.vehicle.implement.working_width_m = 3.0;
  made.run.samples.front().time_s = 100.0;
  const Image before = draw_moment(made.scene(), kChaseSize, {});
  // 3 m wide, beside the machine and ahead of it.
  for (int i = 0; i <= 100; ++i) {
    made.run.footprints.push_back(
        {{28.0 + 0.2 * i, 26.0}, {28.0 + 0.2 * i, 23.0}, 10.0 + 0.1 * i, 0.2 * i, i == 0});
  }
  const Image worked = draw_moment(made.scene(), kChaseSize, {});
  const FieldView view = chase_of(made, false);
  const auto darker = [&](const Image& image, double x_m, double y_m) {
    const Eigen::Vector3d p_D(x_m, y_m, 0.03);
    return moment_colour(before, view, p_D).g - moment_colour(image, view, p_D).g;
  };
  // Two fifths of the ground's colour are the furrow's, of the ridge's beside it a tenth.
  constexpr int kFurrow = 35;
  constexpr int kRidge = 20;
  const auto furrows_at = [&](const Image& image, double x_m) {
    int furrows = 0;
    bool in_furrow = false;
    for (double y = 25.85; y > 23.05; y -= 0.01) {
      const int dark = darker(image, x_m, y);
      if (dark > kFurrow && !in_furrow) ++furrows;
      in_furrow = dark > (in_furrow ? kRidge : kFurrow);
    }
    return furrows;
  };
  EXPECT_EQ(furrows_at(worked, 34.0), 7) << "0.45 m apart, about, in 3 m";
  EXPECT_EQ(furrows_at(before, 34.0), 0);
  for (const auto& [x, y] : {std::pair{34.0, 26.4}, {34.0, 22.6}, {50.0, 24.5}}) {
    EXPECT_EQ(darker(worked, x, y), 0) << "not worked at " << x << ", " << y;
  }
  // Negative control: all of it lies in the future.
  made.run.samples.front().time_s = 5.0;
  const Image earlier = draw_moment(made.scene(), kChaseSize, {});
  for (double y = 23.2; y < 25.8; y += 0.05) EXPECT_EQ(darker(earlier, 34.0, y), 0) << y;
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

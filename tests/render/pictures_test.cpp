// What the three pictures show, told by their pixels.
#include "render/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "evaluate/atomic_file.h"
#include "render/field_view.h"
#include "render/map_base.h"
#include "terrains/input_error.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr PictureSize kSize{800, 500};
constexpr int kColourRounding = 1;  // levels of 255
constexpr double kPixel = 1.0;

Rgba pixel(const Image& image, double x_px, double y_px) {
  const auto x = static_cast<std::size_t>(std::floor(x_px));
  const auto y = static_cast<std::size_t>(std::floor(y_px));
  const std::size_t i = 4 * (y * static_cast<std::size_t>(image.width) + x);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

int difference(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// Map pixels by this test's own reckoning from the window and its place.
Rgba map_pixel(const Image& image, const MapCamera& camera, double x_m, double y_m) {
  const double sx = camera.view_px.width / (camera.window.high.x() - camera.window.low.x());
  const double sy = camera.view_px.height / (camera.window.high.y() - camera.window.low.y());
  return pixel(image, camera.view_px.x + sx * (x_m - camera.window.low.x()),
               camera.view_px.y + sy * (camera.window.high.y() - y_m));
}

// Pinhole by this test's own reckoning: angles of the ray against the line of sight.
Eigen::Vector2d seen_at(const Camera& camera, const Eigen::Vector3d& p_D) {
  const Eigen::Vector3d sight = (camera.target_D - camera.eye_D).normalized();
  const Eigen::Vector3d right = Eigen::Vector3d(sight.y(), -sight.x(), 0.0).normalized();
  const Eigen::Vector3d up = right.cross(sight);
  const Eigen::Vector3d ray = p_D - camera.eye_D;
  return {camera.view_px.x + 0.5 * camera.view_px.width +
              camera.focal_px * ray.dot(right) / ray.dot(sight),
          camera.view_px.y + 0.5 * camera.view_px.height -
              camera.focal_px * ray.dot(up) / ray.dot(sight)};
}

TEST(FieldMap, ShowsGroundInTheColoursOfItsLegend) {
  MadeRun made = level_run(100.0, 60.0, 20.0);
  cover_strip(made.coverage, {10.0, 45.0}, {90.0, 45.0}, 8.0);
  for (int times = 0; times < 2; ++times) {
    cover_strip(made.coverage, {10.0, 30.0}, {90.0, 30.0}, 8.0);
  }
  for (int times = 0; times < 3; ++times) {
    cover_strip(made.coverage, {10.0, 15.0}, {90.0, 15.0}, 8.0);
  }
  const Image image = draw_field_map(made.scene(), kSize);
  const Page page = page_of(kSize);
  const MapCamera camera = map_view(made.scene(), page).camera;
  const struct {
    double y_m;
    Rgba colour;
  } strips[] = {{45.0, colours::kOnce},
                {30.0, colours::kTwice},
                {15.0, colours::kThrice},
                {53.0, colours::kMissed},
                {-1.5, colours::kGround}};
  for (const auto& strip : strips) {
    EXPECT_LE(difference(map_pixel(image, camera, 50.0, strip.y_m), strip.colour), kColourRounding)
        << "at y = " << strip.y_m;
    if (strip.colour == colours::kGround) continue;
    int in_legend = 0;
    for (double x = page.column.x; x < page.column.right(); ++x) {
      for (double y = page.column.y; y < page.column.bottom(); ++y) {
        if (pixel(image, x, y) == strip.colour) ++in_legend;
      }
    }
    EXPECT_GT(in_legend, 30) << "swatch for y = " << strip.y_m;
  }
}

TEST(FieldMap, SaysNothingOfTerrainThatItDoesNotKnow) {
  const MadeRun made = level_run(100.0, 60.0, 20.0);
  const Page page = page_of(kSize);
  const auto inked = [&](const PictureScene& scene) {
    const Image image = draw_field_map(scene, kSize);
    int pixels = 0;
    for (double x = page.column.x; x < page.column.right(); ++x) {
      for (double y = page.column.y; y < page.column.bottom(); ++y) {
        pixels += pixel(image, x, y) == colours::kInk || pixel(image, x, y) == colours::kRule;
      }
    }
    return pixels;
  };
  PictureScene unknown = made.scene();
  unknown.terrain_known = false;
  // A heading less, with the rule below it.
  EXPECT_LT(inked(unknown), inked(made.scene()) - page.column.width);
}

TEST(FieldMap, CallsNothingMissedThatARecordMayHaveLost) {
  const MadeRun made = level_run(100.0, 60.0, 20.0);
  PictureScene scene = made.scene();
  scene.missing = "Ground covered is known in part at most";
  const Image image = draw_field_map(scene, kSize);
  const Page page = page_of(kSize);
  const MapCamera camera = map_view(scene, page).camera;
  EXPECT_LE(difference(map_pixel(image, camera, 50.0, 30.0), colours::kUnworked), kColourRounding);
  // The title says so, which one of a whole record does not.
  const auto warned = [&](const Image& drawn) {
    int pixels = 0;
    for (double x = page.main.x; x < page.column.right(); ++x) {
      for (double y = 0.0; y < page.main.y; ++y) pixels += pixel(drawn, x, y) == colours::kWarn;
    }
    return pixels;
  };
  EXPECT_GT(warned(image), 30);
  EXPECT_EQ(warned(draw_field_map(made.scene(), kSize)), 0);
}

TEST(FieldMap, KeepsTheAspectAndDrawsTheBoundaryInItsPlace) {
  const MadeRun made = level_run(100.0, 60.0, 20.0);
  const Image image = draw_field_map(made.scene(), kSize);
  const MapCamera camera = map_view(made.scene(), page_of(kSize)).camera;
  const Eigen::Vector2d metres = camera.window.high - camera.window.low;
  EXPECT_NEAR(camera.view_px.width / metres.x(), camera.view_px.height / metres.y(), 1e-9);
  for (const auto& [x, y] : {std::pair{100.0, 20.0}, {0.0, 20.0}, {50.0, 60.0}, {50.0, 0.0}}) {
    EXPECT_LE(difference(map_pixel(image, camera, x, y), colours::kBoundary), 60)
        << x << ", " << y;  // a line of 1.5 px does not fill its pixel
  }
}

TEST(FieldMap, MarksStartAndEndOfWhatWasDriven) {
  MadeRun made = level_run(100.0, 60.0, 20.0);
  RunSample sample;
  sample.p_WB = {20.0, 20.0, 100.0};
  made.run.samples.push_back(sample);
  sample.p_WB = {80.0, 20.0, 100.0};
  sample.travel_m = 60.0;
  sample.time_s = 60.0;
  made.run.samples.push_back(sample);
  const Image image = draw_field_map(made.scene(), kSize);
  const MapCamera camera = map_view(made.scene(), page_of(kSize)).camera;
  EXPECT_LE(difference(map_pixel(image, camera, 20.0, 20.0), colours::kStart), kColourRounding);
  EXPECT_LE(difference(map_pixel(image, camera, 80.0, 20.0), colours::kEnd), kColourRounding);
  EXPECT_GT(difference(map_pixel(image, camera, 50.0, 20.0), colours::kMissed), 60)
      << "driven line";
}

TEST(EnergyMap, ColoursTheTrackByItsEnergy) {
  MadeRun made = level_run(100.0, 60.0, 20.0);
  // 40 m using 2 Wh/m, then 40 m giving back 1 Wh/m.
  for (int i = 0; i <= 160; ++i) {
    RunSample sample;
    sample.travel_m = 0.5 * i;
    sample.time_s = sample.travel_m;
    sample.p_WB = {10.0 + sample.travel_m, 30.0, 100.0};
    sample.battery_power_w = sample.travel_m < 40.0 ? 7200.0 : -3600.0;
    made.run.samples.push_back(sample);
  }
  const Image image = draw_energy_map(made.scene(), kSize);
  const MapCamera camera = map_view(made.scene(), page_of(kSize)).camera;
  EXPECT_LE(difference(map_pixel(image, camera, 30.0, 30.0), energy_colour(1.0)), kColourRounding);
  EXPECT_LE(difference(map_pixel(image, camera, 70.0, 30.0), energy_colour(-1.0)), kColourRounding);
}

// Rows and columns of the main box that an obstacle changes.
struct Change {
  double top = 1e9;
  double bottom = -1e9;
  double top_x = 0.0;  // middle of the topmost changed row
};
Change change_between(const Image& a, const Image& b, const Box& box) {
  constexpr int kSeen = 12;  // levels
  Change change;
  for (double y = box.y; y < box.bottom(); ++y) {
    double sum = 0.0;
    int count = 0;
    for (double x = box.x; x < box.right(); ++x) {
      if (difference(pixel(a, x, y), pixel(b, x, y)) < kSeen) continue;
      sum += x + 0.5;
      ++count;
    }
    if (count == 0) continue;
    if (change.top > y) change = {y, y, sum / count};
    change.bottom = y;
  }
  return change;
}

TEST(View, ShowsAPoleWhereItsCameraSeesIt) {
  MadeRun made = level_run(60.0, 40.0, 20.0);
  const Obstacle pole{ObstacleKind::kPole, {38.0, 22.0}, 0.5, 7.0};
  // The camera takes obstacles into account, so the other picture has a flat one in its place.
  made.field.obstacles = {pole};
  const Image with = draw_view(made.scene(), kSize);
  const Page page = view_page(kSize);
  const FieldView view = field_view(made.scene(), page);
  made.field.obstacles = {pole};
  made.field.obstacles.front().radius_m = 1e-6;
  const Image without = draw_view(made.scene(), kSize);

  double top = 1e9;
  double bottom = -1e9;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 64;
    const Eigen::Vector3d rim(38.0 + 0.5 * std::cos(angle), 22.0 + 0.5 * std::sin(angle), 0.0);
    top = std::min(top, seen_at(view.camera, rim + Eigen::Vector3d(0.0, 0.0, 7.0)).y());
    bottom = std::max(bottom, seen_at(view.camera, rim).y());
  }
  const Change change = change_between(with, without, page.main);
  EXPECT_NEAR(change.top + 0.5, top, kPixel);
  EXPECT_NEAR(change.bottom + 0.5, bottom, kPixel);
  EXPECT_NEAR(change.top_x, seen_at(view.camera, {38.0, 22.0, 7.0}).x(), kPixel);
}

TEST(View, HidesWhatIsBehindSomethingNearer) {
  MadeRun made = level_run(60.0, 40.0, 20.0);
  const FieldView view = field_view(made.scene(), view_page(kSize));
  const Eigen::Vector2d away(std::cos(view.heading_rad), std::sin(view.heading_rad));
  const Obstacle near{ObstacleKind::kRock, {30.0, 20.0}, 4.0, 9.0};
  const Obstacle far{ObstacleKind::kRock, near.p_W + 6.0 * away, 1.0, 2.0};
  const auto at_far = [&](std::vector<Obstacle> obstacles) {
    made.field.obstacles = std::move(obstacles);
    const Camera camera = field_view(made.scene(), view_page(kSize)).camera;
    const Eigen::Vector2d p = seen_at(camera, {far.p_W.x(), far.p_W.y(), 1.2});
    return pixel(draw_view(made.scene(), kSize), p.x(), p.y());
  };
  const Rgba both = at_far({far, near});
  EXPECT_EQ(both, at_far({near, far})) << "whichever is drawn first";
  EXPECT_EQ(both, at_far({near}));
  // Negative control: without the near one the far one is seen.
  EXPECT_GT(difference(at_far({far}), at_far({})), 20);
}

TEST(View, ShowsWorkedSoilOnLevelGroundInTheColourOfItsLegend) {
  MadeRun made = level_run(60.0, 40.0, 20.0);
  cover_strip(made.coverage, {5.0, 20.0}, {55.0, 20.0}, 10.0);
  const Image image = draw_view(made.scene(), kSize);
  const Camera camera = field_view(made.scene(), view_page(kSize)).camera;
  const Eigen::Vector2d worked = seen_at(camera, {30.0, 20.0, 0.0});
  const Eigen::Vector2d left = seen_at(camera, {30.0, 35.0, 0.0});
  EXPECT_LE(difference(pixel(image, worked.x(), worked.y()), colours::kWorked), kColourRounding);
  EXPECT_LE(difference(pixel(image, left.x(), left.y()), colours::kUnworked), kColourRounding);
}

Image draw_whole_view(const PictureScene& scene, const PictureSize& size) {
  return draw_view(scene, size);
}
Image draw_whole_elevation(const PictureScene& scene, const PictureSize& size) {
  return draw_elevation(scene, size);
}
Image draw_slip_map(const PictureScene& scene, const PictureSize& size) {
  return draw_quantity_map(scene, size, PathQuantity::kSlip);
}

using Draw = Image (*)(const PictureScene&, const PictureSize&);
class EveryPicture : public testing::TestWithParam<Draw> {};
INSTANTIATE_TEST_SUITE_P(Pictures, EveryPicture,
                         testing::Values(&draw_field_map, &draw_whole_view, &draw_energy_map,
                                         &draw_whole_elevation, &draw_slip_map));

TEST_P(EveryPicture, IsTheSameEachTime) {
  const MadeRun made = rolling_run(60.0, 3.0);
  const Image first = GetParam()(made.scene(), {480, 300});
  EXPECT_EQ(first.width, 480);
  EXPECT_EQ(first.rgba, GetParam()(made.scene(), {480, 300}).rgba);
}

TEST_P(EveryPicture, DrawsWhatThereIsOfACutOffRecord) {
  MadeRun made = level_run(60.0, 40.0, 20.0);
  const Image nothing = GetParam()(made.scene(), {480, 300});
  EXPECT_EQ(nothing.rgba.size(), 4U * 480U * 300U);
  made.run.samples.resize(1);
  made.run.samples[0].p_WB = {30.0, 20.0, 100.0};
  EXPECT_NE(GetParam()(made.scene(), {480, 300}).rgba, nothing.rgba);
  // A run that diverged.
  RunSample broken;
  broken.p_WB.setConstant(std::numeric_limits<double>::quiet_NaN());
  made.run.samples.push_back(broken);
  EXPECT_NE(GetParam()(made.scene(), {480, 300}).rgba, nothing.rgba);
  made.coverage = {};
  EXPECT_EQ(GetParam()(made.scene(), {480, 300}).height, 300);
}

TEST_P(EveryPicture, RefusesSizesItCannotDraw) {
  const MadeRun made = level_run(60.0, 40.0, 20.0);
  const auto message = [&](PictureSize size) -> std::string {
    try {
      GetParam()(made.scene(), size);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_THAT(message({100, 500}), HasSubstr("'100x500': at least 240 pixels"));
  EXPECT_THAT(message({100000, 500}), HasSubstr("'100000x500': at most"));
}

TEST(Typeface, NamesThePackageOfAMissingFont) {
  try {
    const Typeface typeface("/nowhere/Sans.ttf", kBoldFontFile);
    FAIL() << "a missing font was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/Sans.ttf"));
    EXPECT_THAT(error.what(), HasSubstr("fonts-dejavu-core"));
  }
}

TEST(Typeface, ReadsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(letters("aÄ€𝄞"), U"aÄ€𝄞");
  EXPECT_EQ(letters("\xC3"), U"\uFFFD");
  EXPECT_EQ(letters("\xFF"
                    "b"),
            U"\uFFFDb");
}

TEST(Pictures, AreWrittenForTheEyeOnRequest) {
  const char* folder = std::getenv("HEADLAND_LOOK_AT");
  if (folder == nullptr) GTEST_SKIP() << "set HEADLAND_LOOK_AT to a folder to get the pictures";
  const std::filesystem::path to(folder);
  const MadeRun large = rolling_run(420.0, 9.0);
  const MadeRun small = rolling_run(60.0, 2.0);
  for (const auto& [name, made] : {std::pair{"large", &large}, {"small", &small}}) {
    const std::string stem(name);
    write_together(to, {{stem + "_field.png", png_of(draw_field_map(made->scene(), {}))},
                        {stem + "_view.png", png_of(draw_view(made->scene(), {}))},
                        {stem + "_energy.png", png_of(draw_energy_map(made->scene(), {}))}});
  }
}

}  // namespace
}  // namespace headland

// What pictures of region plans show, told by their pixels.
#include "render/region_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "render/gl_context.h"
#include "render/region_panel.h"

namespace headland {
namespace {

constexpr int kColourLevels = 2;  // of 255: rounding of colours
constexpr double kScale = 12.0;   // pixels a metre

// Two parts of 50 m by 40 m side by side, a hole in the second, a strip not worked above.
RegionGround two_parts() {
  RegionGround ground;
  ground.ground.outer = {{0, 0}, {100, 0}, {100, 50}, {0, 50}};
  ground.ground.holes = {{{70, 10}, {70, 20}, {80, 20}, {80, 10}}};
  ground.parts_W = {{{0, 0}, {50, 0}, {50, 40}, {0, 40}}, {{50, 0}, {100, 0}, {100, 40}, {50, 40}}};
  ground.dropped_W = {{{0, 40}, {100, 40}, {100, 50}, {0, 50}}};
  return ground;
}

Image painted_region(const RegionGround& ground, const std::vector<DrawnVisit>& visits) {
  const Eigen::AlignedBox2d box_W = seen_box(ground);
  const Eigen::Vector2i size = (kScale * box_W.sizes()).cast<int>();
  Typeface typeface(kFontFile, kBoldFontFile);
  const GlContext context;
  const GlFrame frame(size.x(), size.y(), colours::kPaper);
  Sheet sheet;
  draw_region_panel(sheet, typeface, {ground, box_W, {0, 0}, kScale}, visits);
  return frame.draw([&](const Canvas& canvas) { paint(sheet, typeface, canvas); });
}

class RegionPixels : public testing::Test {
 protected:
  RegionGround ground_ = two_parts();
  // Up the left part, over to the right one, which is worked along x.
  std::vector<DrawnVisit> visits_ = {{0, {{10, 5}, {10, 35}}}, {1, {{60, 30}, {90, 30}}}};
  Image image_ = painted_region(ground_, visits_);

  Rgba pixel(double x_m, double y_m) const {
    const Eigen::Vector2d p =
        place_px({ground_, seen_box(ground_), {0, 0}, kScale}, Eigen::Vector2d(x_m, y_m));
    const std::size_t i =
        4 * (static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(image_.width) +
             static_cast<std::size_t>(p.x()));
    return {image_.rgba[i], image_.rgba[i + 1], image_.rgba[i + 2], image_.rgba[i + 3]};
  }
  static bool alike(Rgba a, Rgba b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <=
           kColourLevels;
  }
};

TEST_F(RegionPixels, PartsHolesAndWhatIsNotWorkedAreToldApart) {
  const Rgba left = pixel(40, 10);
  const Rgba right = pixel(90, 10);
  EXPECT_FALSE(alike(left, right));
  EXPECT_GT(std::min({left.r, left.g, left.b}), 190);  // light
  EXPECT_TRUE(alike(pixel(75, 15), colours::kHoleGround));
  // Hatched: most of it has its own colour.
  int plain = 0;
  for (int i = 0; i < 50; ++i)
    plain += alike(pixel(5 + 1.7 * i, 45), colours::kDroppedPart) ? 1 : 0;
  EXPECT_GT(plain, 25);
  EXPECT_LT(plain, 50);
  EXPECT_TRUE(alike(pixel(102, 25), colours::kPaper));
}

TEST_F(RegionPixels, SweepsStartAndEndAreWhereTheyAre) {
  EXPECT_TRUE(alike(pixel(10, 20), colours::kSweepLine));
  EXPECT_TRUE(alike(pixel(75, 30), colours::kSweepLine));
  EXPECT_TRUE(alike(pixel(10, 5), colours::kPlanStart));
  EXPECT_TRUE(alike(pixel(90, 30), colours::kPlanEnd));
  // Dashes along the way from (10, 35) to (60, 30).
  int dashes = 0;
  for (int i = 1; i < 200; ++i) {
    dashes += alike(pixel(10 + 0.25 * i, 35 - 0.025 * i), colours::kPartLink) ? 1 : 0;
  }
  EXPECT_GT(dashes, 50);
  EXPECT_LT(dashes, 150);
}

TEST_F(RegionPixels, GivenEndsAreShownAndJoined) {
  ground_.start_W = Eigen::Vector2d(-20, 5);
  ground_.end_W = Eigen::Vector2d(120, 30);
  image_ = painted_region(ground_, visits_);
  EXPECT_TRUE(alike(pixel(-20, 5), colours::kPlanStart));
  EXPECT_TRUE(alike(pixel(120, 30), colours::kPlanEnd));
  EXPECT_FALSE(alike(pixel(10, 5), colours::kPlanStart));
}

TEST(RegionPicture, HasRoomForPlansAndFigures) {
  const RegionGround ground = two_parts();
  const RegionFigure figure{"one", {"1 m"}, {{0, {{10, 5}, {10, 35}}}}};
  const std::vector<RegionFigure> figures(3, figure);
  const Image alone = draw_region_plan(ground, figure);
  EXPECT_GT(alone.width, 1200);
  const Image sheet = draw_region_sheet(ground, "three", figures);
  EXPECT_GT(sheet.width, sheet.height);
}

}  // namespace
}  // namespace headland

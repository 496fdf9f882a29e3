// Pictures in tiles: the same as in one piece.
#include <gtest/gtest.h>

#include <cstdlib>

#include "render/moment_view.h"
#include "render/world.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

// A tile moves the whole view by whole pixels. In single precision the corners of triangles then
// round differently now and then, which can change a sample of a pixel on an edge.
constexpr double kMostDifferent = 1e-4;  // share of the pixels
constexpr int kLevels = 1;               // of 255, by which others may differ

double share_that_differs(const Image& a, const Image& b) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(a.rgba[c] - b.rgba[c]));
    if (most > kLevels) ++differing;
  }
  return 4.0 * static_cast<double>(differing) / static_cast<double>(a.rgba.size());
}

TEST(Tiles, MakeTheSamePictureAsOnePiece) {
  const MadeRun made = rolling_run(60.0, 3.0);
  const PictureScene scene = made.scene();
  const RunSample* sample = last_pose(scene.run);
  const Box box{0.0, 0.0, 500.0, 300.0};
  const FieldView view = close_up(scene, *sample, box);
  Typeface typeface(kFontFile, kBoldFontFile);
  const GlContext context;
  const World world(scene, view.relief, moment_sun());
  const Shot shot(world, view, Surroundings::kSky, sample);
  const SurfaceCoverage coverage(coverage_classes(scene.coverage, true));
  Sheet lines;
  draw_boundaries(lines, scene, view, 2.0);
  Sheet margin;
  write_text(margin, typeface, {120.0, 130.0}, "across the tiles", {20, true}, colours::kInk);
  const auto paint_all = [&](const Canvas& canvas) {
    paint_world(canvas, typeface, world, shot, coverage, lines);
    paint(margin, typeface, canvas);
  };
  const Image whole = GlFrame(500, 300, colours::kPaper).draw(paint_all);
  // Edge tiles are cut off in either direction.
  for (const int tile_px : {128, 70}) {
    const Image tiled = GlFrame(500, 300, colours::kPaper, tile_px).draw(paint_all);
    ASSERT_EQ(tiled.rgba.size(), whole.rgba.size());
    EXPECT_LE(share_that_differs(whole, tiled), kMostDifferent) << "tiles of " << tile_px;
  }
  // Negative control: moved by a pixel the pictures differ in many places.
  Image moved = whole;
  std::rotate(moved.rgba.begin(), moved.rgba.begin() + 4, moved.rgba.end());
  EXPECT_GT(share_that_differs(whole, moved), 0.05);
}

}  // namespace
}  // namespace headland

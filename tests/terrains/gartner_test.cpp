// A real field: see the README beside the data for what is expected of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "terrains/field_source.h"
#include "terrains/terrain_source.h"
#include "terrains/track.h"

namespace headland {
namespace {

class Gartner : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << " here";
  }
  Field field() const {
    FieldSource source;
    source.file = folder / "boundary.geojson";
    return read_field(source, "scenario");
  }

  std::filesystem::path folder =
      std::filesystem::path(HEADLAND_SOURCE_DIR) / "../shared/data/gartner";
};

TEST_F(Gartner, FieldHasTheStatedSize) {
  const Field read = field();
  // The stated figures are rounded to 0.1 ha and 10 m2.
  EXPECT_NEAR(field_area_m2(read) * 1e-4, 27.7, 0.05);
  EXPECT_EQ(read.boundary.size(), 96U);
  ASSERT_EQ(read.holes.size(), 1U);
  EXPECT_NEAR(signed_area_m2(read.holes[0]), -390.0, 5.0);
  EXPECT_EQ(read.name, "Gartner corn field");
}

TEST_F(Gartner, TerrainHasTheHeightsOfTheLog) {
  const Field read = field();
  TerrainSource source;
  source.file = folder / "dem.tif";
  const Heightfield terrain = read_terrain(source, read, "scenario");
  EXPECT_EQ(terrain.cell_m, 1.0);
  const auto [low, high] = std::ranges::minmax(terrain.height_m);
  // The log's 311.8 to 325.8 m lost their extremes to a 10 m Gaussian.
  EXPECT_GT(low, 311.8);
  EXPECT_LT(high, 325.8);
  EXPECT_GT(high - low, 10.0);
  std::vector<double> slopes;
  for (double x = terrain.origin_W.x(); x < -terrain.origin_W.x(); x += 4.0) {
    for (double y = terrain.origin_W.y(); y < -terrain.origin_W.y(); y += 4.0) {
      if (inside_field(read, {x, y})) slopes.push_back(surface_at(terrain, x, y).gradient.norm());
    }
  }
  std::ranges::sort(slopes);
  // Stated 6.8 and 10.8 %, from differences of 5 m cells and over the ground around the field too.
  EXPECT_NEAR(slopes[slopes.size() * 95 / 100], 0.068, 0.004);
  EXPECT_NEAR(slopes.back(), 0.108, 0.003);
}

TEST_F(Gartner, TrackCoversTheFieldAndBreaksAtItsTurns) {
  const Field read = field();
  const Track track = read_track(folder / "driven_track.csv", read);
  EXPECT_EQ(track.points_W.size(), 4949U);
  const std::set<std::size_t> breaks(track.break_before.begin(), track.break_before.end());
  // 39 gaps of 21 to 27 s are turns; the other breaks are where the combine went on elsewhere.
  EXPECT_GE(breaks.size(), 39U);
  EXPECT_LE(breaks.size(), 80U);
  // Lines 164 and 165: stopped for 120 s and went on in line, 6 m further.
  EXPECT_FALSE(breaks.contains(163));
  EXPECT_EQ(track.pauses.breaks, static_cast<int>(breaks.size()));
  EXPECT_EQ(track.pauses.count - track.pauses.breaks, 17);
  EXPECT_EQ(track.pauses.longest_interval_s, 9.0);
  double length_m = 0.0;
  for (std::size_t i = 1; i < track.points_W.size(); ++i) {
    if (!breaks.contains(i)) length_m += (track.points_W[i] - track.points_W[i - 1]).norm();
  }
  // A 9.144 m header over the field's area, give or take the overlap of a driver without guidance.
  EXPECT_NEAR(length_m * 9.144 / field_area_m2(read), 1.0, 0.05);
}

}  // namespace
}  // namespace headland

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_ring.h"
#include "refusal.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kSummation_m = 1e-9;

Field square_field(double side_m) {
  Field field;
  field.boundary = {{0.0, 0.0}, {side_m, 0.0}, {side_m, side_m}, {0.0, side_m}};
  return field;
}

TerrainSource generated(const std::string& generator, Parameters parameters = {}) {
  TerrainSource source;
  source.generator = generator;
  source.parameters = std::move(parameters);
  return source;
}

double rms_m(const Heightfield& terrain) {
  double squares = 0.0;
  for (double height_m : terrain.height_m) squares += height_m * height_m;
  return std::sqrt(squares / static_cast<double>(terrain.height_m.size()));
}

TEST(Generators, TerrainCoversTheFieldAndItsMargin) {
  EXPECT_TRUE(rc::check([] {
    Field field;
    field.boundary = any_ring({any_number(-1e4, 1e4), any_number(-1e4, 1e4)});
    TerrainSource source = generated("flat");
    source.margin_m = any_number(1.0, 50.0);
    source.cell_m = any_number(0.5, 7.0);
    const Heightfield terrain = read_terrain(source, field, "test");
    for (const Eigen::Vector2d& p_W : field.boundary) {
      for (double side : {-1.0, 1.0}) {
        const Eigen::Vector2d far_W =
            p_W + side * (source.margin_m - kSummation_m) * Eigen::Vector2d::Ones();
        RC_ASSERT(surface_at(terrain, far_W.x(), far_W.y()).inside);
      }
    }
    RC_ASSERT(terrain.height_m.size() ==
              static_cast<std::size_t>(terrain.columns) * static_cast<std::size_t>(terrain.rows));
  }));
}

TEST(Generators, EveryOneIsFiniteAndTheSameTwice) {
  for (const GeneratorEntry& entry : generators()) {
    const TerrainSource source = generated(std::string(entry.name));
    const Heightfield first = read_terrain(source, square_field(60.0), "test");
    const Heightfield second = read_terrain(source, square_field(60.0), "test");
    EXPECT_EQ(first.height_m, second.height_m) << entry.name;
    EXPECT_TRUE(std::ranges::all_of(first.height_m, [](double h) { return std::isfinite(h); }));
    EXPECT_FALSE(entry.what.empty());
  }
}

TEST(Generators, RampIsAPlaneOfTheStatedSlope) {
  const Heightfield terrain =
      read_terrain(generated("ramp", {{"slope_percent", 20.0}, {"direction_deg", 30.0}}),
                   square_field(50.0), "test");
  const Eigen::Vector2d gradient = surface_at(terrain, 13.3, 27.7).gradient;
  EXPECT_NEAR(gradient.norm(), 0.2, kSummation_m);
  EXPECT_NEAR(std::atan2(gradient.y(), gradient.x()), std::numbers::pi / 6.0, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 25.0, 25.0).height_m, 0.0, kSummation_m);
}

TEST(Generators, RollingHillsHaveTheRmsOfOneSine) {
  // Ten waves over twenty wavelengths: what is left of their averages is a few percent.
  constexpr double kSpread = 0.05;
  for (std::uint64_t seed : {1U, 2U, 3U}) {
    TerrainSource source = generated("rolling", {{"amplitude_m", 2.0}, {"wavelength_m", 50.0}});
    source.seed = seed;
    source.cell_m = 5.0;
    const Heightfield terrain = read_terrain(source, square_field(1000.0), "test");
    EXPECT_NEAR(rms_m(terrain), 2.0 / std::sqrt(2.0), kSpread * 2.0) << "seed " << seed;
  }
}

TEST(Generators, RollingHillsAreNotCorrugatedIron) {
  // A surface of one direction would have all its slope along it: least over greatest mean square
  // slope would be 0; of an isotropic one it is 1.
  constexpr double kLeastRatio = 0.4;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    TerrainSource source = generated("rolling", {{"wavelength_m", 50.0}});
    source.seed = seed;
    source.cell_m = 5.0;
    const Heightfield terrain = read_terrain(source, square_field(500.0), "test");
    Eigen::Matrix2d slopes = Eigen::Matrix2d::Zero();
    for (double x = 2.0; x < 500.0; x += 5.0) {
      for (double y = 2.0; y < 500.0; y += 5.0) {
        const Eigen::Vector2d gradient = surface_at(terrain, x, y).gradient;
        slopes += gradient * gradient.transpose();
      }
    }
    const double half_trace = 0.5 * slopes.trace();
    const double radius = std::sqrt(half_trace * half_trace - slopes.determinant());
    EXPECT_GT((half_trace - radius) / (half_trace + radius), kLeastRatio) << "seed " << seed;
  }
}

TEST(Generators, AnotherSeedIsAnotherLandscape) {
  TerrainSource source = generated("rolling");
  const Heightfield first = read_terrain(source, square_field(60.0), "test");
  source.seed = 2;
  EXPECT_NE(first.height_m, read_terrain(source, square_field(60.0), "test").height_m);
}

TEST(Generators, HillsStayWhereTheyAreWhenTheCellsChange) {
  TerrainSource source = generated("rolling");
  source.cell_m = 1.0;
  const Heightfield fine = read_terrain(source, square_field(60.0), "test");
  source.cell_m = 2.0;
  const Heightfield coarse = read_terrain(source, square_field(60.0), "test");
  EXPECT_NEAR(surface_at(fine, 20.0, 30.0).height_m, surface_at(coarse, 20.0, 30.0).height_m,
              kSummation_m);
}

TEST(Generators, BowlHasItsDepthAndGreatestSlope) {
  TerrainSource source = generated("bowl", {{"depth_m", 6.0}, {"radius_m", 80.0}});
  source.cell_m = 0.5;
  const Heightfield terrain = read_terrain(source, square_field(200.0), "test");
  EXPECT_NEAR(surface_at(terrain, 100.0, 100.0).height_m, 0.0, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 5.0, 100.0).height_m, 6.0, kSummation_m);
  // d/dr of depth (1 - cos(pi r / R)) / 2 is greatest at R / 2: pi depth / (2 R). Cells of 0.5 m
  // err by their square times the third derivative, 1e-4 of it.
  EXPECT_NEAR(surface_at(terrain, 140.1, 100.1).gradient.x(), std::numbers::pi * 6.0 / (2.0 * 80.0),
              2e-4);
}

TEST(Generators, TerracesAreLevelAndRiseByTheirStep) {
  TerrainSource source = generated(
      "terraces", {{"step_m", 1.5}, {"tread_m", 20.0}, {"riser_m", 4.0}, {"direction_deg", 0.0}});
  source.cell_m = 0.5;
  const Heightfield terrain = read_terrain(source, square_field(100.0), "test");
  EXPECT_NEAR(surface_at(terrain, 50.0, 10.0).height_m, 0.0, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 50.0 + 24.0, 10.0).height_m, 1.5, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 50.0 - 24.0, 10.0).height_m, -1.5, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 55.1, 10.1).gradient.norm(), 0.0, kSummation_m);
  EXPECT_NEAR(surface_at(terrain, 62.1, 10.1).gradient.x(), 1.5 / 4.0, kSummation_m);
}

TEST(Generators, UnknownOneIsRefusedWithTheNearest) {
  EXPECT_EQ(refusal([] { read_terrain(generated("rollin"), square_field(50.0), "demo.yaml"); }),
            "demo.yaml: terrain.generator: 'rollin': unknown generator; the nearest is rolling");
}

TEST(Generators, ParameterOutOfRangeIsRefused) {
  EXPECT_THAT(refusal([] {
                read_terrain(generated("ramp", {{"slope_percent", 500.0}}), square_field(50.0),
                             "demo.yaml");
              }),
              HasSubstr("terrain.slope_percent: '500': a number from 0 to 60"));
}

TEST(Generators, TerrainTooLargeForMemoryIsRefusedBeforeItIsMade) {
  TerrainSource source = generated("flat");
  source.cell_m = 0.01;
  const std::string line = refusal([&] { read_terrain(source, square_field(2000.0), "a.yaml"); });
  EXPECT_THAT(line, HasSubstr("a.yaml: terrain.cell_m: '0.01': 206001 x 206001 nodes need 3394.9 "
                              "GB, 2.0 GB are allowed: give at least 0.43 m"));
  // What it advises fits: 2060 m of nodes 0.43 m apart at 80 bytes each.
  EXPECT_LT(80.0 * std::pow(2060.0 / 0.43 + 2.0, 2), kMaxTerrainBytes);
}

TEST(Generators, AbsurdNumbersAreRefused) {
  const auto line = [](const TerrainSource& source) {
    return refusal([&] { read_terrain(source, square_field(50.0), "a.yaml"); });
  };
  TerrainSource source = generated("flat");
  source.cell_m = -1.0;
  EXPECT_THAT(line(source), HasSubstr("terrain.cell_m: '-1': a number from 0.01 to 100 m"));
  source = generated("flat");
  source.margin_m = std::nan("");
  EXPECT_THAT(line(source), HasSubstr("terrain.margin_m: 'nan': a number from 1 to 1000 m"));
  source = generated("flat");
  source.micro_relief.rms_m = -0.1;
  EXPECT_THAT(line(source), HasSubstr("terrain.micro_relief.rms_m: '-0.1'"));
}

}  // namespace
}  // namespace headland

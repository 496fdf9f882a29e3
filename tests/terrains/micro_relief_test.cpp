#include "terrains/micro_relief.h"

#include <gmock/gmock.h>

#include <cmath>

#include "refusal.h"
#include "terrains/seeded_noise.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

using testing::HasSubstr;

Heightfield level(int nodes, double cell_m) {
  Heightfield terrain{nodes, nodes, cell_m, Eigen::Vector2d::Zero(), {}};
  terrain.height_m.assign(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes), 0.0);
  return terrain;
}

// Mean product of heights `lag` nodes apart, in x and in y.
Eigen::Vector2d covariance_m2(const Heightfield& terrain, int lag) {
  Eigen::Vector2d sums = Eigen::Vector2d::Zero();
  for (int j = 0; j < terrain.rows - lag; ++j) {
    for (int i = 0; i < terrain.columns - lag; ++i) {
      sums += terrain.at(i, j) * Eigen::Vector2d(terrain.at(i + lag, j), terrain.at(i, j + lag));
    }
  }
  return sums / ((terrain.rows - lag) * (terrain.columns - lag));
}

// 400 x 400 nodes of 4 nodes correlation are about 400^2 / (pi 4^2 / 2) = 6400 independent heights;
// a variance from them spreads by sqrt(2 / 6400) = 1.8 %. Three times that.
constexpr double kSpread = 0.054;
constexpr double kRms_m = 0.03;

TEST(MicroRelief, HasTheStatedRmsAndCorrelation) {
  for (std::uint64_t seed : {1U, 7U}) {
    Heightfield terrain = level(400, 0.25);
    add_micro_relief({.rms_m = kRms_m, .correlation_m = 1.0}, seed, terrain);
    const double variance_m2 = covariance_m2(terrain, 0).x();
    EXPECT_NEAR(variance_m2 / (kRms_m * kRms_m), 1.0, kSpread);
    for (int lag : {1, 2, 4, 8}) {
      const double r = lag * terrain.cell_m;  // over a correlation length of 1 m
      const Eigen::Vector2d correlation = covariance_m2(terrain, lag) / (kRms_m * kRms_m);
      EXPECT_NEAR(correlation.x(), std::exp(-r * r), kSpread) << "lag " << r << " m";
      EXPECT_NEAR(correlation.y(), std::exp(-r * r), kSpread) << "lag " << r << " m";
    }
  }
}

TEST(MicroRelief, ShortestCorrelationTheGridCarriesIsStillRight) {
  Heightfield terrain = level(400, 0.5);
  add_micro_relief({.rms_m = kRms_m, .correlation_m = 1.0}, 3, terrain);
  const Eigen::Vector2d correlation = covariance_m2(terrain, 1) / (kRms_m * kRms_m);
  EXPECT_NEAR(correlation.x(), std::exp(-0.25), kSpread);
}

TEST(MicroRelief, SameSeedSameHeightsAnotherSeedOthers) {
  Heightfield first = level(50, 0.5);
  Heightfield same = level(50, 0.5);
  Heightfield other = level(50, 0.5);
  add_micro_relief({.rms_m = kRms_m, .correlation_m = 2.0}, 5, first);
  add_micro_relief({.rms_m = kRms_m, .correlation_m = 2.0}, 5, same);
  add_micro_relief({.rms_m = kRms_m, .correlation_m = 2.0}, 6, other);
  EXPECT_EQ(first.height_m, same.height_m);
  EXPECT_NE(first.height_m, other.height_m);
}

TEST(MicroRelief, NoneLeavesTheTerrainAlone) {
  Heightfield terrain = level(10, 1.0);
  add_micro_relief({}, 1, terrain);
  EXPECT_EQ(terrain.height_m, level(10, 1.0).height_m);
}

TEST(MicroRelief, CellsFollowTheCorrelationUnlessGivenTooCoarse) {
  Field field;
  field.boundary = {{0.0, 0.0}, {20.0, 0.0}, {20.0, 20.0}};
  TerrainSource source;
  source.micro_relief = {.rms_m = 0.02, .correlation_m = 0.8};
  EXPECT_DOUBLE_EQ(read_terrain(source, field, "a.yaml").cell_m, 0.4);
  source.cell_m = 0.5;
  EXPECT_EQ(refusal([&] { read_terrain(source, field, "a.yaml"); }),
            "a.yaml: terrain.cell_m: '0.5': at most 0.4 m, half of micro_relief.correlation_m");
}

TEST(SeededNoise, UniformsFillTheUnitInterval) {
  constexpr int kDraws = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const double u = seeded_uniform(42, static_cast<std::uint64_t>(draw));
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Standard deviations of the means: 0.29 / sqrt(1e5) and 0.30 / sqrt(1e5); five times that.
  EXPECT_NEAR(sum / kDraws, 0.5, 5e-3);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 5e-3);
}

TEST(SeededNoise, NormalsHaveNormalMoments) {
  const std::vector<double> normals = seeded_normals(9, 100001);
  ASSERT_EQ(normals.size(), 100001U);
  double mean = 0.0, variance = 0.0, kurtosis = 0.0;
  for (double z : normals) {
    mean += z / 1e5;
    variance += z * z / 1e5;
    kurtosis += z * z * z * z / 1e5;
  }
  // Standard errors at 1e5 draws: 0.0032, 0.0045, 0.031; four times that.
  EXPECT_NEAR(mean, 0.0, 0.013);
  EXPECT_NEAR(variance, 1.0, 0.018);
  EXPECT_NEAR(kurtosis, 3.0, 0.13);
}

}  // namespace
}  // namespace headland

#include "terrains/soil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace headland {
namespace {

const Soil& soil(std::string_view name) { return *std::ranges::find(soils(), name, &Soil::name); }

// The table is printed to three digits.
constexpr double kRounded = 6e-4;
constexpr double kRoundedStiffness = 0.06;

// ASABE D497 for the wheel that soil.cpp states: b/d 1/6, deflection 0.2, 30 kPa.
void expect_brixius(const Soil& listed, double cone_index_kpa) {
  const double mobility = cone_index_kpa / 30.0 * (1.0 + 5.0 * 0.2) / (1.0 + 3.0 / 6.0);
  const double full_grip = 0.88 * (1.0 - std::exp(-0.1 * mobility));
  double peak = 0.0;
  for (double slip = 0.0; slip <= 1.0; slip += 1e-4) {
    peak = std::max(
        peak, full_grip * (1.0 - std::exp(-7.5 * slip)) + 0.04 - 0.5 * slip / std::sqrt(mobility));
  }
  EXPECT_NEAR(listed.friction, peak, kRounded) << listed.name;
  EXPECT_NEAR(listed.rolling_resistance, 1.0 / mobility + 0.04, kRounded) << listed.name;
  EXPECT_NEAR(listed.slip_stiffness, 7.5 * full_grip / peak, kRoundedStiffness) << listed.name;
}

TEST(Soils, FieldSoilsAreBrixius) {
  expect_brixius(soil("firm"), 1200.0);
  expect_brixius(soil("tilled"), 900.0);
  expect_brixius(soil("soft"), 450.0);
}

TEST(Soils, SofterPullsLessAndRollsHarder) {
  for (std::size_t i = 1; i < soils().size(); ++i) {
    EXPECT_LT(soils()[i].friction, soils()[i - 1].friction);
    EXPECT_GT(soils()[i].rolling_resistance, soils()[i - 1].rolling_resistance);
  }
}

TEST(Soils, HaveNamesOfTheirOwnAndSources) {
  std::set<std::string_view> names;
  for (const Soil& listed : soils()) {
    EXPECT_TRUE(names.insert(listed.name).second);
    EXPECT_FALSE(listed.source.empty());
    EXPECT_GT(listed.friction, listed.rolling_resistance) << "a tractor could not move itself";
  }
}

}  // namespace
}  // namespace headland

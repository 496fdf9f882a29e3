#include "terrains/traction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace headland {
namespace {

constexpr double kRoundingOfLaw = 1e-12;  // closed forms written in another order
constexpr TyreSize kDriveTyre{0.5, 1.5, 0.3};

Soil brixius(double cone_index_kpa) { return {"soil", BrixiusSoil{cone_index_kpa}, 0.09, ""}; }

// Bn by hand for kDriveTyre on firm soil: 1200 kPa, 15 kN, deflection a fifth of the section
// height: 1200 * 0.5 * 1.5 / 15 * (1 + 1) / (1 + 1) = 60.
const Traction kFirm = traction_on(brixius(1200.0), kDriveTyre, 15e3, 0.06);

TEST(Traction, IsBrixiusAtAHandComputedMobilityNumber) {
  const double mobility = 60.0;
  for (const double slip : {0.0, 0.05, 0.2, 1.0}) {
    const double gross =
        0.88 * (1.0 - std::exp(-0.1 * mobility)) * (1.0 - std::exp(-7.5 * slip)) + 0.04;
    const double resistance = 1.0 / mobility + 0.04 + 0.5 * slip / std::sqrt(mobility);
    EXPECT_NEAR(net_pull(kFirm, slip), gross - resistance, kRoundingOfLaw) << slip;
    EXPECT_NEAR(gross_pull(kFirm, kFirm.slip_stiffness * slip) + kFirm.tyre_resistance, gross,
                kRoundingOfLaw);
  }
  EXPECT_NEAR(rolling_resistance(kFirm), 1.0 / mobility + 0.04, kRoundingOfLaw);
}

// mu_g W r w = mu_n W v + mu_g W (r w - v) + rho W v: what the axle puts in is what the drawbar
// takes, what slips away and what rolling costs. With the tyre's 0.04 as a torque, slip loses it
// too.
TEST(Traction, DrawbarSlipAndRollingAddUpToAxlePower) {
  const double rim_mps = 2.0;
  for (const double slip : {0.02, 0.1, 0.3, 0.8}) {
    const double hub_mps = rim_mps * (1.0 - slip);
    const double pull = gross_pull(kFirm, kFirm.slip_stiffness * slip);
    const double soil = kFirm.soil_resistance + kFirm.soil_resistance_per_slip * slip;
    const double axle = (pull + kFirm.tyre_resistance) * rim_mps;
    const double drawbar = net_pull(kFirm, slip) * hub_mps;
    const double slipping = pull * (rim_mps - hub_mps);
    const double rolling = kFirm.tyre_resistance * rim_mps + soil * hub_mps;
    EXPECT_NEAR(axle, drawbar + slipping + rolling, kRoundingOfLaw) << slip;
  }
}

TEST(Traction, SofterSoilAndHeavierWheelsPullLessAndRollHarder) {
  double pull = 1.0;
  double resistance = 0.0;
  for (const double cone_index_kpa : {1800.0, 1200.0, 900.0, 450.0, 200.0}) {
    const Traction traction = traction_on(brixius(cone_index_kpa), kDriveTyre, 15e3, 0.06);
    EXPECT_LT(best_pull(traction).net_pull, pull);
    EXPECT_GT(rolling_resistance(traction), resistance);
    pull = best_pull(traction).net_pull;
    resistance = rolling_resistance(traction);
  }
  const Traction heavy = traction_on(brixius(200.0), kDriveTyre, 30e3, 0.06);
  EXPECT_LT(best_pull(heavy).net_pull, pull);
}

TEST(Traction, BestPullIsTheLargestOfAFineScan) {
  constexpr double kScanStep = 1e-4;
  constexpr double kFlatTop = 1e-7;  // curvature of the law times half the scan's step, squared
  for (const Soil& soil : soils()) {
    const Traction traction = traction_on(soil, kDriveTyre, 15e3, 0.06);
    double best = 0.0;
    for (double slip = 0.0; slip <= 1.0; slip += kScanStep) {
      best = std::max(best, net_pull(traction, slip));
    }
    EXPECT_NEAR(best_pull(traction).net_pull, best, kFlatTop) << soil.name;
  }
}

TEST(Traction, PavementIsPacejkasMagicFormula) {
  const Soil& dry = *find_soil("concrete");
  const Traction traction = traction_on(dry, kDriveTyre, 15e3, 0.02);
  for (const double slip : {0.01, 0.05, 0.1, 0.5, 1.0}) {
    const double bs = 10.0 * slip;
    const double expected = std::sin(1.9 * std::atan(bs - 0.97 * (bs - std::atan(bs))));
    EXPECT_NEAR(gross_pull(traction, traction.slip_stiffness * slip), expected, kRoundingOfLaw);
  }
  EXPECT_LT(gross_pull(traction, traction.slip_stiffness), best_pull(traction).net_pull)
      << "a sliding wheel grips less";
}

TEST(Traction, ConstantGroundIsTheSameForEveryWheel) {
  const Soil paper{"paper", ConstantGround{0.6, 0.08, 10.0}, 0.09, ""};
  const Traction light = traction_on(paper, kDriveTyre, 1e3, 0.01);
  const Traction heavy = traction_on(paper, {0.2, 0.6, 0.1}, 20e3, 0.05);
  EXPECT_EQ(net_pull(light, 0.1), net_pull(heavy, 0.1));
  EXPECT_EQ(rolling_resistance(light), 0.08);
  EXPECT_NEAR(best_pull(light).net_pull, 0.6, 1e-4) << "exp(-10) short of mu at full slip";
}

}  // namespace
}  // namespace headland

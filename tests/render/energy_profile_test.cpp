#include "render/energy_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace headland {
namespace {

// Rounding of sums of some hundred terms.
constexpr double kRounding = 1e-9;

// At 10 Hz, `power_w` as a function of travel, constant speed.
template <typename Power>
std::vector<RunSample> driven(double speed_mps, double length_m, Power power_w) {
  std::vector<RunSample> samples;
  for (int i = 0; 0.1 * i * speed_mps <= length_m + kRounding; ++i) {
    RunSample sample;
    sample.time_s = 0.1 * i;
    sample.travel_m = sample.time_s * speed_mps;
    sample.battery_power_w = power_w(sample.travel_m);
    samples.push_back(sample);
  }
  return samples;
}

TEST(EnergyProfile, OfConstantPowerIsPowerOverSpeed) {
  const auto samples = driven(2.0, 50.0, [](double) { return 7200.0; });
  for (const double value : energy_per_metre_wh(samples, 4.0)) EXPECT_NEAR(value, 1.0, kRounding);
}

TEST(EnergyProfile, OfPowerLinearInTravelIsItsMiddleAndRegenerationIsNegative) {
  const auto samples = driven(1.0, 40.0, [](double travel_m) { return 360.0 * (travel_m - 20.0); });
  const auto profile = energy_per_metre_wh(samples, 4.0);
  // Away from the ends the window is whole and the mean of a line is its middle.
  EXPECT_NEAR(profile[100], 0.1 * (10.0 - 20.0), kRounding);
  EXPECT_NEAR(profile[300], 0.1 * (30.0 - 20.0), kRounding);
  // At the ends there is half a window.
  EXPECT_NEAR(profile.front(), 0.1 * (1.0 - 20.0), kRounding);
}

TEST(EnergyProfile, SpreadsStandingStillOverTheWindow) {
  auto samples = driven(1.0, 20.0, [](double) { return 0.0; });
  // A minute at 600 W on the spot at 10 m is 10 Wh, over 4 m.
  std::vector<RunSample> rest(2, samples[100]);
  rest[0].battery_power_w = rest[1].battery_power_w = 600.0;
  rest[1].time_s += 60.0;
  for (std::size_t i = 101; i < samples.size(); ++i) samples[i].time_s += 60.0;
  samples.insert(samples.begin() + 101, rest.begin(), rest.end());
  const auto profile = energy_per_metre_wh(samples, 4.0);
  EXPECT_NEAR(profile[95], 10.0 / 4.0, 0.01);  // the two ramps of 0.1 s to 600 W add 0.3 %
  EXPECT_NEAR(profile[50], 0.0, kRounding);
}

TEST(EnergyProfile, OfNothingDrivenIsEmpty) {
  EXPECT_TRUE(energy_per_metre_wh({}, 4.0).empty());
  EXPECT_TRUE(energy_per_metre_wh(std::vector<RunSample>(1), 4.0).empty());
  EXPECT_TRUE(energy_per_metre_wh(std::vector<RunSample>(5), 4.0).empty());
}

TEST(EnergyFigures, LeaveOutWhatIsNotFinite) {
  const auto samples = driven(1.0, 40.0, [](double) { return 3600.0; });
  std::vector<double> profile(samples.size(), 1.0);
  profile[7] = std::numeric_limits<double>::quiet_NaN();
  profile[9] = std::numeric_limits<double>::infinity();
  const EnergyFigures figures = energy_figures(samples, profile);
  EXPECT_EQ(figures.min_wh_per_m, 1.0);
  EXPECT_EQ(figures.median_wh_per_m, 1.0);
  EXPECT_EQ(figures.max_wh_per_m, 1.0);
  std::fill(profile.begin(), profile.end(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(energy_figures(samples, profile).median_wh_per_m, 0.0);
}

TEST(EnergyFigures, WeighByTravelNotByTime) {
  // 30 m at 1 m/s with 1 Wh/m, then 10 m at 0.1 m/s with 2 Wh/m: most samples are slow ones.
  auto samples = driven(1.0, 30.0, [](double) { return 3600.0; });
  for (int i = 1; i <= 1000; ++i) {
    RunSample slow;
    slow.time_s = 30.0 + 0.1 * i;
    slow.travel_m = 30.0 + 0.01 * i;
    slow.battery_power_w = 720.0;
    samples.push_back(slow);
  }
  const auto profile = energy_per_metre_wh(samples, 2.0);
  const EnergyFigures figures = energy_figures(samples, profile);
  EXPECT_NEAR(figures.median_wh_per_m, 1.0, kRounding);
  EXPECT_NEAR(figures.max_wh_per_m, 2.0, 0.1);  // the change of power is spread over one sample
  EXPECT_EQ(figures.scale_low_wh_per_m, 0.0);
  EXPECT_GE(figures.scale_high_wh_per_m, 1.9);
}

}  // namespace
}  // namespace headland

#include "sim/positioning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace headland {
namespace {

constexpr double kReceiver_hz = 100.0;

TEST(Positioning, IdealByDefault) {
  const Eigen::Vector2d p_W(3.0, -4.0);
  Receiver receiver = make_receiver({}, kReceiver_hz, Eigen::Vector2d::Zero());
  EXPECT_EQ(receive(receiver, p_W), p_W);
}

TEST(Positioning, ArrivesLateByItsLatency) {
  PositioningOptions options;
  options.latency_s = 0.05;
  Receiver receiver = make_receiver(options, kReceiver_hz, Eigen::Vector2d::Zero());
  for (int step = 0; step < 20; ++step) {
    const Eigen::Vector2d late = receive(receiver, {step, 0.0});
    EXPECT_EQ(late.x(), std::max(0, step - 5));
  }
}

// Standard deviation and correlation at one correlation time, from 20 000 correlation times: the
// error of both estimates is about 1 / sqrt(20 000), here allowed four times.
TEST(Positioning, NoiseIsGaussMarkov) {
  PositioningOptions options;
  options.noise_m = 0.02;
  options.noise_time_s = 0.5;
  options.seed = 7;
  Receiver receiver = make_receiver(options, kReceiver_hz, Eigen::Vector2d::Zero());
  constexpr int kLag = 50;  // noise_time_s
  std::vector<double> x;
  double across = 0.0;
  for (int step = 0; step < 1000000; ++step) {
    const Eigen::Vector2d error = receive(receiver, Eigen::Vector2d::Zero());
    x.push_back(error.x());
    across += error.x() * error.y();
  }
  double variance = 0.0;
  double lagged = 0.0;
  for (std::size_t i = kLag; i < x.size(); ++i) {
    variance += x[i] * x[i];
    lagged += x[i] * x[i - kLag];
  }
  const double count = static_cast<double>(x.size());
  constexpr double kEstimate = 0.03;
  EXPECT_NEAR(std::sqrt(variance / count), 0.02, kEstimate * 0.02);
  EXPECT_NEAR(lagged / variance, std::exp(-1.0), kEstimate);
  EXPECT_NEAR(across / variance, 0.0, kEstimate);  // the coordinates are independent
}

TEST(Positioning, SeedDecidesTheNoise) {
  PositioningOptions options;
  options.noise_m = 0.02;
  const auto tenth = [&](std::uint64_t seed) {
    options.seed = seed;
    Receiver receiver = make_receiver(options, kReceiver_hz, Eigen::Vector2d::Zero());
    Eigen::Vector2d last;
    for (int i = 0; i < 10; ++i) last = receive(receiver, Eigen::Vector2d::Zero());
    return last;
  };
  EXPECT_EQ(tenth(1), tenth(1));
  EXPECT_NE(tenth(1), tenth(2));
}

}  // namespace
}  // namespace headland

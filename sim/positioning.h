// What the receiver makes of the true position: correlated noise and latency.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/delay_line.h"

namespace headland {

// Ideal by default. Yaw, attitude and velocity come from inertial sensors and are taken as true.
struct PositioningOptions {
  double noise_m = 0.0;        // standard deviation of each horizontal coordinate
  double noise_time_s = 30.0;  // its correlation time
  double latency_s = 0.0;      // age of a position when the driver gets it
  std::uint64_t seed = 1;
};

struct Receiver {
  PositioningOptions options;
  double memory = 0.0;  // correlation of the noise from step to step
  std::uint64_t draws = 0;
  Eigen::Vector2d error_m = Eigen::Vector2d::Zero();
  DelayLine<Eigen::Vector2d> on_its_way;
};

// A receiver that has stood at `p_W`.
Receiver make_receiver(const PositioningOptions& options, double rate_hz,
                       const Eigen::Vector2d& p_W);

// The position that arrives in a step when the true one is `p_W`. The noise is a first-order
// Gauss-Markov process, one for each coordinate: correlation exp(-t / noise_time_s).
Eigen::Vector2d receive(Receiver& receiver, const Eigen::Vector2d& p_W);

}  // namespace headland

#include "sim/positioning.h"

#include <cmath>
#include <numbers>

#include "terrains/seeded_noise.h"

namespace headland {
namespace {

// Two independent numbers of a standard normal distribution (Box-Muller).
Eigen::Vector2d draw_normals(Receiver& receiver) {
  const double radius_draw = seeded_uniform(receiver.options.seed, receiver.draws++);
  const double angle_draw = seeded_uniform(receiver.options.seed, receiver.draws++);
  const double radius = std::sqrt(-2.0 * std::log1p(-radius_draw));
  const double angle_rad = 2.0 * std::numbers::pi * angle_draw;
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

}  // namespace

Receiver make_receiver(const PositioningOptions& options, double rate_hz,
                       const Eigen::Vector2d& p_W) {
  Receiver receiver;
  receiver.options = options;
  if (options.noise_m > 0.0) {
    receiver.memory =
        options.noise_time_s > 0.0 ? std::exp(-1.0 / (rate_hz * options.noise_time_s)) : 0.0;
    receiver.error_m = options.noise_m * draw_normals(receiver);
  }
  receiver.on_its_way =
      make_delay_line<Eigen::Vector2d>(options.latency_s, rate_hz, p_W + receiver.error_m);
  return receiver;
}

Eigen::Vector2d receive(Receiver& receiver, const Eigen::Vector2d& p_W) {
  if (receiver.options.noise_m > 0.0) {
    const double fresh =
        receiver.options.noise_m * std::sqrt(1.0 - receiver.memory * receiver.memory);
    receiver.error_m = receiver.memory * receiver.error_m + fresh * draw_normals(receiver);
  }
  return receiver.on_its_way.pass(p_W + receiver.error_m);
}

}  // namespace headland

#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace headland {
namespace {

std::uint8_t mix_channel(std::uint8_t from, std::uint8_t to, double t) {
  return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
}

}  // namespace

Rgba mix(Rgba from, Rgba to, double t) {
  const double share = std::clamp(t, 0.0, 1.0);
  return {mix_channel(from.r, to.r, share), mix_channel(from.g, to.g, share),
          mix_channel(from.b, to.b, share), mix_channel(from.a, to.a, share)};
}

Rgba viridis(double t) {
  constexpr std::array<Rgba, 9> kNodes = {{{68, 1, 84},
                                           {71, 44, 122},
                                           {59, 81, 139},
                                           {44, 113, 142},
                                           {33, 144, 141},
                                           {39, 173, 129},
                                           {92, 200, 99},
                                           {170, 220, 50},
                                           {253, 231, 37}}};
  const double u = std::clamp(t, 0.0, 1.0) * static_cast<double>(kNodes.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(u), kNodes.size() - 2);
  return mix(kNodes[i], kNodes[i + 1], u - static_cast<double>(i));
}

Rgba energy_colour(double share) {
  constexpr Rgba kPaleMagenta{250, 190, 222};
  constexpr Rgba kMagenta{214, 20, 130};
  return share < 0.0 ? mix(kPaleMagenta, kMagenta, -share) : viridis(share);
}

}  // namespace headland

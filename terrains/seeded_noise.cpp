#include "terrains/seeded_noise.h"

#include <cmath>
#include <numbers>
#include <random>

namespace headland {
namespace {

// The 53 high bits of a word as a number in [0, 1).
double unit_interval(std::uint64_t word) { return static_cast<double>(word >> 11) * 0x1.0p-53; }

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace

double seeded_uniform(std::uint64_t seed, std::uint64_t draw) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  return unit_interval(mixed(mixed(seed + kGolden) + (draw + 1) * kGolden));
}

std::vector<double> seeded_normals(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 engine(seed);
  std::vector<double> normals;
  normals.reserve(count + 1);
  while (normals.size() < count) {
    // 1 - u is in (0, 1], where the logarithm is finite.
    const double radius = std::sqrt(-2.0 * std::log(1.0 - unit_interval(engine())));
    const double angle_rad = 2.0 * std::numbers::pi * unit_interval(engine());
    normals.push_back(radius * std::cos(angle_rad));
    normals.push_back(radius * std::sin(angle_rad));
  }
  normals.resize(count);
  return normals;
}

}  // namespace headland

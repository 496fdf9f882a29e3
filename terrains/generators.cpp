#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "terrains/seeded_noise.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

constexpr double kPi = std::numbers::pi;

double flat(double, double, const Parameters&, std::uint64_t) { return 0.0; }

// Distance [m] from the middle towards a direction counter-clockwise from east.
double along_m(double x_m, double y_m, double direction_deg) {
  const double direction_rad = direction_deg * kPi / 180.0;
  return x_m * std::cos(direction_rad) + y_m * std::sin(direction_rad);
}

double ramp(double x_m, double y_m, const Parameters& parameters, std::uint64_t) {
  return 0.01 * number(parameters, "slope_percent") *
         along_m(x_m, y_m, number(parameters, "direction_deg"));
}

// Plane waves of random direction and phase, their lengths spread over about an octave. Each has
// amplitude / sqrt(count), so the sum's rms is that of one sine of the whole amplitude.
constexpr int kWaves = 10;
constexpr double kShortestWave = 0.75;  // of wavelength_m
constexpr double kLongestWave = 1.5;

double rolling(double x_m, double y_m, const Parameters& parameters, std::uint64_t seed) {
  const double wavelength_m = number(parameters, "wavelength_m");
  double sum = 0.0;
  for (int wave = 0; wave < kWaves; ++wave) {
    const std::uint64_t draw = 2 * static_cast<std::uint64_t>(wave);
    // Directions are spread evenly, with a random start in each sector, so that no seed makes
    // corrugated iron.
    const double direction_rad = kPi * (wave + seeded_uniform(seed, draw)) / kWaves;
    const double phase_rad = 2.0 * kPi * seeded_uniform(seed, draw + 1);
    // 7 has no factor in common with 10: neighbouring directions get unlike lengths.
    const double spread = static_cast<double>((wave * 7) % kWaves) / (kWaves - 1);
    const double length_m =
        wavelength_m * (kShortestWave + spread * (kLongestWave - kShortestWave));
    const double s_m = x_m * std::cos(direction_rad) + y_m * std::sin(direction_rad);
    sum += std::cos(2.0 * kPi * s_m / length_m + phase_rad);
  }
  return number(parameters, "amplitude_m") * sum / std::sqrt(static_cast<double>(kWaves));
}

double bowl(double x_m, double y_m, const Parameters& parameters, std::uint64_t) {
  const double r = std::min(1.0, std::hypot(x_m, y_m) / number(parameters, "radius_m"));
  return 0.5 * number(parameters, "depth_m") * (1.0 - std::cos(kPi * r));
}

double terraces(double x_m, double y_m, const Parameters& parameters, std::uint64_t) {
  const double tread_m = number(parameters, "tread_m");
  const double riser_m = number(parameters, "riser_m");
  const double spacing_m = tread_m + riser_m;
  // Half a tread back, so that the middle of the field lies in the middle of a tread.
  const double s_m = along_m(x_m, y_m, number(parameters, "direction_deg")) + 0.5 * tread_m;
  const double step = std::floor(s_m / spacing_m);
  const double up_riser = std::max(0.0, (s_m - step * spacing_m - tread_m) / riser_m);
  return number(parameters, "step_m") * (step + up_riser);
}

const std::array<ParameterSpec, 2> kRamp{{
    {"slope_percent", 10.0, 0.0, 60.0, {}, "rise over run"},
    {"direction_deg", 0.0, -360.0, 360.0, {}, "uphill, counter-clockwise from east"},
}};
const std::array<ParameterSpec, 2> kRolling{{
    {"amplitude_m", 1.5, 0.0, 50.0, {}, "of the one sine whose rms height the hills have"},
    {"wavelength_m", 120.0, 5.0, 5000.0, {}, "typical distance from crest to crest"},
}};
const std::array<ParameterSpec, 2> kBowl{{
    {"depth_m", 5.0, -100.0, 100.0, {}, "rim above the middle; negative makes a hill"},
    {"radius_m", 100.0, 1.0, 5000.0, {}, "from the middle to the level rim"},
}};
const std::array<ParameterSpec, 4> kTerraces{{
    {"step_m", 1.0, 0.0, 10.0, {}, "height of one terrace above the next"},
    {"tread_m", 25.0, 1.0, 1000.0, {}, "width of the level part"},
    {"riser_m", 5.0, 0.1, 100.0, {}, "width of the slope between two treads"},
    {"direction_deg", 0.0, -360.0, 360.0, {}, "uphill, counter-clockwise from east"},
}};

const std::array<GeneratorEntry, 5> kGenerators{{
    {"flat", "level ground", flat, {}},
    {"ramp", "one plane slope", ramp, kRamp},
    {"rolling", "smooth hills, another landscape for every seed", rolling, kRolling},
    {"bowl", "a round hollow or hill in the middle of the field", bowl, kBowl},
    {"terraces", "level treads joined by straight slopes", terraces, kTerraces},
}};

}  // namespace

std::span<const GeneratorEntry> generators() { return kGenerators; }

}  // namespace headland

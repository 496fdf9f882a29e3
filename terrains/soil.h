// Soils as data: what the tyres can pull on and what rolling costs. The laws are in traction.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace headland {

// Agricultural soil by its cone index: Brixius, as in ASABE D497.
struct BrixiusSoil {
  double cone_index_kpa = 1200.0;
};

// Pavement by Pacejka's magic formula, coefficients over the wheel load, and rolling resistance.
struct Pavement {
  double b = 10.0;
  double c = 1.9;
  double d = 1.0;
  double e = 0.97;
  double rolling_resistance = 0.0175;
};

// The same for every wheel: traction mu N (1 - exp(-slip_stiffness s)), rolling resistance Crr N.
struct ConstantGround {
  double friction = 0.6;             // mu, 0..2
  double rolling_resistance = 0.05;  // Crr, 0..1
  double slip_stiffness = 8.0;       // per unit of slip
};

// Classes by which ASABE D497 gives the draft of tools: clay, loam, sand.
enum class SoilTexture { kFine, kMedium, kCoarse };
inline constexpr std::size_t kSoilTextures = 3;

struct Soil {
  std::string name;
  std::variant<BrixiusSoil, Pavement, ConstantGround> law;
  double lateral_gamma_rad = 0.09;  // slip angle scale of the lateral force (Crolla)
  std::string source;               // of the numbers
  SoilTexture texture = SoilTexture::kMedium;
};

// Soils of the user's own numbers, named after them: "cone index 900 kPa", "mu 0.6, Crr 0.05".
Soil soil_of_cone_index(double cone_index_kpa);
Soil soil_of_constants(const ConstantGround& ground);

// What the program takes for a soil's number.
inline constexpr double kMinConeIndex_kpa = 10.0;     // below it is mud, not soil
inline constexpr double kMaxConeIndex_kpa = 20000.0;  // a cone penetrates no rock
inline constexpr double kMaxFriction = 2.0;
inline constexpr double kMaxRollingResistance = 1.0;
inline constexpr double kMinSlipStiffness = 0.1;
inline constexpr double kMaxSlipStiffness = 100.0;
inline constexpr double kMinLateralGamma_rad = 0.01;
inline constexpr double kMaxLateralGamma_rad = 1.0;

// "fine", "medium" or "coarse".
std::string_view texture_name(SoilTexture texture);

// Every soil the program knows, in the order `headland list soils` prints them: hardest first.
std::span<const Soil> soils();

// The known soil of that name, or null.
const Soil* find_soil(std::string_view name);

// Likewise, but throws InputError(source, place) with the nearest known name.
const Soil& soil_named(const std::string& name, const std::string& source,
                       const std::string& place);

// The law with its numbers in words: "Brixius, cone index 1200 kPa".
std::string law_text(const Soil& soil);

}  // namespace headland

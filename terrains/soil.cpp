#include "terrains/soil.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "terrains/input_error.h"

namespace headland {
namespace {

std::string text_of(const BrixiusSoil& soil) {
  return fmt::format("Brixius, cone index {:g} kPa", soil.cone_index_kpa);
}

std::string text_of(const Pavement& pavement) {
  return fmt::format("Pacejka, B {:g}, C {:g}, D {:g}, E {:g}, rolling resistance {:g}", pavement.b,
                     pavement.c, pavement.d, pavement.e, pavement.rolling_resistance);
}

std::string text_of(const ConstantGround& ground) {
  return fmt::format("constant, friction {:g}, rolling resistance {:g}, slip stiffness {:g}",
                     ground.friction, ground.rolling_resistance, ground.slip_stiffness);
}

}  // namespace

std::span<const Soil> soils() {
  static const std::vector<Soil> known{
      {"concrete", Pavement{10.0, 1.9, 1.0, 0.97, 0.0175}, 0.09,
       "dry pavement: Pacejka B C D E 10, 1.9, 1, 0.97 (MAVS); Crr 0.015-0.02 assumed"},
      {"concrete_wet", Pavement{12.0, 2.3, 0.82, 1.0, 0.0175}, 0.09,
       "wet pavement: Pacejka B C D E 12, 2.3, 0.82, 1 (MAVS); Crr 0.015-0.02 assumed"},
      {"hard", BrixiusSoil{1800.0}, 0.09, "ASABE D497 (Brixius), cone index 1800 kPa"},
      {"firm", BrixiusSoil{1200.0}, 0.09, "ASABE D497 (Brixius), cone index 1200 kPa"},
      {"tilled", BrixiusSoil{900.0}, 0.09, "ASABE D497 (Brixius), cone index 900 kPa"},
      {"soft", BrixiusSoil{450.0}, 0.09,
       "ASABE D497 (Brixius), soft or sandy soil, cone index 450 kPa"},
  };
  return known;
}

Soil soil_of_cone_index(double cone_index_kpa) {
  return {fmt::format("cone index {:g} kPa", cone_index_kpa), BrixiusSoil{cone_index_kpa}, 0.09,
          "given; ASABE D497 (Brixius)"};
}

Soil soil_of_constants(const ConstantGround& ground) {
  return {fmt::format("mu {:g}, Crr {:g}", ground.friction, ground.rolling_resistance), ground,
          0.09, "given"};
}

const Soil* find_soil(std::string_view name) {
  const auto known = soils();
  const auto found = std::ranges::find(known, name, &Soil::name);
  return found == known.end() ? nullptr : &*found;
}

const Soil& soil_named(const std::string& name, const std::string& source,
                       const std::string& place) {
  if (const Soil* known = find_soil(name)) return *known;
  std::vector<std::string> names;
  for (const Soil& soil : soils()) names.push_back(soil.name);
  throw InputError(source, place, name,
                   fmt::format("unknown soil; did you mean '{}'? (known: {})",
                               nearest_name(name, names), fmt::join(names, ", ")));
}

std::string_view texture_name(SoilTexture texture) {
  constexpr std::string_view kNames[kSoilTextures] = {"fine", "medium", "coarse"};
  return kNames[static_cast<std::size_t>(texture)];
}

std::string law_text(const Soil& soil) {
  return std::visit([](const auto& law) { return text_of(law); }, soil.law);
}

}  // namespace headland

#include "evaluate/scenario_soil.h"

#include <fmt/format.h>

#include <algorithm>

#include "evaluate/scenario_keys.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::string_view kLaws[] = {"name", "cone_index_kpa", "friction"};
constexpr NumberRange kGammaRange{kMinLateralGamma_rad, kMaxLateralGamma_rad};

bool has(const YamlSection& section, std::string_view key) {
  const YAML::Node node = section.node;
  return node[std::string(key)].IsDefined();
}

// Refuses `keys` in a section where they would mean nothing.
void refuse_keys(const YamlSection& section, std::initializer_list<std::string_view> keys,
                 const std::string& why) {
  for (const std::string_view key : keys) {
    if (has(section, key)) throw InputError(section.source, place_of(section, key), "", why);
  }
}

Soil read_law(const YamlSection& section) {
  if (const auto name = read_word(section, "name")) {
    return soil_named(*name, section.source, place_of(section, "name"));
  }
  if (const auto cone_index_kpa =
          read_number(section, "cone_index_kpa", {kMinConeIndex_kpa, kMaxConeIndex_kpa})) {
    return soil_of_cone_index(*cone_index_kpa);
  }
  ConstantGround ground;
  ground.friction = read_number(section, "friction", {0.0, kMaxFriction}).value();
  const auto rolling = read_number(section, "rolling_resistance", {0.0, kMaxRollingResistance});
  if (!rolling) {
    throw InputError(section.source, place_of(section, "rolling_resistance"), "",
                     "the key is missing: constant ground has friction and rolling_resistance");
  }
  ground.rolling_resistance = *rolling;
  ground.slip_stiffness =
      read_number(section, "slip_stiffness", {kMinSlipStiffness, kMaxSlipStiffness})
          .value_or(ground.slip_stiffness);
  return soil_of_constants(ground);
}

SoilTexture read_texture(const YamlSection& section, SoilTexture otherwise) {
  const auto word = read_word(section, "texture");
  if (!word) return otherwise;
  for (std::size_t i = 0; i < kSoilTextures; ++i) {
    const auto texture = static_cast<SoilTexture>(i);
    if (*word == texture_name(texture)) return texture;
  }
  throw InputError(section.source, place_of(section, "texture"), *word,
                   "must be fine, medium or coarse");
}

// One soil by name, cone index or constants.
Soil read_one_soil(const YamlSection& section) {
  if (std::ranges::count_if(kLaws, [&](std::string_view key) { return has(section, key); }) != 1) {
    std::string place = place_of(section, "");
    place.pop_back();  // the dot before the key
    throw InputError(section.source, place, "",
                     "exactly one of name, cone_index_kpa and friction is needed");
  }
  if (!has(section, "friction")) {
    refuse_keys(section, {"rolling_resistance", "slip_stiffness"},
                "only with friction: the soil's law gives it");
  }
  Soil soil = read_law(section);
  soil.lateral_gamma_rad =
      read_number(section, "lateral_gamma_rad", kGammaRange).value_or(soil.lateral_gamma_rad);
  soil.texture = read_texture(section, soil.texture);
  return soil;
}

Soil read_name_or_soil(const YamlSection& section, std::string_view key) {
  const YAML::Node node = section.node;
  if (!node[std::string(key)].IsMap()) {
    const std::string name = read_word(section, key, "a soil's name or a mapping").value();
    return soil_named(name, section.source, place_of(section, key));
  }
  const YamlSection own = read_section(section, key).value();
  refuse_unknown_keys(own, keys_in_section("soil.default"));
  return read_one_soil(own);
}

void emit_number(YAML::Emitter& out, const char* key, double value) {
  out << YAML::Key << key << YAML::Value << fmt::format("{}", value);
}

void emit_law(YAML::Emitter& out, const Soil& soil) {
  const Soil* known = find_soil(soil.name);
  if (known != nullptr) {
    out << YAML::Key << "name" << YAML::Value << soil.name;
  } else if (const auto* brixius = std::get_if<BrixiusSoil>(&soil.law)) {
    emit_number(out, "cone_index_kpa", brixius->cone_index_kpa);
  } else if (const auto* ground = std::get_if<ConstantGround>(&soil.law)) {
    emit_number(out, "friction", ground->friction);
    emit_number(out, "rolling_resistance", ground->rolling_resistance);
    emit_number(out, "slip_stiffness", ground->slip_stiffness);
  }
  emit_number(out, "lateral_gamma_rad", soil.lateral_gamma_rad);
  out << YAML::Key << "texture" << YAML::Value << std::string(texture_name(soil.texture));
}

void emit_one_soil(YAML::Emitter& out, const Soil& soil) {
  const Soil* known = find_soil(soil.name);
  if (known != nullptr && known->lateral_gamma_rad == soil.lateral_gamma_rad &&
      known->texture == soil.texture) {
    out << soil.name;
    return;
  }
  out << YAML::Flow << YAML::BeginMap;
  emit_law(out, soil);
  out << YAML::EndMap;
}

}  // namespace

SoilSource read_soil_source(const YamlSection& top, const std::filesystem::path& folder) {
  SoilSource source;
  if (!has(top, "soil")) return source;
  const YAML::Node node = top.node;
  if (!node["soil"].IsMap()) {
    source.soil = read_name_or_soil(top, "soil");
    return source;
  }
  const YamlSection section = read_section(top, "soil").value();
  refuse_unknown_keys(section, keys_in_section("soil"));
  if (!has(section, "file")) {
    refuse_keys(section, {"layer", "crs", "cell_m", "default"}, "only with soil.file");
    source.soil = read_one_soil(section);
    return source;
  }
  refuse_keys(section,
              {"name", "cone_index_kpa", "friction", "rolling_resistance", "slip_stiffness",
               "lateral_gamma_rad", "texture"},
              "not with soil.file; what holds where the file says nothing is soil.default");
  source.file = read_file_name(section, "file", folder);
  source.layer = read_word(section, "layer").value_or("");
  source.crs = read_crs(section);
  source.cell_m =
      read_number(section, "cell_m", {kMinSoilCell_m, kMaxSoilCell_m, true}).value_or(0.0);
  if (has(section, "default")) source.soil = read_name_or_soil(section, "default");
  return source;
}

void emit_soil(YAML::Emitter& out, const SoilSource& source) {
  if (source.file.empty()) {
    emit_one_soil(out, source.soil);
    return;
  }
  out << YAML::BeginMap;
  out << YAML::Key << "file" << YAML::Value << source.file.string();
  if (!source.layer.empty()) out << YAML::Key << "layer" << YAML::Value << source.layer;
  if (!source.crs.empty()) out << YAML::Key << "crs" << YAML::Value << source.crs;
  emit_number(out, "cell_m", source.cell_m);
  out << YAML::Key << "default" << YAML::Value;
  emit_one_soil(out, source.soil);
  out << YAML::EndMap;
}

}  // namespace headland

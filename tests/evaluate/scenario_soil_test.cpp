#include "evaluate/scenario_soil.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "evaluate/scenario.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

class ScenarioSoil : public ScratchFolder {
 protected:
  Scenario with(const std::string& soil) const {
    return read_scenario(written("s.yaml",
                                 "field: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\n"
                                 "vehicle: transplanter\n"
                                 "soil: " +
                                     soil + "\n"));
  }
  SoilSource soil(const std::string& text) const { return with(text).soil; }
  std::string refused(const std::string& text) const {
    const std::string message = refusal([&] { with(text); });
    const std::string file = path("s.yaml").string() + ": ";
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message.starts_with(file) ? message.substr(file.size()) : message;
  }
};

TEST_F(ScenarioSoil, IsANameOrNumbers) {
  EXPECT_EQ(soil("tilled").soil.name, "tilled");
  EXPECT_EQ(soil("{name: soft, lateral_gamma_rad: 0.12}").soil.lateral_gamma_rad, 0.12);
  const Soil penetrated = soil("{cone_index_kpa: 750}").soil;
  EXPECT_EQ(std::get<BrixiusSoil>(penetrated.law).cone_index_kpa, 750.0);
  EXPECT_EQ(penetrated.name, "cone index 750 kPa");
  const Soil constant = soil("{friction: 0.25, rolling_resistance: 0.08}").soil;
  EXPECT_EQ(std::get<ConstantGround>(constant.law).friction, 0.25);
  EXPECT_EQ(std::get<ConstantGround>(constant.law).rolling_resistance, 0.08);
  EXPECT_EQ(std::get<ConstantGround>(constant.law).slip_stiffness, ConstantGround{}.slip_stiffness);
}

TEST_F(ScenarioSoil, ReadsTheTexture) {
  EXPECT_EQ(soil("tilled").soil.texture, SoilTexture::kMedium);
  EXPECT_EQ(soil("{name: tilled, texture: fine}").soil.texture, SoilTexture::kFine);
  EXPECT_EQ(soil("{cone_index_kpa: 750, texture: coarse}").soil.texture, SoilTexture::kCoarse);
}

TEST_F(ScenarioSoil, ReadsBackWhatItWrote) {
  written("zones.geojson", "{}");
  for (const char* text :
       {"hard", "{name: soft, lateral_gamma_rad: 0.12}",
        "{cone_index_kpa: 812.5, lateral_gamma_rad: 0.1, texture: fine}",
        "{name: firm, texture: coarse}",
        "{friction: 0.25, rolling_resistance: 0.08, slip_stiffness: 12}",
        "{file: zones.geojson, default: tilled}",
        "{file: zones.geojson, layer: a, crs: 'EPSG:4326', cell_m: 2.5, default: "
        "{cone_index_kpa: 900}}"}) {
    const Scenario first = with(text);
    const std::string yaml = scenario_yaml(first);
    const Scenario second = read_scenario(written("again.yaml", yaml));
    EXPECT_EQ(scenario_yaml(second), yaml) << text;
    EXPECT_EQ(second.soil.soil.name, first.soil.soil.name);
    EXPECT_EQ(law_text(second.soil.soil), law_text(first.soil.soil));
    EXPECT_EQ(second.soil.soil.lateral_gamma_rad, first.soil.soil.lateral_gamma_rad);
    EXPECT_EQ(second.soil.soil.texture, first.soil.soil.texture);
    EXPECT_EQ(second.soil.file, first.soil.file);
    EXPECT_EQ(second.soil.layer, first.soil.layer);
    EXPECT_EQ(second.soil.crs, first.soil.crs);
    EXPECT_EQ(second.soil.cell_m, first.soil.cell_m);
  }
}

TEST_F(ScenarioSoil, IsToldByItsNameItsNumbersOrItsFile) {
  written("zones.geojson", "{}");
  EXPECT_EQ(soil_text(soil("tilled")), "tilled");
  EXPECT_EQ(soil_text(soil("{cone_index_kpa: 900}")), "cone index 900 kPa");
  EXPECT_EQ(soil_text(soil("{file: zones.geojson, default: tilled}")), "zones.geojson");
}

TEST_F(ScenarioSoil, RefusesInOneLineWhatIsNoSoil) {
  written("zones.geojson", "{}");
  const std::pair<const char*, const char*> cases[] = {
      {"tiled", "line 3: soil: 'tiled': unknown soil; did you mean 'tilled'?"},
      {"{name: mudd}", "line 3: soil.name: 'mudd': unknown soil"},
      {"{cone_index_kpa: -450}",
       "line 3: soil.cone_index_kpa: '-450': a number from 10 to 20000 is needed"},
      {"{cone_index_kpa: 0}", "soil.cone_index_kpa: '0': a number from 10 to 20000 is needed"},
      {"{friction: 2.5, rolling_resistance: 0.1}",
       "line 3: soil.friction: '2.5': a number from 0 to 2 is needed"},
      {"{friction: 0.5, rolling_resistance: -0.1}",
       "soil.rolling_resistance: '-0.1': a number from 0 to 1 is needed"},
      {"{friction: 0.5}", "line 3: soil.rolling_resistance: the key is missing"},
      {"{slip_stiffness: 8}", "line 3: soil: exactly one of name, cone_index_kpa and friction"},
      {"{name: soft, cone_index_kpa: 450}", "line 3: soil: exactly one of name"},
      {"{name: soft, slip_stiffness: 8}", "line 3: soil.slip_stiffness: only with friction"},
      {"{name: soft, texture: clay}",
       "line 3: soil.texture: 'clay': must be fine, medium or coarse"},
      {"{name: soft, lateral_gamma_rad: 0}",
       "soil.lateral_gamma_rad: '0': a number from 0.01 to 1 is needed"},
      {"{cone_index: 450}", "line 3: soil.cone_index: unknown key; did you mean 'cone_index_kpa'?"},
      {"[soft]", "line 3: soil: '[soft]': a soil's name or a mapping is needed, not a list"},
      {"{name: soft, default: firm}", "line 3: soil.default: only with soil.file"},
      {"{file: none.tif}", "none.tif': no such file"},
      {"{file: zones.geojson, name: soft}", "line 3: soil.name: not with soil.file"},
      {"{file: zones.geojson, cell_m: -1}",
       "soil.cell_m: '-1': 0 or a number from 0.05 to 100 is needed"},
      {"{file: zones.geojson, crs: 'EPSG:0'}", "line 3: soil.crs: 'EPSG:0': unknown CRS"},
      {"{file: zones.geojson, default: tiled}", "line 3: soil.default: 'tiled': unknown soil"},
      {"{file: zones.geojson, default: {file: zones.geojson}}",
       "line 3: soil.default.file: unknown key"},
  };
  for (const auto& [text, message] : cases) EXPECT_THAT(refused(text), HasSubstr(message)) << text;
}

}  // namespace
}  // namespace headland

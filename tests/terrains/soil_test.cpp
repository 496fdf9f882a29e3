#include "terrains/soil.h"

#include <gtest/gtest.h>

#include <set>

#include "terrains/soil_map.h"
#include "terrains/traction.h"

namespace headland {
namespace {

TEST(Soils, HaveNamesOfTheirOwnAndSources) {
  std::set<std::string_view> names;
  for (const Soil& listed : soils()) {
    EXPECT_TRUE(names.insert(listed.name).second);
    EXPECT_FALSE(listed.source.empty());
    EXPECT_EQ(find_soil(listed.name), &listed);
  }
  EXPECT_EQ(find_soil("cheese"), nullptr);
}

TEST(Soils, LetATractorMoveItself) {
  for (const Soil& listed : soils()) {
    const Traction traction = traction_on(listed, {0.42, 1.4, 0.3}, 10e3, 0.05);
    EXPECT_GT(best_pull(traction).net_pull, 0.0) << listed.name;
  }
}

TEST(SoilMap, GivesTheCellsSoilInsideAndTheFirstOutside) {
  SoilMap map = uniform_soil(*find_soil("firm"));
  EXPECT_EQ(soil_at(map, {1e6, -1e6}).name, "firm");
  map.soils.push_back(*find_soil("soft"));
  map.origin_W = {10.0, 20.0};
  map.cell_m = 2.0;
  map.columns = 2;
  map.rows = 1;
  map.index = {0, 1};
  EXPECT_EQ(soil_at(map, {13.0, 21.0}).name, "soft");
  EXPECT_EQ(soil_at(map, {11.0, 21.0}).name, "firm");
  EXPECT_EQ(soil_at(map, {13.0, 22.5}).name, "firm") << "above the grid";
  EXPECT_EQ(soil_at(map, {14.5, 21.0}).name, "firm") << "right of the grid";
  EXPECT_EQ(soil_at(map, {9.9, 21.0}).name, "firm") << "left of the grid";
}

}  // namespace
}  // namespace headland

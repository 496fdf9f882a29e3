#include "terrains/input_error.h"

#include <gtest/gtest.h>

namespace headland {
namespace {

TEST(InputError, LineLeavesOutEmptyParts) {
  EXPECT_STREQ(InputError("a.yaml", "soil", "mud", "one of firm, soft").what(),
               "a.yaml: soil: 'mud': one of firm, soft");
  EXPECT_STREQ(InputError("a.yaml", "", "", "no such file").what(), "a.yaml: no such file");
}

TEST(InputError, LineIsOneLine) {
  EXPECT_STREQ(InputError("a", "", "", "first\nsecond").what(), "a: first second");
}

TEST(InputError, AVeryLongValueIsCutInTheLine) {
  const InputError error("a", "name", std::string(5000, 'x'), "shorter");
  EXPECT_EQ(error.what(), "a: name: '" + std::string(100, 'x') + "...': shorter");
  EXPECT_EQ(error.value.size(), 5000U);
}

TEST(NearestName, IsTheOneWithFewestEdits) {
  EXPECT_EQ(nearest_name("rollin", {"flat", "rolling", "bowl"}), "rolling");
  EXPECT_EQ(nearest_name("persp", {"map", "chase", "perspective"}), "perspective");
  EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(InputError, AnUnknownNameIsToldWithTheNearest) {
  EXPECT_EQ(unknown_name("view", "mpa", {"chase", "map"}),
            "unknown view; did you mean 'map'? (known: chase, map)");
}

}  // namespace
}  // namespace headland

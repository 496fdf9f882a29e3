#include "terrains/parameter.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

#include "refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

const std::array<ParameterSpec, 3> kSpecs{{
    {"length_m", 2.0, 0.5, 10.0, {}, "a length"},
    {"order", std::string("spiral"), 0.0, 0.0, {"spiral", "skip"}, "a word"},
    {"rounds", std::string("auto"), 1.0, 20.0, {"auto"}, "a count or a word", true},
}};

Parameters resolved(const Parameters& given) {
  return resolve_parameters(kSpecs, given, "demo.yaml", "planner");
}

TEST(Parameter, DefaultsStandWhereNothingIsGiven) {
  const Parameters parameters = resolved({{"length_m", 3.5}});
  EXPECT_EQ(number(parameters, "length_m"), 3.5);
  EXPECT_EQ(word(parameters, "order"), "spiral");
}

TEST(Parameter, BoundsAreAllowedThemselves) {
  EXPECT_EQ(number(resolved({{"length_m", 0.5}}), "length_m"), 0.5);
  EXPECT_EQ(number(resolved({{"length_m", 10.0}}), "length_m"), 10.0);
}

TEST(Parameter, UnknownNameIsRefusedWithTheNearest) {
  EXPECT_EQ(refusal([] {
              resolved({{"lenght_m", 1.0}});
            }),
            "demo.yaml: planner.lenght_m: unknown parameter; the nearest is length_m");
}

TEST(Parameter, UnknownNameWhereThereAreNoneIsRefused) {
  EXPECT_THAT(refusal([] {
                resolve_parameters({}, {{"x", 1.0}}, "demo.yaml", "terrain");
              }),
              HasSubstr("terrain.x: unknown parameter; there are none"));
}

TEST(Parameter, NumberOutOfRangeIsRefused) {
  EXPECT_EQ(refusal([] {
              resolved({{"length_m", -1.0}});
            }),
            "demo.yaml: planner.length_m: '-1': a number from 0.5 to 10");
}

TEST(Parameter, NanIsRefused) {
  EXPECT_THAT(refusal([] {
                resolved({{"length_m", std::numeric_limits<double>::quiet_NaN()}});
              }),
              HasSubstr("'nan': a number from 0.5 to 10"));
}

TEST(Parameter, WordForANumberIsRefused) {
  EXPECT_THAT(refusal([] {
                resolved({{"length_m", std::string("long")}});
              }),
              HasSubstr("'long': a number"));
}

TEST(Parameter, AWholeNumberOrAWordWhereBothAreAllowed) {
  EXPECT_EQ(number_unless_word(resolved({}), "rounds"), std::nullopt);
  EXPECT_EQ(number_unless_word(resolved({{"rounds", 20.0}}), "rounds"), 20.0);
  for (const ParameterValue& value :
       {ParameterValue(1.5), ParameterValue(0.0), ParameterValue(21.0),
        ParameterValue(std::numeric_limits<double>::infinity()), ParameterValue("many")}) {
    EXPECT_THAT(refusal([&] {
                  resolved({{"rounds", value}});
                }),
                testing::EndsWith("': auto or a whole number from 1 to 20"));
  }
}

TEST(Parameter, UnknownWordIsRefused) {
  EXPECT_EQ(refusal([] {
              resolved({{"order", std::string("zigzag")}});
            }),
            "demo.yaml: planner.order: 'zigzag': one of spiral, skip");
}

}  // namespace
}  // namespace headland

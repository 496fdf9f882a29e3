// Colours that are to be told apart by those who see few colours, and on grey prints.
#include "render/palette.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace headland {
namespace {

// CIE 1976 L*, 0 black to 100 white, of sRGB.
double lightness(Rgba colour) {
  const auto linear = [](std::uint8_t level) {
    const double c = level / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y =
      0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(Palette, LightnessAloneTellsWorkedGroundApart) {
  EXPECT_NEAR(lightness({255, 255, 255}), 100.0, 0.01);
  EXPECT_NEAR(lightness({119, 119, 119}), 50.0, 0.1);  // negative control: nothing but a grey
  // Steps of 15 are seen side by side in shade and sun; below 10 they are not.
  constexpr double kLeastStep = 15.0;
  const std::array<Rgba, 4> classes = {colours::kUnworked, colours::kWorked, colours::kWorkedTwice,
                                       colours::kWorkedThrice};
  for (std::size_t i = 1; i < classes.size(); ++i) {
    EXPECT_GT(lightness(classes[i - 1]) - lightness(classes[i]), kLeastStep) << i;
  }
}

}  // namespace
}  // namespace headland

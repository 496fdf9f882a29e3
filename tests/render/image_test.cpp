#include "render/image.h"

#include <gtest/gtest.h>
#include <png.h>

namespace headland {
namespace {

Image gradient() {
  Image image{7, 5, {}};
  for (int i = 0; i < 4 * 7 * 5; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i % 251));
  return image;
}

TEST(Image, ComesBackFromPngBitByBit) {
  const std::string bytes = png_of(gradient());
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0) << png.message;
  png.format = PNG_FORMAT_RGBA;
  EXPECT_EQ(png.width, 7U);
  EXPECT_EQ(png.height, 5U);
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr), 0) << png.message;
  EXPECT_EQ(rgba, gradient().rgba);
}

}  // namespace
}  // namespace headland

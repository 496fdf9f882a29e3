#include "render/image.h"

#include <cpl_string.h>
#include <gtest/gtest.h>
#include <webp/decode.h>

#include <cmath>
#include <memory>

#include "render/page_image.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

std::string from_base64(std::string text) {
  text.resize(
      static_cast<std::size_t>(CPLBase64DecodeInPlace(reinterpret_cast<GByte*>(text.data()))));
  return text;
}

Image gradient() {
  Image image{7, 5, {}};
  for (int i = 0; i < 4 * 7 * 5; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i % 251));
  return image;
}

TEST(Image, ComesBackFromPngBitByBit) {
  const Image back = image_of_png(png_of(gradient()), "a.png");
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.rgba, gradient().rgba);
}

TEST(Image, RefusesWhatIsNoPng) {
  const std::string bytes = png_of(gradient());
  for (const std::string& cut : {std::string(), std::string("GIF89a"), bytes.substr(0, 60)}) {
    try {
      image_of_png(cut, "a.png");
      ADD_FAILURE() << cut.size() << " bytes were taken";
    } catch (const InputError& refused) {
      EXPECT_EQ(refused.source, "a.png");
    }
  }
}

// Smooth hills of light under thin lines, as a picture of a field is.
Image hills() {
  Image image{320, 200, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double light = 120.0 + 60.0 * std::sin(0.031 * x) * std::cos(0.047 * y) + (x * y) % 7;
      const auto shade = static_cast<std::uint8_t>(x % 40 == 0 ? 20.0 : light);
      image.rgba.insert(image.rgba.end(),
                        {shade, shade, static_cast<std::uint8_t>(shade / 2), 255});
    }
  }
  return image;
}

// Root of the mean square of the differences [levels of 255] once the URL is read again.
double lost(const Image& image) {
  const std::string kWebp = "data:image/webp;base64,";
  const std::string url = image_url(image);
  EXPECT_EQ(url.substr(0, kWebp.size()), kWebp);
  const std::string bytes = from_base64(url.substr(kWebp.size()));
  int width = 0;
  int height = 0;
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> rgba(
      WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), &width,
                     &height),
      &WebPFree);
  EXPECT_EQ(width, image.width);
  EXPECT_EQ(height, image.height);
  if (rgba == nullptr || width != image.width || height != image.height) return 255.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    squares += std::pow(image.rgba[i] - rgba.get()[i], 2);
  }
  return std::sqrt(squares / static_cast<double>(image.rgba.size()));
}

TEST(PageImage, IsSmallAndLooksTheSame) {
  constexpr double kUnseen = 4.0;  // 36 dB
  EXPECT_LT(image_url(hills()).size(), png_of(hills()).size() / 2);
  EXPECT_LT(lost(hills()), kUnseen);
}

TEST(PageImage, AFlatFigureLosesNothing) {
  Image figure{320, 200, {}};
  for (int y = 0; y < figure.height; ++y) {
    for (int x = 0; x < figure.width; ++x) {
      const bool line = x % 20 == 0 || y % 20 == 0;
      const auto shade = static_cast<std::uint8_t>(line ? 30 : (x / 20 + y / 20) % 3 * 100);
      figure.rgba.insert(figure.rgba.end(), {shade, 200, shade, 255});
    }
  }
  EXPECT_EQ(lost(figure), 0.0);
  EXPECT_LT(image_url(figure).size(), png_of(figure).size());
}

TEST(PageImage, WhatIsTooLargeForWebpIsPng) {
  const Image tall{2, 17000, std::vector<std::uint8_t>(std::size_t{4} * 2 * 17000, 255)};
  EXPECT_EQ(image_url(tall).substr(0, 15), "data:image/png;");
}

}  // namespace
}  // namespace headland

#include "render/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "terrains/input_error.h"

namespace headland {
namespace {

using testing::HasSubstr;

std::filesystem::path scratch(const char* name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "headland_image";
  std::filesystem::create_directories(folder);
  return folder / name;
}

Image gradient() {
  Image image{7, 5, {}};
  for (int i = 0; i < 4 * 7 * 5; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i % 251));
  return image;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Image, ComesBackFromPngBitByBit) {
  const auto file = scratch("gradient.png");
  write_png(gradient(), file);
  const Image read = read_png(file);
  EXPECT_EQ(read.width, 7);
  EXPECT_EQ(read.height, 5);
  EXPECT_EQ(read.rgba, gradient().rgba);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(Image, RefusesAFolderThatIsNotThere) {
  const auto file = scratch("nowhere") / "picture.png";
  EXPECT_THAT(refusal([&] { write_png(gradient(), file); }),
              testing::AllOf(HasSubstr(file.string()), HasSubstr("cannot be written")));
}

TEST(Image, LeavesNothingBehindOnAFullDisk) {
  // /dev/full takes no byte; the temporary name is a link to it.
  const auto file = scratch("full.png");
  const std::filesystem::path part = file.string() + ".part";
  std::filesystem::remove(part);
  std::filesystem::create_symlink("/dev/full", part);
  Image large{400, 400, std::vector<std::uint8_t>(4 * 400 * 400, 9)};
  EXPECT_THAT(refusal([&] { write_png(large, file); }), HasSubstr("cannot be written"));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(part)));
}

TEST(Image, RefusesWhatIsNoPng) {
  const auto file = scratch("no.png");
  std::ofstream(file) << "not a picture";
  EXPECT_THAT(refusal([&] { read_png(file); }), HasSubstr("no readable PNG"));
  EXPECT_THAT(refusal([] { read_png("/missing.png"); }), HasSubstr("/missing.png"));
}

}  // namespace
}  // namespace headland

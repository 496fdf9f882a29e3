// headland render --view and --video from end to end.
#include <gmock/gmock.h>

#include "tests/apps/command.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class RenderTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    ASSERT_EQ(headland("plan tiny.yaml -o A -q").exit_code, 0);
    ASSERT_LE(headland("drive A -q").exit_code, 1);
  }

  // Width and height from a PNG's header, as "640x400".
  std::string png_size(const std::string& name) const {
    const std::string bytes = text_of(folder_ / name);
    if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return "no PNG";
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t i = at; i < at + 4; ++i) {
        value = 256 * value + static_cast<unsigned char>(bytes[i]);
      }
      return std::to_string(value);
    };
    return number(16) + "x" + number(20);
  }

  std::string refused(const std::string& arguments, const std::string& before = "") const {
    const std::set<std::string> files = files_in("A");
    const CommandResult result = headland("render A " + arguments, before);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(files_in("A"), files) << arguments;
    return result.err;
  }
};

TEST_F(RenderTest, DrawsEveryView) {
  for (const char* view : {"map", "perspective", "chase", "elevation", "event:tightest_turn"}) {
    const std::string arguments = std::string("render A --size 640x400 --view ") + view;
    ASSERT_EQ(headland(arguments + " -o one.png -q").exit_code, 0) << view;
    EXPECT_EQ(png_size("one.png"), "640x400") << view;
  }
  ASSERT_EQ(headland("render A --size 640x400 --overlay speed -o other.png -q").exit_code, 0);
  EXPECT_EQ(png_size("other.png"), "640x400");
  EXPECT_EQ(headland("render A --view chase --at 0:30 --size 640x400").out, "A/chase.png\n");
  EXPECT_EQ(png_size("A/chase.png"), "640x400");
}

TEST_F(RenderTest, RefusesWhatItCannotDraw) {
  EXPECT_THAT(refused("--view birdseye"),
              HasSubstr("--view: 'birdseye': unknown view; did you mean "));
  EXPECT_THAT(
      refused("--view elevations"),
      HasSubstr("did you mean 'elevation'? (known: map, perspective, chase, elevation, grid, "
                "event:worst_slip"));
  EXPECT_THAT(refused("--view event:colision"),
              HasSubstr("'colision': unknown event; did you mean 'collision'? (known: worst_slip"));
  EXPECT_THAT(refused("--view event:collision"), HasSubstr("this did not happen in the run"));
  EXPECT_THAT(refused("--view grid"), HasSubstr("the run was not planned on a grid map"));
  EXPECT_THAT(refused("--overlay mood"),
              HasSubstr("--overlay: 'mood': unknown overlay; did you mean "));
  EXPECT_THAT(refused("--overlay tracing"),
              HasSubstr("did you mean 'tracking'? (known: power, energy_per_metre, slip"));
  EXPECT_THAT(refused("--at 99:00:00"), HasSubstr("the run ends after"));
  for (const char* time : {"soon", "1:75", "-5", "1:2:3:4", "1::2", "1e9", "."}) {
    EXPECT_THAT(refused(std::string("--at=") + time),
                HasSubstr("--at: '" + std::string(time) + "': seconds, as 90 or 90.5, or 1:30"))
        << time;
  }
  EXPECT_THAT(refused("--view elevation --exaggeration 0.5"), HasSubstr("from 1 to 1000"));
  EXPECT_THAT(refused("--view chase --exaggeration 2"), HasSubstr("drawn to scale"));
  EXPECT_THAT(refused("--view map -o A/map.jpg"), HasSubstr("ends in .png"));
  EXPECT_THAT(refused("--view map --size 9000x9000"), HasSubstr("to 8192x8192 pixels"));
}

TEST_F(RenderTest, AFolderInPlaceOfAFileIsNotRead) {
  for (const char* name : {"run.csv", "path.geojson", "scenario.yaml"}) {
    std::filesystem::remove(folder_ / "A" / name);
    std::filesystem::create_directory(folder_ / "A" / name);
    EXPECT_THAT(refused("--view map"), HasSubstr(std::string(name) + ": is a folder, not a file"));
  }
}

TEST_F(RenderTest, DrawsWhatIsLeftOfACutOffRecordAndSaysSo) {
  const std::string run = text_of(folder_ / "A" / "run.csv");
  write("A/run.csv", run.substr(0, run.size() / 2));
  const CommandResult cut = headland("render A --view chase --size 640x400 -q");
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_THAT(cut.err, HasSubstr("The time series ends after"));
  EXPECT_EQ(png_size("A/chase.png"), "640x400");
  // All pictures likewise, without a verdict, which needs the whole.
  const CommandResult all = headland("render A --size 640x400");
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_THAT(all.err, HasSubstr("The time series ends after"));
  EXPECT_EQ(all.out, "A/field.png\nA/view.png\nA/energy.png\n");
  for (const char* name : {"A/field.png", "A/view.png", "A/energy.png"}) {
    EXPECT_EQ(png_size(name), "640x400") << name;
  }
  // Nothing but the header.
  write("A/run.csv", run.substr(0, run.find('\n') + 1));
  fs::remove(folder_ / "A" / "chase.png");
  EXPECT_EQ(headland("render A --view map --size 640x400 -q").exit_code, 0);
  const CommandResult still = headland("render A --size 640x400");
  EXPECT_EQ(still.exit_code, 0) << still.err;
  EXPECT_THAT(still.err,
              HasSubstr("The time series is missing (run.csv, line 2: the table has no rows"));
  const CommandResult none = headland("render A --view chase --size 640x400 -q");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("the run has no moment to be drawn"));
  EXPECT_FALSE(fs::exists(folder_ / "A" / "chase.png"));
}

TEST_F(RenderTest, FilmsTheRunInOrderWhateverTheNumberOfProcesses) {
  const std::string film = "render A --size 480x270 --from 10 --to 30 --speed 50 --fps 10 -q ";
  ASSERT_EQ(headland(film + "--video one.mp4 --jobs 1").exit_code, 0);
  ASSERT_EQ(headland(film + "--video two.mp4 --jobs 3").exit_code, 0);
  const std::string bytes = text_of(folder_ / "one.mp4");
  EXPECT_EQ(bytes.substr(4, 4), "ftyp");
  EXPECT_TRUE(bytes == text_of(folder_ / "two.mp4"));
  for (const std::string& name : files_in(".")) EXPECT_THAT(name, Not(HasSubstr(".part")));
}

TEST_F(RenderTest, RefusesVideosItCannotMake) {
  EXPECT_THAT(refused("--video A/run.avi"), HasSubstr("ends in .mp4"));
  EXPECT_THAT(refused("--video A/run.mp4 --size 641x400"), HasSubstr("even numbers"));
  EXPECT_THAT(refused("--video A/run.mp4 --speed 0"), HasSubstr("from 0.01 to 10000"));
  EXPECT_THAT(refused("--video A/run.mp4 --fps 500"), HasSubstr("from 1 to 60"));
  EXPECT_THAT(refused("--video A/run.mp4 --from 20 --to 10"), HasSubstr("before --to"));
  EXPECT_THAT(refused("--video A/run.mp4 --view map"), HasSubstr("takes none of --view"));
  for (const char* jobs : {"0", "-1", "65"}) {
    EXPECT_THAT(refused(std::string("--video A/run.mp4 --jobs=") + jobs),
                HasSubstr("--jobs: '" + std::string(jobs) + "': from 1 to 64"));
  }
  EXPECT_THAT(refused("--video A/run.mp4 --from soon"), HasSubstr("--from: 'soon': seconds, as"));
  EXPECT_THAT(refused("--video A/run.mp4 --to 1:75"), HasSubstr("--to: '1:75': seconds, as"));
  EXPECT_THAT(refused("--video A/run.mp4 --to 99:00:00"),
              HasSubstr("--to: '356400 s': the run ends after"));
  for (const char* option : {"--from 1", "--to 1", "--speed 3", "--fps 10", "--jobs 2"}) {
    EXPECT_THAT(refused(option), HasSubstr("are of a --video")) << option;
  }
  EXPECT_THAT(refused("--video A/run.mp4", "PATH=/nowhere"),
              HasSubstr("ffmpeg: is not installed; it writes videos (Debian: ffmpeg)"));
  EXPECT_THAT(refused("--video nowhere/deep/run.mp4 --to 1"),
              AllOf(HasSubstr("nowhere/deep/run.mp4"), HasSubstr("in a folder that exists")));
}

}  // namespace
}  // namespace headland

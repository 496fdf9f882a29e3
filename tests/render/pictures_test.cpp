// The three pictures as they come out: to be looked at.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/render/made_run.h"

namespace headland {
namespace {

TEST(Pictures, AreWrittenForTheEyeOnRequest) {
  const char* folder = std::getenv("HEADLAND_LOOK_AT");
  if (folder == nullptr) GTEST_SKIP() << "set HEADLAND_LOOK_AT to a folder to get the pictures";
  const std::filesystem::path to(folder);
  const MadeRun large = rolling_run(420.0, 9.0);
  const MadeRun small = rolling_run(60.0, 2.0);
  write_png(draw_field_map(large.scene(), {}), to / "large_field.png");
  write_png(draw_energy_map(large.scene(), {}), to / "large_energy.png");
  write_png(draw_view(large.scene(), {}), to / "large_view.png");
  write_png(draw_view(small.scene(), {}), to / "small_view.png");
  write_png(draw_field_map(small.scene(), {}), to / "small_field.png");
  write_png(draw_energy_map(small.scene(), {}), to / "small_energy.png");
}

}  // namespace
}  // namespace headland

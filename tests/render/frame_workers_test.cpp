#include "render/frame_workers.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <stdexcept>

#include "terrains/input_error.h"

namespace headland {
namespace {

Image dot(int frame) {
  const auto value = static_cast<std::uint8_t>(frame);
  return {1, 1, {value, value, value, 255}};
}

bool has_children() { return !(::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD); }

const auto kNever = [] { return false; };

TEST(FrameWorkers, DeliverFramesInOrder) {
  constexpr int kFrames = 20;
  FrameWorkers workers(kFrames, 3, [] { return DrawFrame(dot); });
  std::vector<std::uint8_t> rgba;
  for (int frame = 0; frame < kFrames; ++frame) {
    ASSERT_TRUE(workers.read(frame, rgba, 4, kNever));
    EXPECT_EQ(rgba[0], frame);
  }
}

TEST(FrameWorkers, TellWhatAProcessThrewAndLeaveNone) {
  {
    FrameWorkers workers(4, 2, []() -> DrawFrame { throw std::runtime_error("no brush"); });
    std::vector<std::uint8_t> rgba;
    try {
      workers.read(0, rgba, 400, kNever);  // frames are longer than what is told
      FAIL() << "a fault is not told";
    } catch (const InputError& fault) {
      EXPECT_THAT(fault.what(), ::testing::HasSubstr("no brush"));
    }
    // One asks for what no process will ever draw.
    EXPECT_FALSE(workers.read(1, rgba, 1 << 20, [] { return true; }));
  }
  EXPECT_FALSE(has_children());
}

TEST(FrameWorkers, LeaveNoProcessWhenNotAllCanBeStarted) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit few = before;
  // Each process takes one; room for some of them, not for all.
  few.rlim_cur = 24;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  EXPECT_THROW(FrameWorkers(100, 60, [] { return DrawFrame(dot); }), InputError);
  ::setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace headland

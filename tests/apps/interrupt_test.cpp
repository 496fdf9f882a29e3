// What Ctrl-C, and requests to end, leave of every stage.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class InterruptTest : public CommandTest {};

// Whether process `pid` has come so far as to handle Ctrl-C itself.
bool catches_interrupts(pid_t pid) {
  constexpr unsigned long kInterruptBit = 1UL << (SIGINT - 1);
  const std::string status = text_of("/proc/" + std::to_string(pid) + "/status");
  const std::size_t found = status.find("SigCgt:");
  return found != std::string::npos &&
         (std::stoul(status.substr(found + 7), nullptr, 16) & kInterruptBit) != 0;
}

struct Interruption {
  int exit_code = -1;  // -1: killed, because it did not end
  std::string err;
  double took_s = 0.0;  // from the signal to the end
};

// Runs `headland SUBCOMMAND ARGUMENTS...` in `folder` and sends Ctrl-C, or another signal,
// `delay_us` after it has come to handle it.
Interruption interrupt(const std::filesystem::path& folder, std::vector<const char*> arguments,
                       useconds_t delay_us, int signal = SIGINT) {
  arguments.insert(arguments.begin(), "headland");
  arguments.push_back(nullptr);
  const std::string errors = (folder / ".err").string();
  const pid_t pid = ::fork();
  if (pid == 0) {
    if (::chdir(folder.c_str()) != 0) ::_exit(99);
    if (std::freopen(errors.c_str(), "w", stderr) == nullptr) ::_exit(99);
    ::execv(HEADLAND_BINARY, const_cast<char* const*>(arguments.data()));
    ::_exit(99);
  }
  constexpr int kMostPolls = 20000;
  for (int poll = 0; !catches_interrupts(pid) && poll < kMostPolls; ++poll) ::usleep(1000);
  ::usleep(delay_us);
  const auto sent = std::chrono::steady_clock::now();
  ::kill(pid, signal);
  int status = 0;
  for (int poll = 0; ::waitpid(pid, &status, WNOHANG) == 0; ++poll) {
    if (poll == kMostPolls) ::kill(pid, SIGKILL);
    ::usleep(1000);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - sent;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(errors), took.count()};
}

TEST_F(InterruptTest, CtrlCWhilePlanningWritesNothing) {
  // So fine a terrain takes longer to make than the signal to arrive.
  write("fine.yaml", kTinyScenario + "terrain: {generator: rolling, cell_m: 0.03, margin_m: 30}\n");
  const Interruption plan = interrupt(folder_, {"plan", "fine.yaml", "-o", "DIR"}, 0);
  EXPECT_EQ(plan.exit_code, 130);
  EXPECT_EQ(plan.err, "headland: interrupted; what the finished stages wrote is kept\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR"));
}

TEST_F(InterruptTest, CtrlCWhileFilmingLeavesNoFile) {
  ASSERT_LE(headland("evaluate tiny.yaml --size 640x400 -o DIR -q").exit_code, 1);
  const std::set<std::string> before = files_in("DIR");
  constexpr useconds_t kIntoTheFilming_us = 700000;
  constexpr double kAtOnce_s = 3.0;  // on a busy machine; so many frames take longer
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Interruption film =
        interrupt(folder_, {"render", "DIR", "--video", "DIR/run.mp4", "--speed", "1", "-q"},
                  kIntoTheFilming_us, signal);
    EXPECT_EQ(film.exit_code, 130) << signal;
    EXPECT_EQ(film.err, "headland: interrupted; what the finished stages wrote is kept\n");
    EXPECT_LT(film.took_s, kAtOnce_s);
    EXPECT_EQ(files_in("DIR"), before);
  }
}

TEST_F(InterruptTest, CtrlCWhileDrawingEndsAtOnceAndLeavesNoPicture) {
  ASSERT_LE(headland("evaluate tiny.yaml --size 640x400 -o DIR -q").exit_code, 1);
  const std::string before = text_of(folder_ / "DIR" / "field.png");
  const std::size_t files_before = files_in("DIR").size();
  constexpr useconds_t kIntoTheDrawing_us = 500000;
  constexpr double kAtOnce_s = 3.0;  // on a busy machine; pictures this large take longer
  const Interruption render =
      interrupt(folder_, {"render", "DIR", "--size", "8000x8000"}, kIntoTheDrawing_us);
  EXPECT_EQ(render.exit_code, 130);
  EXPECT_EQ(render.err, "headland: interrupted; what the finished stages wrote is kept\n");
  EXPECT_LT(render.took_s, kAtOnce_s);
  EXPECT_EQ(text_of(folder_ / "DIR" / "field.png"), before);
  EXPECT_EQ(files_in("DIR").size(), files_before);
}

TEST_F(InterruptTest, CtrlCEndsPlanningWithinASecond) {
  std::string orchard = "field: {boundary: [[0, 0], [300, 0], [300, 300], [0, 300]], obstacles: [";
  for (int tree = 0; tree < 196; ++tree) {
    orchard += fmt::format("{}{{at: [{}, {}]}}", tree > 0 ? ", " : "",
                           20 + tree / 14 * 20 + tree % 3, 20 + tree % 14 * 20 + tree % 5);
  }
  write("orchard.yaml", orchard + "]}\ncoverage: {cell_m: 1}\nvehicle: transplanter\n");
  constexpr useconds_t kIntoPlanning_us = 500000;
  constexpr double kAtOnce_s = 1.0;
  const Interruption plan =
      interrupt(folder_, {"plan", "orchard.yaml", "-o", "DIR"}, kIntoPlanning_us);
  EXPECT_LT(plan.took_s, kAtOnce_s);
  EXPECT_EQ(plan.exit_code, 130);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR"));
}

TEST_F(InterruptTest, CtrlCDropsTheRunAndKeepsThePlan) {
  // Fast steps make the drive last for seconds.
  write(
      "tiny.yaml",
      std::string(kTinyScenario).replace(kTinyScenario.find("record_hz: 2"), 12, "rate_hz: 2000"));
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  constexpr useconds_t kIntoTheDrive_us = 300000;
  const Interruption drive = interrupt(folder_, {"drive", "DIR"}, kIntoTheDrive_us);
  EXPECT_EQ(drive.exit_code, 130);
  EXPECT_THAT(drive.err, HasSubstr("headland: interrupted"));
  EXPECT_THAT(files_in("DIR"),
              UnorderedElementsAre("scenario.yaml", "plan.geojson", "path.geojson"));
}

}  // namespace
}  // namespace headland

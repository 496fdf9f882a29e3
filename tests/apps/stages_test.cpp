// The command from end to end, on a tiny field.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class StagesTest : public CommandTest {};

const std::string kEvaluate = "evaluate tiny.yaml --size 320x240 -o ";

TEST_F(StagesTest, EvaluateFillsTheFolderAndTellsInBothForms) {
  const CommandResult result = headland(kEvaluate + "DIR --json");
  EXPECT_LE(result.exit_code, 1) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(files_in("DIR"),
              UnorderedElementsAre("scenario.yaml", "plan.geojson", "path.geojson", "run.csv",
                                   "footprint.csv", "segments.csv", "metrics.json", "field.png",
                                   "view.png", "energy.png"));
  EXPECT_EQ(result.out, text_of(folder_ / "DIR" / "metrics.json"));
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(result.exit_code == 1, json["verdict"]["grade"] == "FAIL");
  EXPECT_EQ(json["outcome"]["name"], "finished");
  EXPECT_GT(json["figures"]["coverage_ratio"].get<double>(), 0.5);
}

TEST_F(StagesTest, SameSeedSameBytesAndStagesGiveTheBytesOfTheWhole) {
  ASSERT_LE(headland(kEvaluate + "A -q").exit_code, 1);
  ASSERT_LE(headland(kEvaluate + "B -q").exit_code, 1);
  ASSERT_EQ(headland("plan tiny.yaml -o C -q").exit_code, 0);
  ASSERT_LE(headland("drive C -q").exit_code, 1);
  ASSERT_EQ(headland("render C --size 320x240 -q").exit_code, 0);
  for (const std::string& name : files_in("A")) {
    const std::string bytes = text_of(folder_ / "A" / name);
    EXPECT_TRUE(text_of(folder_ / "B" / name) == bytes) << name << " differs from run to run";
    EXPECT_TRUE(text_of(folder_ / "C" / name) == bytes) << name << " differs in stages";
  }
  EXPECT_EQ(files_in("C"), files_in("A"));
}

TEST_F(StagesTest, AFailingVerdictExitsWith1) {
  write("tiny.yaml", kTinyScenario + "verdict: {reserve_soc_min: {warn: 1, fail: 1}}\n");
  const CommandResult result = headland(kEvaluate + "DIR");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("verdict: FAIL"));
}

TEST_F(StagesTest, DrivesATrackOfAnotherTool) {
  write("track.csv", "x,y\n10,20\n20,20\n30,20\n40,20\n50,20\n");
  const CommandResult result = headland("drive tiny.yaml --path track.csv -o DIR");
  EXPECT_EQ(result.exit_code, 1) << result.err;  // one strip does not cover the field
  EXPECT_THAT(result.out, HasSubstr("track made drivable"));
  EXPECT_THAT(result.out, HasSubstr("finished"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "DIR" / "plan.geojson"));
}

// Whether process `pid` has come so far as to handle Ctrl-C itself.
bool catches_interrupts(pid_t pid) {
  constexpr unsigned long kInterruptBit = 1UL << (SIGINT - 1);
  const std::string status = text_of("/proc/" + std::to_string(pid) + "/status");
  const std::size_t found = status.find("SigCgt:");
  return found != std::string::npos &&
         (std::stoul(status.substr(found + 7), nullptr, 16) & kInterruptBit) != 0;
}

TEST_F(StagesTest, CtrlCDropsTheRunAndKeepsThePlan) {
  // Fast steps make the drive last for seconds.
  write(
      "tiny.yaml",
      std::string(kTinyScenario).replace(kTinyScenario.find("record_hz: 2"), 12, "rate_hz: 2000"));
  ASSERT_EQ(headland("plan tiny.yaml -o DIR -q").exit_code, 0);
  const std::string folder = (folder_ / "DIR").string();
  const std::string errors = (folder_ / ".err").string();
  const pid_t pid = ::fork();
  if (pid == 0) {
    if (std::freopen(errors.c_str(), "w", stderr) == nullptr) ::_exit(99);
    ::execl(HEADLAND_BINARY, "headland", "drive", folder.c_str(), static_cast<char*>(nullptr));
    ::_exit(99);
  }
  while (!catches_interrupts(pid)) ::usleep(1000);
  constexpr useconds_t kIntoTheDrive_us = 300000;
  ::usleep(kIntoTheDrive_us);
  ::kill(pid, SIGINT);
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(text_of(errors), HasSubstr("headland: interrupted"));
  EXPECT_THAT(files_in("DIR"),
              UnorderedElementsAre("scenario.yaml", "plan.geojson", "path.geojson"));
}

TEST_F(StagesTest, ListsAndHelp) {
  for (const char* kind : {"planners", "vehicles", "soils", "generators"}) {
    const CommandResult text = headland(std::string("list ") + kind);
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_NE(text.out, "");
    const auto list = nlohmann::json::parse(headland(std::string("list ") + kind + " --json").out);
    EXPECT_FALSE(list.empty());
  }
  for (const char* command : {"evaluate", "plan", "drive", "render", "list"}) {
    const CommandResult help = headland(std::string(command) + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("Example"));
  }
  EXPECT_THAT(headland("--version").out, HasSubstr("headland "));
}

}  // namespace
}  // namespace headland

// Runs the real `headland` binary in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace headland {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

// A field of 60 m by 40 m on flat ground, coarse and quick.
inline const std::string kTinyField =
    "field: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\n"
    "simulation: {record_hz: 2}\n"
    "coverage: {cell_m: 0.5}\n";
inline const std::string kTinyScenario = kTinyField + "vehicle: transplanter\n";

class CommandTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("headland_" + name + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("tiny.yaml", kTinyScenario);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  // Runs in the test's folder; `arguments` go through the shell.
  CommandResult headland(const std::string& arguments, const std::string& before = "") const {
    const std::string line = "cd '" + folder_.string() + "' && " + before +
                             " '" HEADLAND_BINARY "' " + arguments + " >.out 2>.err </dev/null";
    const int status = std::system(line.c_str());
    CommandResult result;
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    result.out = text_of(folder_ / ".out");
    result.err = text_of(folder_ / ".err");
    return result;
  }

  std::set<std::string> files_in(const std::string& name) const {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / name)) {
      files.insert(entry.path().filename().string());
    }
    return files;
  }

  std::filesystem::path folder_;
};

}  // namespace headland

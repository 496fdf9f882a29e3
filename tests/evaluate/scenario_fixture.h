// A folder for a scenario, which tests write, read and see refused.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "evaluate/scenario.h"
#include "terrains/input_error.h"

namespace headland::test {

class ScenarioTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Scenario read(const std::string& yaml, std::optional<std::uint64_t> seed = std::nullopt) {
    std::ofstream(file_) << yaml;
    return read_scenario(file_, seed);
  }

  std::string refusal(const std::string& yaml) {
    try {
      read(yaml);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_THAT(error.what(), ::testing::HasSubstr(file_.string()));
      return error.what();
    }
    return "(accepted)";
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file_ = folder_ / "field.yaml";
};

inline const std::string kField = "field: {boundary: [[0, 0], [60, 0], [60, 40], [0, 40]]}\n";
inline const std::string kLeast = kField + "vehicle: transplanter\n";

}  // namespace headland::test

// The plain test vehicle with one piece of text replaced.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {

inline const std::filesystem::path kPlain =
    std::filesystem::path(HEADLAND_TEST_DATA) / "vehicles/plain";

// A copy of the plain vehicle's folder in which every `from` of one file is a `to`.
class ChangedVehicle {
 public:
  ChangedVehicle(const std::string& file, const std::string& from, const std::string& to) {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = std::filesystem::path(testing::TempDir()) / ("headland_vehicle_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(kPlain, folder_, std::filesystem::copy_options::recursive);
    std::ifstream original(kPlain / file);
    std::stringstream text;
    text << original.rdbuf();
    std::string changed = text.str();
    std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << "the plain vehicle has no text '" << from << "'";
    for (; at != std::string::npos; at = changed.find(from, at + to.size())) {
      changed.replace(at, from.size(), to);
    }
    std::ofstream(folder_ / file) << changed;
  }
  ~ChangedVehicle() { std::filesystem::remove_all(folder_); }
  ChangedVehicle(const ChangedVehicle&) = delete;
  ChangedVehicle& operator=(const ChangedVehicle&) = delete;

  std::string folder() const { return folder_.string(); }

 private:
  std::filesystem::path folder_;
};

// What the loader says about a folder; empty when it takes it.
inline std::string load_message(const std::string& folder) {
  try {
    load_vehicle(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline std::string refusal_of(const std::string& file, const std::string& from,
                              const std::string& to) {
  const ChangedVehicle vehicle(file, from, to);
  return load_message(vehicle.folder());
}

}  // namespace headland

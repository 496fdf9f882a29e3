// What of a vehicle's numbers nobody measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace headland {

struct Assumption {
  std::string key;    // "battery.capacity_ah"
  std::string value;  // as it stands in the file
  std::string why;    // may be empty
};

// The values of a drive.yaml whose source begins with 'assumed', in the file's order. None for a
// file that cannot be read: the vehicle's loader tells of that.
std::vector<Assumption> assumptions_of(const std::filesystem::path& drive_file);

}  // namespace headland

// The keys of a drive.yaml: one literal table.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "vehicle_models/vehicle.h"

namespace headland {

// One key and where its value goes: exactly one of number, integer, text and choose is set. Numbers
// lie in [min, max], in the file's unit; the target gets `scale` times the number (degrees to
// radians). A word is one of `words`, and `choose` is called with its place there.
struct DriveKey {
  std::string_view key;
  double min = 0.0;
  double max = 0.0;
  double* number = nullptr;
  double scale = 1.0;
  int* integer = nullptr;
  std::string* text = nullptr;
  std::vector<std::string_view> words = {};
  std::function<void(std::size_t)> choose = {};
  bool optional = false;
};

struct DriveSection {
  std::string_view name;
  std::vector<DriveKey> keys;
};

// Every section and key of a drive.yaml, with targets in `vehicle`. The section kTrailing is there
// when the vehicle's implement trails, the section kDraft when it tills by a law of its own.
inline constexpr std::string_view kTrailing = "trailing";
inline constexpr std::string_view kDraft = "draft";
inline constexpr std::string_view kDraftTool = "tool";
inline constexpr std::string_view kDraftPerMetre = "draft_n_per_m";
std::vector<DriveSection> sections_of(Vehicle& vehicle);

}  // namespace headland

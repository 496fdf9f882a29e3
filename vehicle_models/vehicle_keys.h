// The keys of a vehicle file: one literal table.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "vehicle_models/vehicle.h"

namespace headland {

// One key and where its value goes: exactly one of the targets is set. Numbers lie in [min, max],
// in the file's unit; the target gets `scale` times the number (degrees to radians).
struct VehicleKey {
  std::string_view key;
  double min = 0.0;
  double max = 0.0;
  double* number = nullptr;
  double scale = 1.0;
  int* integer = nullptr;
  Eigen::Vector3d* vector = nullptr;
  bool* flag = nullptr;
  std::string* text = nullptr;
  Chemistry* chemistry = nullptr;
};

struct VehicleSection {
  std::string_view name;
  std::vector<VehicleKey> keys;
};

// Every section and key of a vehicle file, with targets in `vehicle`.
std::vector<VehicleSection> sections_of(Vehicle& vehicle);

}  // namespace headland

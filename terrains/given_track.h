// A track as its file gives it, before it is brought into frame W: what the readers of CSV and of
// vector files share.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "terrains/field.h"

namespace headland {

struct GivenPoint {
  Eigen::Vector2d given = Eigen::Vector2d::Zero();  // metres, or longitude and latitude
  bool joined = false;                              // to its predecessor
  bool after_pause = false;                         // logged much later than its predecessor
  bool down = true;                                 // the implement; by default it is
  std::size_t number = 0;                           // of its line or point in the file
};

// All points, in order; at least one with the implement down.
struct GivenTrack {
  std::vector<GivenPoint> points;
  bool degrees = false;
  bool of_vehicle = false;          // of its reference point, not of the implement
  bool of_implement = false;        // and told so
  double longest_interval_s = 0.0;  // that is no pause; 0 without times
  std::string_view counted = "line";
};

// Both throw InputError as read_track does.
GivenTrack track_from_csv(const std::filesystem::path& file, const GeoFrame& frame);
GivenTrack track_from_vector_file(const std::filesystem::path& file, const GeoFrame& frame);
// The guidance lines of the partfields whose lines reach into the field: those that are not
// repeated, where there are any.
GivenTrack track_from_task_data(const std::filesystem::path& file, const Field& field);

// The middle value, of two the greater. At least one value.
double upper_median(std::vector<double> values);

}  // namespace headland

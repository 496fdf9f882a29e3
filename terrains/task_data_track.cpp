// Guidance lines of task data as a track.
#include <fmt/format.h>

#include <algorithm>

#include "terrains/given_track.h"
#include "terrains/input_error.h"
#include "terrains/task_data.h"

namespace headland {
namespace {

// A point with a direction and a circle about a point are no lines to drive along.
bool is_line(const GuidancePattern& pattern) {
  return pattern.kind != GuidanceKind::kAPlus && pattern.kind != GuidanceKind::kPivot &&
         pattern.line.lon_lat_deg.size() >= 2;
}

bool reaches_into(const Field& field, const Partfield& partfield) {
  return std::ranges::any_of(partfield.guidance, [&](const GuidancePattern& pattern) {
    const std::vector<Eigen::Vector2d> points_W =
        local_from_wgs84(field.frame, pattern.line.lon_lat_deg);
    return std::ranges::any_of(
        points_W, [&](const Eigen::Vector2d& p_W) { return inside_ring(field.boundary, p_W); });
  });
}

std::vector<Partfield> guided_partfields(const TaskData& data, const Field& field) {
  std::vector<Partfield> guided;
  for (const Partfield& partfield : data.partfields) {
    if (std::ranges::any_of(partfield.guidance, is_line)) guided.push_back(partfield);
  }
  if (guided.size() > 1 && field.frame.georeferenced) {
    std::erase_if(guided,
                  [&](const Partfield& partfield) { return !reaches_into(field, partfield); });
  }
  return guided;
}

}  // namespace

GivenTrack track_from_task_data(const std::filesystem::path& file, const Field& field) {
  const TaskData data = read_task_data(file);
  const std::vector<Partfield> guided = guided_partfields(data, field);
  if (guided.empty()) {
    throw InputError(file.string(), "", "",
                     fmt::format("none of {} partfields has guidance lines (GPN of type AB, curve "
                                 "or spiral) that reach into the field '{}'",
                                 data.partfields.size(), field.name));
  }
  GivenTrack track;
  track.counted = "point";
  track.degrees = true;
  std::size_t number = 0;
  for (const Partfield& partfield : guided) {
    // Passes laid out one by one are the plan; a line to be repeated beside them is a reference.
    const bool laid_out = std::ranges::any_of(
        partfield.guidance,
        [](const GuidancePattern& pattern) { return is_line(pattern) && !pattern.repeats; });
    for (const GuidancePattern& pattern : partfield.guidance) {
      if (!is_line(pattern) || (laid_out && pattern.repeats)) continue;
      bool joined = false;
      for (const Eigen::Vector2d& lon_lat_deg : pattern.line.lon_lat_deg) {
        track.points.push_back({lon_lat_deg, joined, false, true, ++number});
        joined = true;
      }
    }
  }
  return track;
}

}  // namespace headland

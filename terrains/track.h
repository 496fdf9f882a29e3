// A track driven or planned by another tool.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "terrains/field.h"

namespace headland {

// Intervals in a log much longer than usual, and how they were read.
struct TrackPauses {
  int count = 0;
  int breaks = 0;                   // of them: the place jumped or the heading turned
  double longest_interval_s = 0.0;  // that is no pause
  double longest_step_m = 0.0;      // that is no jump
};

// Points p_W [m] in the order driven; the implement works along them, or the vehicle's reference
// point does (`of_vehicle`), with the implement down. `break_before` holds, ascending, the indices
// of points that are not joined to their predecessor: there the implement was up, or the log breaks
// off.
struct Track {
  std::vector<Eigen::Vector2d> points_W;
  std::vector<std::size_t> break_before;
  TrackPauses pauses;
  bool of_vehicle = false;
};

// Reads the lines of a vector file that GDAL reads (GeoJSON, GPKG, GPX...), the guidance lines of
// ISO 11783-10 task data, or a CSV whose header names x and y in metres of W or longitude and
// latitude; docs/paths.md has all names. Optional: a time (CSV), and as a column or a property of
// the line whether the implement is down and whose way it is (`reference`); what is up is left out
// and breaks the track. An interval of more than kLogGapFactor times the median, forwards
// or back, is a pause. It breaks the track where the step across it is longer than kLogGapFactor
// times the median step or the heading turns by more than kPauseTurn_rad; otherwise work goes on.
// Neighbours at the same place are merged, and a point alone between two breaks is left out. For a
// field with no place on the earth, GeoJSON coordinates are taken as metres of W.
// Throws InputError with the line: missing file, no usable header, a field that is not a number,
// fewer than two points, none with the implement down, degrees for metres or where the field has no
// place on the earth, a point further than kMaxMargin_m from the field's bounding box, a jump of
// more than kMaxJump_m between neighbours (names both lines).
Track read_track(const std::filesystem::path& file, const Field& field);

// A stretch of a path as its file draws it, nothing merged, smoothed or left out.
struct PathLine {
  std::vector<Eigen::Vector2d> points_W;  // at least one
  bool implement_down = true;
  bool joined = false;  // its first point is the last one of the line before it
};

// The same files as lines: where the implement goes up or down a new line begins at the last point
// of the one before. Pauses and jumps are left as they are. Throws InputError as read_track does,
// also for what is driven with the implement up, but for no jump. A note tells of a file that says
// its points are the implement's way, as lines are read as the vehicle's.
std::vector<PathLine> read_path_lines(const std::filesystem::path& file, const Field& field,
                                      std::vector<std::string>* notes = nullptr);

inline constexpr double kLogGapFactor = 3.0;
inline constexpr double kPauseTurn_rad = 0.5235987755982988;  // 30 deg
inline constexpr double kMaxJump_m = 2000.0;

}  // namespace headland

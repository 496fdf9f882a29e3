// Whether a path that was read from a file can be driven at all.
#pragma once

#include <filesystem>

#include "planner/path.h"
#include "terrains/field.h"

namespace headland {

// Throws InputError (file, "feature N, point M", value, what is allowed) unless all numbers are
// finite, every point is within kMaxMargin_m of the field's bounding box, every segment has a
// length and begins where the one before it ends, and headings and curvatures agree with the
// points. Features are counted as path_geojson writes them: segments first.
void check_path(const Path& path, const Field& field, const std::filesystem::path& file);

// Between neighbouring points the mean heading may differ by this from the line through them, and
// the turn by this from what the curvatures make of the distance, in one step or summed over a
// segment.
inline constexpr double kHeadingTolerance_rad = 0.5;
// Larger numbers are no angle or no curve of a vehicle.
inline constexpr double kMaxHeading_rad = 100.0;
inline constexpr double kMaxCurvature_per_m = 10.0;
// Segments this far apart are not joined.
inline constexpr double kMaxSegmentGap_m = 0.05;

}  // namespace headland

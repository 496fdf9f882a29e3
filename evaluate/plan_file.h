// plan.geojson and path.geojson: a plan and a path on disk. Columns and properties: docs/results.md
#pragma once

#include <filesystem>
#include <string>

#include "planner/path.h"
#include "planner/plan.h"
#include "terrains/field.h"

namespace headland {

// A LineString a pass with kind, order and length.
std::string plan_geojson(const Plan& plan, const GeoFrame& frame);

// A LineString a segment with kind, gear, implement, manoeuvre, length, and heading and curvature
// at every point; a Point a violation. Read back, points are within 0.1 mm and headings and
// curvatures within 1e-9 of what was written.
std::string path_geojson(const Path& path, const GeoFrame& frame);

// Whether the file is a path as path_geojson or path_csv (path_export.h) writes it, good or
// damaged: a FeatureCollection with headings, a table with columns of headings and segments. Throws
// InputError as parse_json does for a file named .json or .geojson and as read_csv for .csv; what
// is named otherwise is none.
bool is_path_file(const std::filesystem::path& file);

// Throws InputError naming the feature or line for anything that does not make a path in this
// field: an unknown kind or gear, headings or curvatures that are not one a point, no segment at
// all, and what check_path refuses.
Path read_path(const std::filesystem::path& file, const Field& field);

}  // namespace headland

// A path as a table: a row a point. Columns: docs/export.md.
#pragma once

#include <filesystem>
#include <string>

#include "planner/path.h"
#include "terrains/geo_frame.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Places in metres of W and, when it is georeferenced, in degrees; headings, curvatures, gears,
// implement, kinds, segments; and the speed that make_route allows. Read back, points are within
// 0.1 mm and headings and curvatures within 1e-9 of what was written. Throws InputError as
// make_route.
std::string path_csv(const Path& path, const Vehicle& vehicle, const GeoFrame& frame);

// Whether the file is a table (.csv) with columns of headings, curvatures and segments. Throws
// InputError as read_csv.
bool is_path_csv(const std::filesystem::path& file);

// The path back, its speeds aside. Segments count up from 0. Throws InputError with the line: a
// column that is missing, a cell that is no number or unknown word, segments that do not count up,
// a kind or gear that changes within one, longitude and latitude out of range.
Path read_path_csv(const std::filesystem::path& file, const GeoFrame& frame);

}  // namespace headland

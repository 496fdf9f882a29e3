// Paths written for machines, terminals and other programs. docs/export.md.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "planner/path.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

enum class ExportFormat { kGeoJson, kKml, kGpx, kCsv, kIsoxml };
inline constexpr std::array kEveryExportFormat = {ExportFormat::kGeoJson, ExportFormat::kKml,
                                                  ExportFormat::kGpx, ExportFormat::kCsv,
                                                  ExportFormat::kIsoxml};
std::string_view export_format_name(ExportFormat format);
// Whether it has longitudes and latitudes and nothing else.
bool needs_place_on_earth(ExportFormat format);

// Nothing is owned. The field's frame decides the coordinates.
struct PathExport {
  const Path& path;
  const Field& field;
  const Vehicle& vehicle;
  std::string version;  // of the program
};

// The path as a file's text. Lines are the way of the vehicle's reference point, in ISOXML the
// implement's. Written coordinates are rounded by at most 0.1 mm. Throws InputError for a field
// without a place on the earth where needs_place_on_earth, and as make_route for CSV.
std::string export_text(const PathExport& made, ExportFormat format);

// KML or GPX by GDAL: a line a segment with name, kind, gear, implement, manoeuvre, length_m and
// reference; KML also has the field's outline.
std::string path_layers(const PathExport& made, ExportFormat format);

// ISO 11783-10: the field as a partfield with its holes and obstacles; of the passes one guidance
// pattern each in their order, AB lines and curves, not repeated; before them an AB line to repeat
// for every direction of swaths. Curves are simplified within kGuidanceRounding_m.
std::string path_task_data(const PathExport& made);

inline constexpr double kGuidanceRounding_m = 0.01;

}  // namespace headland

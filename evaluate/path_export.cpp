#include "evaluate/path_export.h"

#include <fmt/format.h>

#include "evaluate/path_csv.h"
#include "evaluate/plan_file.h"
#include "terrains/input_error.h"

namespace headland {

std::string_view export_format_name(ExportFormat format) {
  switch (format) {
    case ExportFormat::kGeoJson:
      return "geojson";
    case ExportFormat::kKml:
      return "kml";
    case ExportFormat::kGpx:
      return "gpx";
    case ExportFormat::kCsv:
      return "csv";
    case ExportFormat::kIsoxml:
      return "isoxml";
  }
  return "";
}

bool needs_place_on_earth(ExportFormat format) {
  return format != ExportFormat::kGeoJson && format != ExportFormat::kCsv;
}

std::string export_text(const PathExport& made, ExportFormat format) {
  if (needs_place_on_earth(format) && !made.field.frame.georeferenced) {
    throw InputError(made.field.name, "", std::string(export_format_name(format)),
                     "is in longitude and latitude, and the field has no place on the earth; give "
                     "the place of its x 0, y 0 with --origin LON,LAT, or the CRS of its "
                     "coordinates as field.crs");
  }
  switch (format) {
    case ExportFormat::kGeoJson:
      return path_geojson(made.path, made.field.frame);
    case ExportFormat::kCsv:
      return path_csv(made.path, made.vehicle, made.field.frame);
    case ExportFormat::kIsoxml:
      return path_task_data(made);
    default:
      return path_layers(made, format);
  }
}

}  // namespace headland

// Fields as files give them, before one is chosen and brought into frame W.
#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrains/field_source.h"

namespace headland {

// One polygon, x,y in `crs`; no crs means metres with no place on the earth.
struct GivenPolygon {
  std::string name;
  std::vector<std::string> other_names;  // under which it may be asked for as well
  std::string crs;
  Ring boundary;
  std::vector<Ring> holes;
  std::vector<ObstacleSource> obstacles;  // of task data, likewise in `crs`
};

// All polygons of the layer that `field` names, else of the first layer with any. Throws
// InputError: no such layer, no polygon.
std::vector<GivenPolygon> polygons_of(GDALDataset& dataset, const FieldSource& field);

// The partfields of ISO 11783-10 task data that have a boundary. Rings are holes when they are
// marked as interior or lie inside another ring of their polygon; water, buildings, obstacles and
// windbreaks (PLN) inside the boundary are holes too, obstacle points and lines and fences
// obstacles. Throws InputError as read_task_data, and when no partfield has a boundary.
std::vector<GivenPolygon> polygons_of_task_data(const std::filesystem::path& file);

// The one that field.part names, or the only one. Throws InputError: several and none named, no
// such name (says the nearest), a name that several have.
GivenPolygon chosen_polygon(std::vector<GivenPolygon> polygons, const FieldSource& field);

// In W when the polygon has a CRS: in `frame` if given, else with the origin at the middle of its
// boundary. Nothing is checked but the CRS and its domain.
Field placed(const GivenPolygon& given, const std::string& source,
             const std::optional<GeoFrame>& frame = std::nullopt);

}  // namespace headland

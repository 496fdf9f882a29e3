// Vector files made by GDAL's own drivers, for the readers to read back.
#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <string>
#include <vector>

#include "terrains/field.h"

namespace headland {

inline OGRLinearRing closed_line(const Ring& ring) {
  OGRLinearRing line;
  for (const Eigen::Vector2d& point : ring) line.addPoint(point.x(), point.y());
  line.closeRings();
  return line;
}

// Rings: the boundary first, then holes.
inline OGRPolygon polygon_of(const std::vector<Ring>& rings) {
  OGRPolygon polygon;
  for (const Ring& ring : rings) {
    OGRLinearRing line = closed_line(ring);
    polygon.addRing(&line);
  }
  return polygon;
}

// One layer of features named by their numbers from 1. An empty crs leaves the layer without one.
inline void write_features(const std::filesystem::path& file, const std::string& driver,
                           const std::string& crs,
                           const std::vector<const OGRGeometry*>& geometries,
                           const std::string& layer_name = "fields") {
  GDALAllRegister();
  GDALDatasetUniquePtr dataset(GetGDALDriverManager()
                                   ->GetDriverByName(driver.c_str())
                                   ->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRSpatialReference reference;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!crs.empty()) reference.SetFromUserInput(crs.c_str());
  OGRLayer* layer = dataset->CreateLayer(layer_name.c_str(), crs.empty() ? nullptr : &reference,
                                         wkbUnknown, nullptr);
  OGRFieldDefn name("Name", OFTString);
  layer->CreateField(&name);
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("Name", ("field " + std::to_string(i + 1)).c_str());
    feature.SetGeometry(geometries[i]);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) throw std::runtime_error(driver);
  }
}

}  // namespace headland

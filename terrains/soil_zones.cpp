#include "terrains/soil_zones.h"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/vector_file.h"

namespace headland {
namespace {

struct Zone {
  std::unique_ptr<OGRGeometry> shape_W;
  std::uint16_t soil = 0;
};

// Later zones over earlier ones.
void burn(const std::vector<Zone>& zones, const SoilMap& grid, std::vector<std::uint16_t>& cells) {
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const GDALDatasetUniquePtr raster(
      memory->Create("", grid.columns, grid.rows, 0, GDT_UInt16, nullptr));
  CPLStringList band;
  band.SetNameValue("DATAPOINTER", fmt::format("{}", static_cast<void*>(cells.data())).c_str());
  raster->AddBand(GDT_UInt16, band.List());
  // Rows count northwards, as the map's do.
  double geotransform[6] = {grid.origin_W.x(), grid.cell_m, 0.0,
                            grid.origin_W.y(), 0.0,         grid.cell_m};
  raster->SetGeoTransform(geotransform);
  std::vector<OGRGeometryH> shapes;
  std::vector<double> values;
  for (const Zone& zone : zones) {
    shapes.push_back(OGRGeometry::ToHandle(zone.shape_W.get()));
    values.push_back(zone.soil);
  }
  int first_band = 1;
  GDALRasterizeGeometries(GDALDataset::ToHandle(raster.get()), 1, &first_band,
                          static_cast<int>(shapes.size()), shapes.data(), nullptr, nullptr,
                          values.data(), nullptr, nullptr, nullptr);
  raster->FlushCache(false);
}

bool is_polygon(const OGRGeometry& geometry) {
  return OGR_GT_IsSurface(geometry.getGeometryType()) ||
         OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbMultiSurface);
}

bool has_polygons(OGRLayer& layer) {
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry != nullptr && is_polygon(*geometry)) return true;
  }
  return false;
}

OGRLayer& zones_layer(GDALDataset& dataset, const SoilSource& source) {
  const std::string file = source.file.string();
  std::vector<std::string> names;
  for (OGRLayer* layer : dataset.GetLayers()) names.emplace_back(layer->GetName());
  if (!source.layer.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(source.layer.c_str())) return *layer;
    throw InputError(file, "layer", source.layer,
                     fmt::format("no such layer; it has {}", fmt::join(names, ", ")));
  }
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (has_polygons(*layer)) return *layer;
  }
  throw InputError(file, "", "", "holds no polygon; the zones of a soil map are polygons");
}

// The text of the first of these properties that is set.
std::optional<std::string> property(const OGRFeature& feature,
                                    std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const int index = feature.GetFieldIndex(name);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index)) continue;
    return const_cast<OGRFeature&>(feature).GetFieldAsString(index);
  }
  return std::nullopt;
}

bool is_truth_value(const OGRFeature& feature, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const int index = feature.GetFieldIndex(name);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index)) continue;
    return const_cast<OGRFeature&>(feature).GetFieldDefnRef(index)->GetSubType() == OFSTBoolean;
  }
  return false;
}

Soil soil_of(const OGRFeature& feature, const std::string& file, const std::string& where) {
  const auto name = property(feature, {"soil"});
  const auto cone_index = property(feature, {"cone_index_kpa", "cone_index"});
  if (name.has_value() == cone_index.has_value()) {
    throw InputError(file, where, "",
                     name ? "has both soil and cone_index_kpa; give one of them"
                          : "a zone needs a property soil (a known soil's name) or cone_index_kpa");
  }
  if (name) return soil_named(*name, file, where + ": soil");
  // GDAL hands true over as 1.
  if (is_truth_value(feature, {"cone_index_kpa", "cone_index"})) {
    throw InputError(file, where + ": cone_index_kpa", *cone_index == "1" ? "true" : "false",
                     "a number in kPa is needed");
  }
  char* end = nullptr;
  const double cone_index_kpa = CPLStrtod(cone_index->c_str(), &end);
  if (*end != '\0' ||
      !(cone_index_kpa >= kMinConeIndex_kpa && cone_index_kpa <= kMaxConeIndex_kpa)) {
    throw InputError(
        file, where + ": cone_index_kpa", *cone_index,
        fmt::format("a number from {} to {} kPa", kMinConeIndex_kpa, kMaxConeIndex_kpa));
  }
  return soil_of_cone_index(std::round(cone_index_kpa));
}

// The soil's place in the map's table, where 0 is the default's alone.
std::uint16_t listed(const Soil& soil, SoilMap& map) {
  const auto known = std::find_if(map.soils.begin() + 1, map.soils.end(),
                                  [&](const Soil& other) { return other.name == soil.name; });
  const auto place = known - map.soils.begin();
  if (known == map.soils.end()) map.soils.push_back(soil);
  return static_cast<std::uint16_t>(place);
}

std::string crs_of_zones(OGRLayer& layer, const SoilSource& source, const Field& field) {
  const std::string file = source.file.string();
  std::string crs = source.crs.empty() ? crs_of(layer) : source.crs;
  if (field.frame.georeferenced && crs.empty()) {
    throw InputError(file, "", "", "has no CRS; give it as soil.crs, for example EPSG:4326");
  }
  if (!field.frame.georeferenced && !crs.empty()) {
    throw InputError(file, "", "",
                     "lies on the earth but the field does not; give the crs of the field's "
                     "coordinates as field.crs");
  }
  return crs;
}

}  // namespace

void read_soil_zones(const SoilSource& source, const Field& field, SoilMap& map) {
  const std::string file = source.file.string();
  const GdalScope gdal;
  const GDALDatasetUniquePtr dataset = open_vector_file(source.file);
  OGRLayer& layer = zones_layer(*dataset, source);
  const std::string crs = crs_of_zones(layer, source, field);
  std::unique_ptr<OGRCoordinateTransformation> to_local;
  if (!crs.empty()) {
    const OGRSpatialReference from = spatial_reference(crs, file);
    const OGRSpatialReference to = spatial_reference(proj_of(field.frame), file);
    to_local.reset(OGRCreateCoordinateTransformation(&from, &to));
  }
  std::vector<Zone> zones;
  int number = 0;
  for (const auto& feature : layer) {
    const std::string where = fmt::format("feature {}", ++number);
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || !is_polygon(*geometry)) continue;
    // Arcs of curved polygons become short chords.
    Zone zone{std::unique_ptr<OGRGeometry>(geometry->getLinearGeometry()), 0};
    if (!zone.shape_W->IsValid()) {
      throw InputError(file, where, "", "its polygon crosses itself, or its rings one another");
    }
    if (!crs.empty() &&
        (to_local == nullptr || zone.shape_W->transform(to_local.get()) != OGRERR_NONE)) {
      throw InputError(file, where, "", "lies outside the domain of the CRS; is the crs right?");
    }
    zone.soil = listed(soil_of(*feature, file, where), map);
    zones.push_back(std::move(zone));
  }
  burn(zones, map, map.index);
}

std::vector<std::uint16_t> cells_in_field(const SoilMap& map, const Field& field) {
  const GdalScope gdal;
  OGRPolygon polygon;
  const auto add = [&](const Ring& ring) {
    OGRLinearRing line;
    for (const Eigen::Vector2d& p_W : ring) line.addPoint(p_W.x(), p_W.y());
    line.closeRings();
    polygon.addRing(&line);
  };
  add(field.boundary);
  for (const Ring& hole : field.holes) add(hole);
  std::vector<Zone> zones;
  zones.push_back({std::unique_ptr<OGRGeometry>(polygon.clone()), 1});
  std::vector<std::uint16_t> cells(map.index.size(), 0);
  burn(zones, map, cells);
  return cells;
}

}  // namespace headland

#include "terrains/vector_file.h"

#include <ogrsf_frmts.h>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
GDALDatasetUniquePtr open_vector_file(const std::filesystem::path& file) {
  require_file_or_folder(file);
  const std::string extension = file.extension().string();
  // GDAL only says that a GeoJSON is broken, not where.
  if (extension == ".geojson" || extension == ".json") static_cast<void>(parse_json(file));
  const GdalScope gdal;
  GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (dataset == nullptr) {
    throw InputError(file.string(), "", "",
                     "not a vector file that GDAL reads (GeoJSON, GPKG, shapefile, KML, GML...)" +
                         (gdal.complaint().empty() ? "" : ": " + gdal.complaint()));
  }
  return dataset;
}

std::string crs_of(const OGRLayer& layer) {
  // GDAL's reading calls are not const-correct.
  const OGRSpatialReference* reference = const_cast<OGRLayer&>(layer).GetSpatialRef();
  if (reference == nullptr || reference->IsLocal()) return "";
  char* wkt = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  reference->exportToWkt(&wkt, options);
  std::string text = wkt == nullptr ? "" : wkt;
  CPLFree(wkt);
  return text;
}

}  // namespace headland

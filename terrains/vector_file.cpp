#include "terrains/vector_file.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// GDAL only says that a GeoJSON is broken, not where.
void require_json(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  try {
    const auto parsed = nlohmann::json::parse(text);
    static_cast<void>(parsed);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto newlines = std::count(text.begin(), text.begin() + static_cast<long>(end), '\n');
    throw InputError(file.string(), fmt::format("line {}", newlines + 1), "",
                     "malformed JSON (character " + std::to_string(error.byte) + ")");
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string(), "", "", std::string("malformed JSON: ") + error.what());
  }
}

}  // namespace

GDALDatasetUniquePtr open_vector_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw InputError(file.string(), "", "", "no such file");
  if (std::filesystem::is_regular_file(file) && !std::ifstream(file).good()) {
    throw InputError(file.string(), "", "", "cannot be read; check its permissions");
  }
  const std::string extension = file.extension().string();
  if (extension == ".geojson" || extension == ".json") require_json(file);
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

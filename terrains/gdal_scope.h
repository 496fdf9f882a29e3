// GDAL as the readers of this folder use it: drivers registered, messages kept instead of printed.
#pragma once

#include <ogr_spatialref.h>

#include <string>

namespace headland {

// While it lives, what GDAL and PROJ complain about in this thread is kept here, not printed.
class GdalScope {
 public:
  GdalScope();
  ~GdalScope();
  GdalScope(const GdalScope&) = delete;
  GdalScope& operator=(const GdalScope&) = delete;

  // The first failure so far; empty when there was none.
  const std::string& complaint() const { return complaint_; }

 private:
  std::string complaint_;
};

// A CRS from "EPSG:32615", WKT or a PROJ string, with x east or longitude first whatever its
// authority says. Throws InputError naming `source` when GDAL does not know it.
OGRSpatialReference spatial_reference(const std::string& crs, const std::string& source);

}  // namespace headland

#include "terrains/gdal_scope.h"

#include <cpl_error.h>
#include <gdal.h>

#include <mutex>

#include "terrains/input_error.h"

namespace headland {
namespace {

void keep_first(CPLErr level, CPLErrorNum, const char* message) {
  auto* complaint = static_cast<std::string*>(CPLGetErrorHandlerUserData());
  if (level >= CE_Failure && complaint->empty()) *complaint = message;
}

}  // namespace

GdalScope::GdalScope() {
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
  CPLPushErrorHandlerEx(keep_first, &complaint_);
}

GdalScope::~GdalScope() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

OGRSpatialReference spatial_reference(const std::string& crs, const std::string& source) {
  const GdalScope gdal;
  OGRSpatialReference reference;
  if (reference.SetFromUserInput(
          crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE) {
    throw InputError(source, "crs", crs.substr(0, 80),
                     "unknown CRS; give an authority code such as EPSG:32615, WKT or PROJ");
  }
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

}  // namespace headland

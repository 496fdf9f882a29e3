// Rasters made by GDAL's own drivers, for the reader to read back.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace headland {

inline constexpr double kNoData = -9999.0;

// A raster of `pixels` squared, its south-west corner at (left, bottom), heights of the pixels'
// middles from a function of x and y.
struct Raster {
  std::string driver = "GTiff";
  std::string crs = "EPSG:32615";
  int pixels = 100;
  double pixel_size = 5.0;
  double left = 499850.0;
  double bottom = 4859850.0;
  std::function<double(double, double)> height;
  bool declare_nodata = true;
  std::string unit;
  std::optional<double> scale;
  std::optional<double> offset;
  GDALDataType type = GDT_Float64;
};

inline void write(const Raster& raster, const std::filesystem::path& file) {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const bool direct = raster.driver == "GTiff";
  GDALDatasetUniquePtr dataset(drivers.GetDriverByName(direct ? "GTiff" : "MEM")
                                   ->Create(direct ? file.c_str() : "", raster.pixels,
                                            raster.pixels, 1, raster.type, nullptr));
  double geotransform[6] = {raster.left, raster.pixel_size,
                            0.0,         raster.bottom + raster.pixels * raster.pixel_size,
                            0.0,         -raster.pixel_size};
  dataset->SetGeoTransform(geotransform);
  if (!raster.crs.empty()) {
    OGRSpatialReference reference;
    reference.SetFromUserInput(raster.crs.c_str());
    dataset->SetSpatialRef(&reference);
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (raster.declare_nodata) band.SetNoDataValue(kNoData);
  if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
  if (raster.scale.has_value()) band.SetScale(*raster.scale);
  if (raster.offset.has_value()) band.SetOffset(*raster.offset);
  std::vector<double> row(static_cast<std::size_t>(raster.pixels));
  for (int j = 0; j < raster.pixels; ++j) {
    for (int i = 0; i < raster.pixels; ++i) {
      row[static_cast<std::size_t>(i)] =
          raster.height(raster.left + (i + 0.5) * raster.pixel_size,
                        geotransform[3] - (j + 0.5) * raster.pixel_size);
    }
    ASSERT_EQ(band.RasterIO(GF_Write, 0, j, raster.pixels, 1, row.data(), raster.pixels, 1,
                            GDT_Float64, 0, 0, nullptr),
              CE_None);
  }
  if (!direct) {
    const GDALDatasetUniquePtr copy(
        drivers.GetDriverByName(raster.driver.c_str())
            ->CreateCopy(file.c_str(), dataset.get(), 0, nullptr, nullptr, nullptr));
    ASSERT_NE(copy, nullptr);
  }
}

}  // namespace headland

// Soils of a map's cells from a raster of cone indices.
#pragma once

#include <cstdint>
#include <vector>

#include "terrains/field.h"
#include "terrains/soil_map.h"
#include "terrains/soil_source.h"

namespace headland {

// Side of the raster's pixel [m] at the middle of the field. Throws as read_soil does.
double soil_raster_cell_m(const SoilSource& source, const Field& field);

// Sets the cells of `map`, whose grid is given and whose soils hold the default, and adds a soil
// for every cone index, rounded to 1 kPa. Numbers are judged where `in_field` is 1; where there are
// none, the default stays. Throws as read_soil does.
void read_soil_raster(const SoilSource& source, const Field& field,
                      const std::vector<std::uint16_t>& in_field, SoilMap& map);

}  // namespace headland

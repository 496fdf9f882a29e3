// Soils of a map's cells from the polygons of a vector file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "terrains/field.h"
#include "terrains/soil_map.h"
#include "terrains/soil_source.h"

namespace headland {

// Sets the cells of `map`, whose grid is given and whose soils hold the default, and adds the
// zones' soils. Throws as read_soil does.
void read_soil_zones(const SoilSource& source, const Field& field, SoilMap& map);

// The cells of the map's grid whose middle lies in the field are 1, the others 0.
std::vector<std::uint16_t> cells_in_field(const SoilMap& map, const Field& field);

}  // namespace headland

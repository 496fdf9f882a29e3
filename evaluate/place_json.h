// Places in JSON files.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "terrains/geo_frame.h"

namespace headland {

// x_m and y_m of W and, when the frame is georeferenced, longitude_deg and latitude_deg.
void add_place(nlohmann::ordered_json& json, const GeoFrame& frame, const Eigen::Vector2d& p_W);

}  // namespace headland

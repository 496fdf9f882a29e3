#include "evaluate/place_json.h"

#include "evaluate/geojson.h"

namespace headland {

void add_place(nlohmann::ordered_json& json, const GeoFrame& frame, const Eigen::Vector2d& p_W) {
  json["x_m"] = rounded(p_W.x(), 3);
  json["y_m"] = rounded(p_W.y(), 3);
  if (!frame.georeferenced || !p_W.allFinite()) return;
  const Eigen::Vector2d lon_lat_deg = wgs84_from_local(frame, {p_W}).front();
  json["longitude_deg"] = rounded(lon_lat_deg.x(), 8);
  json["latitude_deg"] = rounded(lon_lat_deg.y(), 8);
}

}  // namespace headland

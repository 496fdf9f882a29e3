// Obstacles in a field's vector file.
#pragma once

#include <gdal_priv.h>

#include <string>

#include "terrains/field.h"
#include "terrains/field_source.h"

namespace headland {

// Whether the feature's property `obstacle` is set.
bool is_obstacle(const OGRFeature& feature);

// Adds an obstacle whose line is already in W: one for every straight piece of it. Throws
// InputError naming `source` and `where` when a wall or fence has fewer than two different points
// or anything else not exactly one, and as check_obstacle does.
void add_obstacle(const ObstacleSource& obstacle, const std::string& source,
                  const std::string& where, Field& field);

// Adds the obstacles among the features of all layers to a field already placed in W. Throws
// InputError naming the file and the feature.
void add_obstacle_features(GDALDataset& dataset, const FieldSource& source, Field& field);

}  // namespace headland

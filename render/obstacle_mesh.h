// Trees, poles and rocks.
#pragma once

#include "render/mesh.h"
#include "terrains/field.h"

namespace headland {

// Standing on the origin, z up, of the obstacle's height; its radius is that of the trunk, pole
// or rock.
Mesh obstacle_mesh(const Obstacle& obstacle);

}  // namespace headland

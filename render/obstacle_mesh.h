// Trees, poles and rocks, walls and fences.
#pragma once

#include "render/mesh.h"
#include "terrains/field.h"

namespace headland {

// A tree, pole or rock standing on the origin, z up, of the obstacle's height; its radius is that
// of the trunk, pole or rock.
Mesh obstacle_mesh(const Obstacle& obstacle);

// A straight piece of a wall or fence between two points of the ground, of the obstacle's height
// over each: a solid prism, or a post at either end with rails between them.
Mesh barrier_mesh(const Obstacle& obstacle, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace headland

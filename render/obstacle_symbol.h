// What stands on a field, as the maps show it.
#pragma once

#include <Eigen/Core>

#include "render/page.h"
#include "render/sheet.h"
#include "terrains/field.h"

namespace headland {

// A tree, pole or rock.
void draw_obstacle_symbol(Sheet& sheet, const Page& page, ObstacleKind kind,
                          const Eigen::Vector2d& p_px, double radius_px);

// A wall, a broad line, or a fence, a thin one with a post every now and then.
void draw_barrier_symbol(Sheet& sheet, const Page& page, ObstacleKind kind,
                         const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px,
                         double thickness_px);

}  // namespace headland

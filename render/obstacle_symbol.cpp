#include "render/obstacle_symbol.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/palette.h"

namespace headland {

using Eigen::Vector2d;

void draw_obstacle_symbol(Sheet& sheet, const Page& page, ObstacleKind kind, const Vector2d& p_px,
                          double radius_px) {
  const double line = std::max(1.0, page.px(1.4));
  switch (kind) {
    case ObstacleKind::kTree: {
      fill_disc(sheet, p_px, radius_px + line, colours::kPaper);
      fill_disc(sheet, p_px, radius_px, colours::kTree);
      fill_disc(sheet, p_px, 0.35 * radius_px, colours::kPaper);
      break;
    }
    case ObstacleKind::kPole: {
      fill_disc(sheet, p_px, radius_px + line, colours::kPaper);
      fill_disc(sheet, p_px, radius_px, colours::kInk);
      const double reach = 0.55 * radius_px;
      stroke(sheet,
             std::array{Vector2d(p_px - Vector2d(reach, reach)),
                        Vector2d(p_px + Vector2d(reach, reach))},
             line, colours::kPaper);
      stroke(sheet,
             std::array{Vector2d(p_px - Vector2d(reach, -reach)),
                        Vector2d(p_px + Vector2d(reach, -reach))},
             line, colours::kPaper);
      break;
    }
    case ObstacleKind::kRock: {
      const std::array<Vector2d, 5> corners = {
          p_px + radius_px * Vector2d(-1.0, 0.7), p_px + radius_px * Vector2d(-0.6, -0.5),
          p_px + radius_px * Vector2d(0.2, -0.9), p_px + radius_px * Vector2d(0.9, -0.1),
          p_px + radius_px * Vector2d(1.0, 0.7)};
      stroke(sheet, corners, 2.0 * line, colours::kPaper, true);
      fill_convex(sheet, corners, colours::kRock);
      stroke(sheet, corners, line, colours::kInk, true);
      break;
    }
    case ObstacleKind::kWall:
    case ObstacleKind::kFence:
      break;
  }
}

void draw_barrier_symbol(Sheet& sheet, const Page& page, ObstacleKind kind, const Vector2d& from_px,
                         const Vector2d& to_px, double thickness_px) {
  const std::array<Vector2d, 2> line = {from_px, to_px};
  const double paper = std::max(2.0, page.px(2.4));
  if (kind == ObstacleKind::kWall) {
    const double width = std::max(page.px(4.5), thickness_px);
    stroke(sheet, line, width + paper, colours::kPaper);
    stroke(sheet, line, width, colours::kInkSoft);
    return;
  }
  const double width = std::max(page.px(1.8), thickness_px);
  stroke(sheet, line, width + paper, colours::kPaper);
  stroke(sheet, line, width, colours::kInk);
  const int spans =
      std::max(1, static_cast<int>(std::lround((to_px - from_px).norm() / page.px(13))));
  for (int i = 0; i <= spans; ++i) {
    fill_disc(sheet, from_px + i * (to_px - from_px) / spans, 1.5 * width, colours::kInk);
  }
}

}  // namespace headland

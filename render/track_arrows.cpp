#include "render/track_arrows.h"

#include <algorithm>
#include <array>

namespace headland {
namespace {

// Longer than any picture's diagonal.
constexpr double kLongestStep_px = 20000.0;

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

void draw_head(Sheet& sheet, const Point3& middle, const Point2& ahead, const ArrowLook& look) {
  const auto head = [&](double size, Rgba colour) {
    const Point2 side(-ahead.y(), ahead.x());
    const auto corner = [&](double along, double aside) {
      const Point2 p = middle.head<2>() + size * (along * ahead + aside * side);
      return Eigen::Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()),
                             static_cast<float>(middle.z()));
    };
    for (const double aside : {0.5, -0.5}) {
      for (const Eigen::Vector3f& p :
           std::array{corner(0.6, 0.0), corner(-0.4, aside), corner(-0.2, 0.0)}) {
        sheet.vertices.push_back({p, Eigen::Vector2f(0.5F, 0.5F), colour});
      }
    }
  };
  head(1.35 * look.size_px, look.rim);
  head(look.size_px, look.colour);
}

}  // namespace

void draw_arrows(Sheet& sheet, std::span<const Point3> line_px, const ArrowLook& look) {
  double left_px = 0.5 * look.spacing_px;
  for (std::size_t i = 1; i < line_px.size(); ++i) {
    const Point3 step = line_px[i] - line_px[i - 1];
    const double length = step.head<2>().norm();
    if (!(length > 0.0)) continue;
    // From one place of a damaged record to another far off no way leads.
    if (length > kLongestStep_px) continue;
    for (; left_px <= length; left_px += look.spacing_px) {
      draw_head(sheet, line_px[i - 1] + step * (left_px / length), step.head<2>() / length, look);
    }
    left_px -= length;
  }
}

}  // namespace headland

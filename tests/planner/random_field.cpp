#include "tests/planner/random_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "planner/arcs.h"
#include "terrains/field_source.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int count(int low, int high) { return static_cast<int>(number(low, high + 1.0)); }
  bool chance(double probability) { return number(0.0, 1.0) < probability; }

 private:
  std::mt19937_64 engine_;
};

// Seen whole from its centre; `jag` 0: nearly an ellipse, 1: with deep bays.
Ring star(Draw& draw, const Eigen::Vector2d& centre_W, double radius_m, int corners, double jag) {
  const double turn_rad = draw.number(0.0, 2.0 * std::numbers::pi);
  const double flat = draw.number(0.4, 1.0);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * (i + draw.number(-0.3, 0.3)) / corners;
    const double at_m = radius_m * draw.number(1.0 - 0.7 * jag, 1.0);
    ring.emplace_back(centre_W + at_m * std::cos(angle_rad) * direction_of(turn_rad) +
                      flat * at_m * std::sin(angle_rad) * left_of(turn_rad));
  }
  return ring;
}

}  // namespace

Field random_field(std::uint64_t seed) {
  Draw draw(seed);
  const double area_m2 = 1e3 * std::pow(200.0, draw.number(0.0, 1.0));
  const int corners = draw.count(3, 14);
  const double jag = draw.chance(0.4) ? 0.0 : draw.number(0.0, 0.9);
  Field field = field_of("random", star(draw, {0.0, 0.0}, 100.0, corners, jag));
  const double scale = std::sqrt(area_m2 / std::abs(signed_area_m2(field.boundary)));
  for (Eigen::Vector2d& p_W : field.boundary) p_W *= scale;
  const double extent_m = 1.2 * std::sqrt(area_m2);
  const auto place = [&] {
    return Eigen::Vector2d(draw.number(-extent_m, extent_m), draw.number(-extent_m, extent_m));
  };
  const int holes = draw.chance(0.4) ? 0 : draw.count(1, 8);
  for (int i = 0; i < 20 * holes && static_cast<int>(field.holes.size()) < holes; ++i) {
    const double radius_m = draw.number(0.5, std::min(20.0, 0.15 * extent_m));
    const Eigen::Vector2d centre_W = place();
    if (field_clearance_m(field, centre_W) < radius_m + 0.5) continue;
    field.holes.push_back(star(draw, centre_W, radius_m, draw.count(3, 9), 0.4));
  }
  const int trees = draw.chance(0.6) ? 0 : draw.count(1, 6);
  for (int i = 0; i < 20 * trees && static_cast<int>(field.obstacles.size()) < trees; ++i) {
    const Eigen::Vector2d p_W = place();
    if (field_clearance_m(field, p_W) < 0.5) continue;
    field.obstacles.push_back({ObstacleKind::kTree, p_W, draw.number(0.1, 0.8), 5.0});
  }
  check_field(field, "random");
  return field;
}

}  // namespace headland

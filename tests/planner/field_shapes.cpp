#include "tests/planner/field_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/planners.h"

namespace headland {

Ring rectangle_ring(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring regular_ring(const Eigen::Vector2d& centre_W, double radius_m, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / corners;
    ring.emplace_back(centre_W +
                      radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return ring;
}

Field field_of(const std::string& name, Ring boundary) {
  Field field;
  field.name = name;
  field.boundary = std::move(boundary);
  return field;
}

std::vector<Field> field_shapes() {
  std::vector<Field> fields;
  fields.push_back(field_of("square", rectangle_ring(0, 0, 150, 150)));
  fields.push_back(moved(field_of("rotated_rectangle", rectangle_ring(0, 0, 220, 90)), 0.5,
                         Eigen::Vector2d(40, -25)));
  fields.push_back(
      field_of("l_shape", {{0, 0}, {200, 0}, {200, 90}, {90, 90}, {90, 180}, {0, 180}}));
  fields.push_back(field_of("triangle", {{0, 0}, {230, 20}, {60, 190}}));
  fields.push_back(field_of("one_hole", rectangle_ring(0, 0, 190, 160)));
  fields.back().holes = {reversed(rectangle_ring(80, 60, 110, 95))};
  fields.push_back(field_of("two_holes", {{0, 0}, {260, 10}, {240, 170}, {10, 150}}));
  fields.back().holes = {reversed(regular_ring({80, 80}, 15, 24)),
                         {{160, 70}, {170, 110}, {195, 85}}};
  fields.push_back(field_of("trees", rectangle_ring(0, 0, 180, 140)));
  fields.back().obstacles = {{ObstacleKind::kTree, {60, 70}, 0.4, 8.0},
                             {ObstacleKind::kPole, {125, 62}, 0.2, 9.0}};
  fields.push_back(field_of("walls", rectangle_ring(0, 0, 180, 140)));
  fields.back().obstacles = {{ObstacleKind::kWall, {50, 60}, 0.2, 1.5, {40, 10}},
                             {ObstacleKind::kWall, {90, 70}, 0.2, 1.5, {-5, 25}},
                             {ObstacleKind::kFence, {0, -1}, 0.05, 1.2, {180, 0}}};
  fields.push_back(field_of("thin", rectangle_ring(0, 0, 240, 24)));
  return fields;
}

Field moved(const Field& field, double angle_rad, const Eigen::Vector2d& shift) {
  const Eigen::Rotation2Dd rotation(angle_rad);
  const auto move = [&](Eigen::Vector2d& p_W) { p_W = rotation * p_W + shift; };
  Field result = field;
  std::ranges::for_each(result.boundary, move);
  for (Ring& hole : result.holes) std::ranges::for_each(hole, move);
  for (Obstacle& obstacle : result.obstacles) {
    move(obstacle.p_W);
    obstacle.run_W = rotation * obstacle.run_W;
  }
  if (result.entry_W) move(*result.entry_W);
  return result;
}

PlanRequest tractor_request(const Field& field, const std::string& planner) {
  PlanRequest request;
  request.field = field;
  request.working_width_m = 9.0;
  request.turning_radius_m = 5.0;
  request.vehicle_width_m = 2.2;
  request.vehicle_front_m = 3.2;
  request.vehicle_rear_m = 1.6;
  request.parameters =
      resolve_parameters(find_planner(planner, "test").parameters, {}, "test", "planner");
  return request;
}

PlanRequest transplanter_request(const Field& field, const std::string& planner) {
  PlanRequest request = tractor_request(field, planner);
  request.working_width_m = 2.0;
  request.turning_radius_m = 2.6;
  request.vehicle_width_m = 1.2;
  request.vehicle_front_m = 2.3;
  request.vehicle_rear_m = 0.9;
  return request;
}

}  // namespace headland

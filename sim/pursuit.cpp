#include "sim/pursuit.h"

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"

namespace headland {
namespace {

constexpr double kLearningSpeed_mps = 0.3;
constexpr double kMaxSideslip_rad = 0.2;
constexpr double kMaxSteerBias_rad = 0.1;

// A place ahead as seen from a pose: along its heading and to the left of it.
Eigen::Vector2d seen_from(const Eigen::Vector2d& p_W, double heading_rad,
                          const Eigen::Vector2d& target_W) {
  const Eigen::Vector2d to_target = target_W - p_W;
  const Eigen::Vector2d ahead = direction_of(heading_rad);
  return {ahead.dot(to_target), ahead.x() * to_target.y() - ahead.y() * to_target.x()};
}

double pursuit_curvature_per_m(const Eigen::Vector2d& target) {
  return 2.0 * target.y() / target.squaredNorm();
}

}  // namespace

void learn_bias(const Vehicle& vehicle, const DriverView& view, double steer_rad, double dt_s,
                SteeringBias& bias) {
  if (std::abs(view.course_mps.x()) < kLearningSpeed_mps) return;
  const auto approach = [dt_s](double& value, double seen, double time_s, double limit) {
    value = std::clamp(value + dt_s / (time_s + dt_s) * (seen - value), -limit, limit);
  };
  approach(bias.sideslip_rad, std::atan(view.course_mps.y() / view.course_mps.x()), kSideslipTime_s,
           kMaxSideslip_rad);
  // The yaw rate of skid steering is held as asked: nothing is left to learn.
  if (vehicle.steering.kind == SteeringKind::kSkid) return;
  const double driven_rad = steer_for(vehicle, view.yaw_rate_rad_per_s / view.course_mps.x());
  approach(bias.steer_rad, steer_rad - driven_rad, kSteerBiasTime_s, kMaxSteerBias_rad);
}

Eigen::Vector2d position_now(const DriverView& view) {
  if (view.age_s == 0.0) return view.p_W;
  return view.p_W + view.age_s * (view.course_mps.x() * direction_of(view.yaw_rad) +
                                  view.course_mps.y() * left_of(view.yaw_rad));
}

double steer_along(const Route& route, const RoutePlace& place, const Vehicle& vehicle,
                   const DriverView& view, const SteeringBias& bias, double preview_m) {
  const Driver& driver = vehicle.driver;
  const auto ahead = [&](double distance_m) {
    RoutePlace moved = place;
    moved.along_m += distance_m;
    return pose_at(route, moved);
  };
  const RoutePose here = ahead(0.0);
  const Eigen::Vector2d target_W =
      ahead(driver.look_ahead_m + driver.look_ahead_time_s * std::abs(view.speed_mps)).p_W;
  const Eigen::Vector2d target =
      seen_from(position_now(view), view.yaw_rad + bias.sideslip_rad, target_W);
  const double limit_rad = vehicle.steering.max_angle_rad;
  const bool forward = route.runs[place.run].gear == Gear::kForward;
  if (forward ? target.x() <= 0.0 : target.x() >= 0.0) {
    return target.y() >= 0.0 ? limit_rad : -limit_rad;
  }
  const double curvature_per_m =
      ahead(preview_m).curvature_per_m + pursuit_curvature_per_m(target) -
      pursuit_curvature_per_m(seen_from(here.p_W, here.heading_rad, target_W));
  return std::clamp(steer_for(vehicle, curvature_per_m) + bias.steer_rad, -limit_rad, limit_rad);
}

}  // namespace headland

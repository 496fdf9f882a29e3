// Steering along a route: pure pursuit with curvature feed-forward, free of slope bias.
#pragma once

#include <Eigen/Core>

#include "sim/route.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Motion of B's origin as the driver's sensors give it.
struct DriverView {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double age_s = 0.0;  // of p_W; all else is of now
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;  // nose up positive
  double roll_rad = 0.0;   // right side down positive
  double yaw_rate_rad_per_s = 0.0;
  double speed_mps = 0.0;                                // along the body's x axis
  Eigen::Vector2d course_mps = Eigen::Vector2d::Zero();  // horizontal: ahead, to the left
};

// What the driver has learnt about the ground: on a side slope the vehicle crabs and under- or
// oversteers.
struct SteeringBias {
  double sideslip_rad = 0.0;  // of the course against the body's x axis, left positive
  double steer_rad = 0.0;     // to be added to the angle that the wheelbase asks for
};

inline constexpr double kSideslipTime_s = 0.2;  // time constants of the two estimates
inline constexpr double kSteerBiasTime_s = 0.5;

// Learns from the motion seen with the steering at `steer_rad`; nothing below walking pace.
void learn_bias(const Vehicle& vehicle, const DriverView& view, double steer_rad, double dt_s,
                SteeringBias& bias);

// Where the vehicle is by now: the position, carried on by its age at the present velocity.
Eigen::Vector2d position_now(const DriverView& view);

// Steer angle [rad] of the virtual front wheel for following the route from `view`, within the
// steering's limit. Curvature = feed-forward(place) + pursuit(view) - pursuit(place): the circle
// of pure pursuit (Coulter 1992) from where the vehicle is and along its course, less the one from
// where it should be, to the same place ahead. On the path nothing is left but the feed-forward, so
// curves are not cut; near it the correction is -(2 / l^2) offset - (2 / l) angle, l being the
// look-ahead. The feed-forward is that of `preview_m` ahead, for steering that answers late.
double steer_along(const Route& route, const RoutePlace& place, const Vehicle& vehicle,
                   const DriverView& view, const SteeringBias& bias, double preview_m);

}  // namespace headland

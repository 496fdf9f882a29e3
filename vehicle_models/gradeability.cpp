#include "vehicle_models/gradeability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terrains/traction.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr int kBisections = 50;  // more than a double's precision asks for

// Where `holds` turns from true to false between `low` and `high`.
template <typename Holds>
double last_that(double low, double high, const Holds& holds) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

// Net pull over load of a driven wheel whose torque over radius and load is `thrust`.
double pull_by_thrust(const Traction& traction, double thrust) {
  const BestPull best = best_pull(traction);
  const auto affordable = [&](double slip) {
    return gross_pull(traction, traction.slip_stiffness * slip) <=
           thrust - traction.tyre_resistance;
  };
  if (affordable(best.slip)) return best.net_pull;
  return net_pull(traction, last_that(0.0, best.slip, affordable));
}

// Force [N] along the slope that is left when weight and rolling resistance are overcome.
double surplus_n(const Vehicle& vehicle, const Soil& soil, double grade) {
  const double slope_rad = std::atan(grade);
  const double weight_n = kGravity_mps2 * total_mass_kg(vehicle);
  const AxleLoads level = static_axle_loads(vehicle);
  const double carried_n = level.rear_n + level.front_n;
  const double shift_n =
      total_com_B(vehicle).z() / wheelbase_m(vehicle) * carried_n * std::sin(slope_rad);
  const std::array<const Axle*, 2> axles{&vehicle.rear, &vehicle.front};
  const std::array<double, 2> load_n{level.rear_n * std::cos(slope_rad) + shift_n,
                                     level.front_n * std::cos(slope_rad) - shift_n};
  std::array<Traction, 2> tractions;
  const double axle_thrust_n =
      drive_force_n(vehicle, 0.0) / (vehicle.rear.driven && vehicle.front.driven ? 2.0 : 1.0);
  double shared_n = axle_thrust_n;  // by one motor, to each driven axle
  for (std::size_t i = 0; i < 2; ++i) {
    const double wheel_n = 0.5 * load_n[i];
    if (wheel_n <= 0.0) return -weight_n;
    tractions[i] =
        traction_on(soil, tyre_size(*axles[i], 0.5 * (i == 0 ? level.rear_n : level.front_n)),
                    wheel_n, wheel_n / axles[i]->vertical_stiffness_n_per_m);
    if (!axles[i]->driven) continue;
    const double most =
        gross_pull(tractions[i], tractions[i].slip_stiffness * best_pull(tractions[i]).slip);
    shared_n = std::min(shared_n, (most + tractions[i].tyre_resistance) * load_n[i]);
  }
  const double thrust_n = vehicle.drivetrain.motor_per_wheel ? axle_thrust_n : shared_n;
  double force_n = -weight_n * std::sin(slope_rad);
  for (std::size_t i = 0; i < 2; ++i) {
    force_n += load_n[i] * (axles[i]->driven ? pull_by_thrust(tractions[i], thrust_n / load_n[i])
                                             : -rolling_resistance(tractions[i]));
  }
  const double trailed_n = (weight_n - carried_n) * std::cos(slope_rad);
  const auto& trailing = vehicle.implement.trailing;
  const double own = trailing ? trailing->rolling_resistance : 0.0;  // of the implement's tyres
  return force_n - trailed_n * (own > 0.0 ? own : rolling_resistance(tractions[1]));
}

}  // namespace

double gradeability(const Vehicle& vehicle, const Soil& soil) {
  const auto climbs = [&](double grade) { return surplus_n(vehicle, soil, grade) > 0.0; };
  return climbs(0.0) ? last_that(0.0, std::tan(nose_up_stability_angle_rad(vehicle)), climbs) : 0.0;
}

}  // namespace headland

#include "sim/stability.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sim/trailer.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr int kModes = 3;                   // of one body: heave, roll, pitch
constexpr double kMostGrowth = 1.0 + 1e-6;  // an undamped mode has exactly 1, but for rounding
constexpr double kHighestRate_hz = 1000.0;

// Vertical motion of a body's point with each of its modes.
Eigen::Vector3d lift_of(const Eigen::Vector3d& p_C) { return {1.0, p_C.y(), -p_C.x()}; }

struct Springs {
  Eigen::MatrixXd stiffness;
  Eigen::MatrixXd damping;

  void add(const Eigen::VectorXd& lift, double n_per_m, double n_s_per_m) {
    stiffness += n_per_m * lift * lift.transpose();
    damping += n_s_per_m * lift * lift.transpose();
  }
};

Eigen::Vector3d inertias_of(const ChassisMass& mass) {
  return {mass.mass_kg, mass.inertia_kg_m2.x(), mass.inertia_kg_m2.y()};
}

// A number of the vehicle's tyres that may be too large, and what it is over its wheel's mass.
struct Suspect {
  std::string key;
  double value = 0.0;
  double share = 0.0;
};

Suspect worst_of(const Vehicle& vehicle, double dt_s) {
  const ChassisMass mass = chassis_mass(vehicle);
  const auto wheels = define_wheels(vehicle, mass);
  Suspect worst;
  const auto suspect = [&](const std::string& section, const WheelDefinition& wheel,
                           double wheel_kg) {
    const double stiffness = wheel.stiffness_n_per_m;
    const double damping = wheel.damping_n_s_per_m;
    const Suspect both[] = {
        {section + ".vertical_stiffness_n_per_m", stiffness, stiffness * dt_s * dt_s / wheel_kg},
        {section + ".vertical_damping_n_s_per_m", damping, 2.0 * damping * dt_s / wheel_kg}};
    for (const Suspect& one : both) {
      if (one.share > worst.share) worst = one;
    }
  };
  const AxleLoads loads = static_axle_loads(vehicle);
  suspect("rear_tyres", wheels[0], 0.5 * loads.rear_n / kGravity_mps2);
  suspect("front_tyres", wheels[2], 0.5 * loads.front_n / kGravity_mps2);
  if (const auto trailer = make_trailer(vehicle, mass)) {
    suspect("trailing", trailer->wheels[0], 0.5 * trailer->mass.mass_kg);
  }
  return worst;
}

}  // namespace

double growth_per_step(const Vehicle& vehicle, double rate_hz, double harder) {
  const double dt_s = 1.0 / rate_hz;
  const ChassisMass mass = chassis_mass(vehicle);
  const auto trailer = make_trailer(vehicle, mass);
  const int n = trailer ? 2 * kModes : kModes;
  Springs springs{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  Eigen::VectorXd inertias = Eigen::VectorXd::Ones(n);
  inertias.head<kModes>() = inertias_of(mass);
  const auto add_wheel = [&](const WheelDefinition& wheel, int first_mode) {
    Eigen::VectorXd lift = Eigen::VectorXd::Zero(n);
    lift.segment<kModes>(first_mode) = lift_of(wheel.hub_C);
    springs.add(lift, harder * wheel.stiffness_n_per_m, harder * wheel.damping_n_s_per_m);
  };
  for (const WheelDefinition& wheel : define_wheels(vehicle, mass)) add_wheel(wheel, 0);
  if (trailer) {
    inertias.tail<kModes>() = inertias_of(trailer->mass);
    for (const WheelDefinition& wheel : trailer->own_wheels()) add_wheel(wheel, kModes);
    Eigen::VectorXd apart(n);
    apart << lift_of(trailer->pin_on_vehicle_C), -lift_of(trailer->pin_C);
    const double per_s = kPinAnglePerStep_rad / dt_s;
    springs.add(apart, trailer->pin_mass_kg * per_s * per_s,
                2.0 * kPinDamping * trailer->pin_mass_kg * per_s);
  }

  // v+ = v - dt M^-1 (K x + C v), x+ = x + dt v+, for x and dt v.
  const Eigen::MatrixXd pull =
      dt_s * dt_s * inertias.cwiseInverse().asDiagonal() * springs.stiffness;
  const Eigen::MatrixXd kept = Eigen::MatrixXd::Identity(n, n) -
                               dt_s * inertias.cwiseInverse().asDiagonal() * springs.damping;
  Eigen::MatrixXd step(2 * n, 2 * n);
  step << Eigen::MatrixXd::Identity(n, n) - pull, kept, -pull, kept;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

void require_stable(const Vehicle& vehicle, double rate_hz) {
  const auto stable = [&](double at_hz) {
    return growth_per_step(vehicle, at_hz, kStabilityMargin) <= kMostGrowth;
  };
  if (stable(rate_hz)) return;
  double enough_hz = std::ceil(rate_hz);
  while (enough_hz < kHighestRate_hz && !stable(enough_hz)) enough_hz += 1.0;
  const Suspect worst = worst_of(vehicle, 1.0 / rate_hz);
  const std::string remedy = stable(enough_hz)
                                 ? fmt::format("less, or a rate of at least {:.0f} Hz", enough_hz)
                                 : fmt::format("less; no rate up to {:g} Hz will do", enough_hz);
  throw InputError((vehicle.folder / "drive.yaml").string(), worst.key,
                   fmt::format("{:g}", worst.value),
                   fmt::format("too much for {:g} steps a second, each would throw the vehicle "
                               "further up: {}",
                               rate_hz, remedy));
}

}  // namespace headland

#include "render/vehicle_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/gnuplot.h"
#include "sim/battery.h"
#include "sim/drivetrain.h"
#include "terrains/traction.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

// Okabe and Ito.
constexpr std::array kCurveColours = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                      "#cc79a7", "#56b4e9", "#000000", "#8c6d1f"};
constexpr int kCurvePoints = 120;

struct Curve {
  std::string title;
  std::vector<std::pair<double, double>> points;
};

// One panel: data blocks, words, plot.
std::string panel(const std::string& name, const std::string& title, const std::string& x_label,
                  const std::string& y_label, const std::vector<Curve>& curves) {
  std::string text;
  std::string plots;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    text += fmt::format("${}{} << EOD\n", name, i);
    for (const auto& [x, y] : curves[i].points) text += fmt::format("{:g} {:g}\n", x, y);
    text += "EOD\n";
    plots += fmt::format("{}${}{} with lines lw 2 lc rgb '{}' title {}", i == 0 ? "" : ", ", name,
                         i, kCurveColours[i % kCurveColours.size()], gnuplot_text(curves[i].title));
  }
  return text + fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nplot {}\n",
                            gnuplot_text(title), gnuplot_text(x_label), gnuplot_text(y_label),
                            plots);
}

Curve sampled(std::string title, double from, double to, double (*x_shown)(double),
              const auto& value) {
  Curve curve{std::move(title), {}};
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double x = from + (to - from) * i / kCurvePoints;
    const double y = value(x);
    if (std::isfinite(y)) curve.points.emplace_back(x_shown(x), y);
  }
  return curve;
}

double as_it_is(double x) { return x; }
double in_percent(double x) { return 100.0 * x; }

std::string traction_panel(const Vehicle& vehicle, const Soil& given) {
  const double load_n = 0.5 * static_axle_loads(vehicle).rear_n;
  const Axle& axle = vehicle.rear;
  std::vector<Curve> curves;
  const auto add = [&](const Soil& soil) {
    const Traction traction = traction_on(soil, tyre_size(axle, load_n), load_n,
                                          load_n / axle.vertical_stiffness_n_per_m);
    curves.push_back(sampled(soil.name, 0.0, 0.6, in_percent,
                             [&](double slip) { return net_pull(traction, slip); }));
  };
  for (const Soil& soil : soils()) add(soil);
  if (find_soil(given.name) == nullptr) add(given);
  return panel("pull", fmt::format("Net pull of a rear wheel carrying {:.1f} kN", 1e-3 * load_n),
               "slip [%]", "pull over load", curves);
}

std::string motor_panel(const Vehicle& vehicle) {
  const Motor& motor = vehicle.motor;
  std::vector<Curve> curves;
  for (const double share : {0.1, 0.25, 0.5, 1.0}) {
    const double torque_nm = share * motor.max_torque_nm;
    const double fastest = std::min(motor.max_speed_rad_per_s, motor.max_power_w / torque_nm);
    curves.push_back(sampled(
        fmt::format("{:.3g} N m", torque_nm), 0.0, fastest, as_it_is, [&](double speed_rad_per_s) {
          const double shaft_w = torque_nm * speed_rad_per_s;
          const double loss_w = motor_loss_w(motor, torque_nm, speed_rad_per_s);
          return 100.0 * shaft_w / (shaft_w + loss_w);
        }));
  }
  return panel("motor", motor_count(vehicle) > 1 ? "Efficiency of one motor" : "Motor efficiency",
               "motor speed [rad/s]", "shaft over electrical power [%]", curves);
}

std::string battery_panel(const Vehicle& vehicle) {
  const Battery& battery = vehicle.battery;
  std::vector<Curve> curves;
  for (const double c_rate : {0.0, 0.2, 0.5, 1.0}) {
    const double current_a = c_rate * battery.capacity_ah;
    const double drop_v =
        current_a * (battery.resistance_ohm + battery.polarisation_resistance_ohm);
    curves.push_back(
        sampled(c_rate == 0.0 ? "at rest" : fmt::format("{:.3g} A steadily", current_a), 1.0,
                battery.empty_soc, in_percent,
                [&](double soc) { return open_circuit_voltage_v(battery, soc) - drop_v; }));
  }
  return panel("battery", "Battery", "state of charge [%]", "voltage [V]", curves);
}

// Without slip, draft and regeneration.
std::string climbing_panel(const Vehicle& vehicle, const Soil& soil) {
  const double weight_n = total_mass_kg(vehicle) * kGravity_mps2;
  const double rolling = figures_on(vehicle, soil).rolling_resistance;
  const Drivetrain& gear = vehicle.drivetrain;
  const int motors = motor_count(vehicle);
  std::vector<Curve> curves;
  for (const double speed_mps : {vehicle.driver.work_speed_mps, vehicle.driver.transit_speed_mps}) {
    const double speed_rad_per_s = gear.gear_ratio * speed_mps / vehicle.rear.radius_m;
    curves.push_back(
        sampled(fmt::format("{:.2f} m/s", speed_mps), -0.2, 0.2, in_percent, [&](double slope) {
          const double angle_rad = std::atan(slope);
          const double force_n = weight_n * (std::sin(angle_rad) + rolling * std::cos(angle_rad));
          const double torque_nm = std::max(0.0, force_n) * vehicle.rear.radius_m /
                                   (gear.gear_ratio * gear.efficiency * motors);
          const double motor_w =
              torque_nm * speed_rad_per_s + motor_loss_w(vehicle.motor, torque_nm, speed_rad_per_s);
          return 1e-3 * (motors * motor_w / vehicle.motor.inverter_efficiency +
                         vehicle.battery.auxiliary_power_w);
        }));
  }
  return panel("climb", fmt::format("Power of driving on {} ground, implement raised", soil.name),
               "slope [%], uphill positive", "from the battery [kW]", curves);
}

}  // namespace

std::string vehicle_charts_script(const Vehicle& vehicle, const Soil& soil) {
  return fmt::format("set multiplot layout 2,2 title {} font 'DejaVu Sans Bold,14'\n",
                     gnuplot_text(vehicle.name)) +
         "set grid lt 1 lw 1 lc rgb '#d8d8d8'\nset border 3\nset tics nomirror\n"
         "set key bottom right\n" +
         traction_panel(vehicle, soil) + motor_panel(vehicle) + "set key bottom left\n" +
         "set xrange [] reverse\n" + battery_panel(vehicle) +
         "set xrange [] noreverse\nset key top left\n" + climbing_panel(vehicle, soil) +
         "unset multiplot\n";
}

}  // namespace headland

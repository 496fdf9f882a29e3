// Coast-down and climb by the same torques in headland and in MuJoCo, side by side. Not a test: two
// engines with different tyres may differ by what slip takes.
// Usage: mujoco_check [--json]
#include <cstdlib>

#include "bench/figures.h"
#include "bench/mujoco_car.h"
#include "bench/textbook_vehicle.h"
#include "sim/machine.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kStep_s = 1.0 / 240.0;
constexpr double kMu = 0.8;
constexpr double kCrr = 0.05;

struct Drive {
  double slope = 0.0;
  double start_mps = 0.0;
  double torque_nm = 0.0;  // of all wheels
  double time_s = 0.0;
};

double speed_in_headland(const Vehicle& vehicle, const Drive& drive) {
  const Heightfield terrain = test::plane(drive.slope, 0.0);
  const SoilMap soil = test::textbook_soil(kMu, kCrr);
  const Machine machine = make_machine(vehicle, terrain, soil);
  BulletWorld world(test::open_field(), terrain, vehicle);
  ChassisState start = place_on_ground(machine, {0.0, 0.0}, 0.0);
  start.v_W = drive.start_mps * start.R_WB.col(0);
  world.set_state(start);
  MachineState state;
  for (WheelState& wheel : state.wheels) {
    wheel.spin_rad_per_s = drive.start_mps / vehicle.rear.radius_m;
  }
  DriverCommand command;
  command.wheel_torque_nm = drive.torque_nm;
  command.direction = 1.0;
  for (double t_s = 0.0; t_s < drive.time_s; t_s += kStep_s) {
    step_machine(machine, command, {}, 0.0, kStep_s, world, state);
  }
  const ChassisState end = world.state();
  return end.v_W.dot(end.R_WB.col(0));
}

double speed_in_mujoco(const Vehicle& vehicle, const Drive& drive) {
  bench::MujocoCar car(nullptr, drive.slope, vehicle, kMu, kCrr, kStep_s);
  car.set_speed(drive.start_mps);
  for (double t_s = 0.0; t_s < drive.time_s; t_s += kStep_s) car.step(0.25 * drive.torque_nm);
  return car.speed_mps();
}

// Masses and wheels as one, as in the closed form dv/dt = (T / r - m g (sin + Crr cos)) / m'.
double speed_by_formula(const Vehicle& vehicle, const Drive& drive) {
  const double radius_m = vehicle.rear.radius_m;
  const double mass_kg = total_mass_kg(vehicle);
  const double moved_kg = mass_kg + 4.0 * vehicle.rear.wheel_inertia_kg_m2 / (radius_m * radius_m);
  const double slope_rad = std::atan(drive.slope);
  const double force_n =
      drive.torque_nm / radius_m -
      mass_kg * kGravity_mps2 * (std::sin(slope_rad) + kCrr * std::cos(slope_rad));
  return drive.start_mps + drive.time_s * force_n / moved_kg;
}

void add(const std::string& name, const Vehicle& vehicle, const Drive& drive,
         std::vector<bench::Figure>& figures) {
  const double ours = speed_in_headland(vehicle, drive);
  const double theirs = speed_in_mujoco(vehicle, drive);
  const double formula = speed_by_formula(vehicle, drive);
  figures.push_back({name + ": speed at the end, headland", ours, "m/s", ""});
  figures.push_back({name + ": MuJoCo", theirs, "m/s", ""});
  figures.push_back({name + ": closed form without slip", formula, "m/s", ""});
  const double change = formula - drive.start_mps;
  figures.push_back(
      {name + ": headland off the change of speed", 100.0 * (ours - formula) / change, "%", ""});
  figures.push_back(
      {name + ": MuJoCo off the change of speed", 100.0 * (theirs - formula) / change, "%", ""});
}

std::vector<bench::Figure> compare() {
  Vehicle vehicle = bench::textbook_vehicle();
  // No limits: both get the torque asked for.
  vehicle.motor.max_torque_nm = 1e4;
  vehicle.motor.max_power_w = 1e6;
  vehicle.motor.max_speed_rad_per_s = 1e4;
  vehicle.battery.resistance_ohm = 1e-4;
  const double weight_n = total_mass_kg(vehicle) * kGravity_mps2;
  const double radius_m = vehicle.rear.radius_m;
  std::vector<bench::Figure> figures;
  add("coast-down from 2 m/s, 3 s", vehicle, {0.0, 2.0, 0.0, 3.0}, figures);
  add("10 % climb at 0.25 of the weight, 3 s", vehicle, {0.1, 0.0, 0.25 * weight_n * radius_m, 3.0},
      figures);
  add("20 % climb at 0.35 of the weight, 3 s", vehicle, {0.2, 0.0, 0.35 * weight_n * radius_m, 3.0},
      figures);
  return figures;
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  headland::bench::print(headland::compare(), headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

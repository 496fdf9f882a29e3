// Speed and truth of the physics: real-time factor, step against a bare Bullet body, closed forms.
// Usage: drive_bench [--json]
#include <cmath>
#include <cstdlib>

#include "bench/figures.h"
#include "tests/sim/test_drives.h"

namespace headland {
namespace {

constexpr double kRate_hz = 240.0;

void add_speed(std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::hills(1.0, 25.0);
  const SoilMap soil = test::textbook_soil();
  const Path path = test::rows_with_omega_turns(12, 40.0, 2.0, planning_turning_radius_m(vehicle));
  const Field field = test::open_field();
  const Machine machine = make_machine(vehicle, terrain, soil);

  // Interleaved batches, so that a noisy machine disturbs both alike.
  constexpr int kBatches = 9;
  constexpr int kSteps = 20000;
  std::vector<double> bare_us;
  std::vector<double> step_us;
  std::vector<double> factor;
  for (int batch = 0; batch < kBatches; ++batch) {
    BulletWorld falling(field, terrain, vehicle);
    ChassisState high;
    high.p_WC = {0.0, 0.0, 1e5};
    falling.set_state(high);
    auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kSteps; ++i) {
      falling.step(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1.0 / kRate_hz);
    }
    bare_us.push_back(1e6 * bench::seconds_since(start) / kSteps);

    BulletWorld rolling(field, terrain, vehicle);
    rolling.set_state(place_on_ground(machine, {0.0, 0.0}, 0.0));
    MachineState state;
    DriverCommand coasting;
    coasting.wheel_torque_nm = 200.0;
    start = std::chrono::steady_clock::now();
    for (int i = 0; i < kSteps; ++i) {
      step_machine(machine, coasting, {0.3, 0.0}, 0.0, 1.0 / kRate_hz, rolling, state);
    }
    step_us.push_back(1e6 * bench::seconds_since(start) / kSteps);

    start = std::chrono::steady_clock::now();
    const RunRecord run = simulate({field, terrain, soil, vehicle, path, {}, {}});
    factor.push_back(run.duration_s / bench::seconds_since(start));
  }
  figures.push_back({"drive without coverage, times real time, 240 Hz, one core",
                     bench::median(factor), "x", ">= 1000"});
  figures.push_back(
      {"machine step (wheels, motor, battery, ledger)", bench::median(step_us), "us", ""});
  figures.push_back({"bare Bullet body's step", bench::median(bare_us), "us", ""});
  figures.push_back({"ratio of the two", bench::median(step_us) / bench::median(bare_us), "", ""});
}

// Losses of the machine itself switched off: what is left are the textbook's terms.
Vehicle textbook_vehicle() {
  Vehicle vehicle = load_vehicle("transplanter");
  vehicle.motor.copper_loss_kc = vehicle.motor.iron_loss_ki = 0.0;
  vehicle.motor.windage_loss_kw = vehicle.motor.constant_loss_w = 0.0;
  vehicle.battery.auxiliary_power_w = 0.0;
  vehicle.drivetrain.efficiency = 0.8;
  vehicle.implement.mass_kg = 0.0;
  vehicle.body.com_B.x() = 0.5 * wheelbase_m(vehicle);
  const double wheelbase = vehicle.front.x_B_m;
  vehicle.front = vehicle.rear;
  vehicle.front.x_B_m = wheelbase;
  vehicle.front.driven = true;
  return vehicle;
}

double energy_per_metre(const Vehicle& vehicle, double slope) {
  const RunRecord run =
      test::run(test::straight(120.0), vehicle, test::plane(slope, 0.0), test::textbook_soil());
  double power_w = 0.0;
  double speed_mps = 0.0;
  for (std::size_t i = run.samples.size() / 2; i < run.samples.size() * 3 / 4; ++i) {
    power_w += run.samples[i].battery_power_w;
    speed_mps += run.samples[i].speed_mps;
  }
  return power_w / speed_mps;
}

void add_closed_forms(std::vector<bench::Figure>& figures) {
  const Vehicle vehicle = textbook_vehicle();
  const double weight_n = total_mass_kg(vehicle) * kGravity_mps2;
  const double flat = energy_per_metre(vehicle, 0.0) / (0.05 * weight_n / 0.8) - 1.0;
  const double slope_rad = std::atan(0.1);
  const double climb = energy_per_metre(vehicle, 0.1) /
                           (weight_n * (0.05 * std::cos(slope_rad) + std::sin(slope_rad)) / 0.8) -
                       1.0;
  figures.push_back({"flat J/m over Crr m g / efficiency, less 1", 100.0 * flat, "%", "<= 0.1"});
  figures.push_back({"10 % climb J/m over its formula, less 1 (slip)", 100.0 * climb, "%", "<= 2"});
}

void add_brake_hold(std::vector<bench::Figure>& figures) {
  const test::ParkedVehicle parked = test::park(load_vehicle("transplanter"), 0.2, kRate_hz);
  figures.push_back({"drift braked on a 20 % slope", parked.drift_mm_per_min, "mm/min", "<= 0.1"});
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  std::vector<headland::bench::Figure> figures;
  headland::add_speed(figures);
  headland::add_closed_forms(figures);
  headland::add_brake_hold(figures);
  headland::bench::print(figures, headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

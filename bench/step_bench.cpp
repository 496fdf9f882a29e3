// One step of headland beside a bare Bullet body's, btRaycastVehicle's and MuJoCo's for a like car
// on the same height field: medians of interleaved batches, so that a noisy machine disturbs all
// alike.
// Usage: step_bench [--json]
#include <cstdlib>
#include <functional>

#include "bench/figures.h"
#include "bench/raycast_car.h"
#include "sim/machine.h"
#include "tests/sim/test_drives.h"
#ifdef HEADLAND_MUJOCO
#include "bench/mujoco_car.h"
#endif

namespace headland {
namespace {

constexpr double kRate_hz = 240.0;
constexpr double kStep_s = 1.0 / kRate_hz;
constexpr int kBatches = 31;
constexpr int kSteps = 5000;  // a batch

struct Contestant {
  const char* name;
  // Makes a new one, and gives what advances it by a step.
  std::function<std::function<void()>()> make;
  std::vector<double> step_us{};
};

double median_us(const Contestant& contestant) { return bench::median(contestant.step_us); }

// Of the batches' own ratios: what slows the machine for a while slows neighbours alike.
double median_ratio(const Contestant& one, const Contestant& other) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < one.step_us.size(); ++i) {
    ratios.push_back(one.step_us[i] / other.step_us[i]);
  }
  return bench::median(ratios);
}

void run_batches(std::vector<Contestant>& contestants) {
  for (int batch = 0; batch < kBatches; ++batch) {
    for (Contestant& contestant : contestants) {
      const std::function<void()> step = contestant.make();
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < kSteps; ++i) step();
      contestant.step_us.push_back(1e6 * bench::seconds_since(start) / kSteps);
    }
  }
}

std::vector<bench::Figure> measure() {
  const Vehicle vehicle = load_vehicle("transplanter");
  const Heightfield terrain = test::hills(1.0, 25.0);
  const SoilMap soil = test::soil_named("firm");
  const Field field = test::open_field();
  const Machine machine = make_machine(vehicle, terrain, soil);
  constexpr double kForce_n = 600.0;
  constexpr double kSteer_rad = 0.3;

  long airborne = 0;
  std::vector<Contestant> contestants;
  contestants.push_back({"bare Bullet body", [&] {
                           auto world = std::make_shared<BulletWorld>(field, terrain, vehicle);
                           ChassisState high;
                           high.p_WC = {0.0, 0.0, 1e5};
                           world->set_state(high);
                           return [world] {
                             world->step(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kStep_s);
                           };
                         }});
  contestants.push_back(
      {"headland: wheels, soil, motor, battery, draft, ledger", [&] {
         auto world = std::make_shared<BulletWorld>(field, terrain, vehicle);
         auto state = std::make_shared<MachineState>();
         world->set_state(place_on_ground(machine, {0.0, 0.0}, 0.0));
         DriverCommand command;
         command.wheel_torque_nm = kForce_n * vehicle.rear.radius_m;
         command.working = true;
         return [&machine, command, world, state] {
           step_machine(machine, command, {kSteer_rad, 0.0}, 1.0, kStep_s, *world, *state);
         };
       }});
  contestants.push_back({"btRaycastVehicle", [&] {
                           auto car = std::make_shared<bench::RaycastCar>(terrain, vehicle);
                           // Without rolling resistance any force would drive it off the terrain.
                           return [car, &airborne] {
                             car->step(0.0, kSteer_rad, kStep_s);
                             airborne += car->wheels_on_ground() < 4 ? 1 : 0;
                           };
                         }});
#ifdef HEADLAND_MUJOCO
  contestants.push_back(
      {"MuJoCo", [&] {
         auto car = std::make_shared<bench::MujocoCar>(&terrain, 0.0, vehicle, 0.8, 0.05, kStep_s);
         return [car, &vehicle] { car->step(0.25 * kForce_n * vehicle.rear.radius_m); };
       }});
#endif
  run_batches(contestants);

  std::vector<bench::Figure> figures;
  for (const Contestant& contestant : contestants) {
    figures.push_back(
        {std::string(contestant.name) + ", one step", median_us(contestant), "us", ""});
  }
  const Contestant& ours = contestants[1];
  figures.push_back(
      {"headland over bare Bullet body", median_ratio(ours, contestants[0]), "", "<= 3.5"});
  figures.push_back(
      {"headland over btRaycastVehicle", median_ratio(ours, contestants[2]), "", "<= 0.5"});
  figures.push_back({"btRaycastVehicle's steps with a wheel in the air",
                     100.0 * static_cast<double>(airborne) / (kBatches * kSteps), "%", ""});
  if (contestants.size() > 3) {
    figures.push_back({"headland over MuJoCo", median_ratio(ours, contestants[3]), "", "<= 0.15"});
  }
  return figures;
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  headland::bench::print(headland::measure(), headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

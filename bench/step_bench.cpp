// One step of headland beside a bare Bullet body's, btRaycastVehicle's and MuJoCo's for a like car
// on the same height field, each driven at the same speed: medians of interleaved batches in CPU
// time, so that a noisy machine disturbs all alike.
//
// btRaycastVehicle is there twice. Lean: its hull is kept out of the terrain, so that all it does
// is to cast four rays as short as the suspension; a grounded belly goes unnoticed. As Bullet ships
// it: the hull meets the terrain, which is how it comes to feel its belly, as headland does with
// its probes. Usage: step_bench [--json]
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
constexpr double kSpeed_mps = 1.0;
constexpr double kSteer_rad = 0.3;  // of those that steer

struct Contestant {
  const char* name;
  // Makes a new one, and gives what advances it by a step and returns its speed.
  std::function<std::function<double()>()> make;
  std::vector<double> step_us{};
  double mean_mps = 0.0;
};

// Force that holds the speed.
double force_n(double mass_kg, double speed_mps) {
  constexpr double kGain_per_s = 5.0;
  const double most_n = 0.3 * mass_kg * kGravity_mps2;
  return std::clamp(kGain_per_s * mass_kg * (kSpeed_mps - speed_mps), -most_n, most_n);
}

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
      const std::function<double()> step = contestant.make();
      double speed_sum_mps = 0.0;
      const double start_s = bench::cpu_seconds();
      for (int i = 0; i < kSteps; ++i) speed_sum_mps += step();
      contestant.step_us.push_back(1e6 * (bench::cpu_seconds() - start_s) / kSteps);
      contestant.mean_mps = speed_sum_mps / kSteps;
    }
  }
}

// What all of them drive and on what.
struct Scene {
  Vehicle vehicle = load_vehicle("transplanter");
  Heightfield terrain = test::hills(0.5, 40.0);  // up to 8 %: all of them climb it
  SoilMap soil = test::soil_named("firm");
  Field field = test::open_field();
  Machine machine = make_machine(vehicle, terrain, soil);
  double mass_kg = total_mass_kg(vehicle);
};

Contestant bare_body(const Scene& scene) {
  return {"bare Bullet body", [&scene] {
            auto world = std::make_shared<BulletWorld>(scene.field, scene.terrain, scene.vehicle);
            ChassisState high;
            high.p_WC = {0.0, 0.0, 1e5};
            world->set_state(high);
            return [world] {
              world->step(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kStep_s);
              return 0.0;
            };
          }};
}

Contestant our_machine(const Scene& scene) {
  return {"headland: wheels, soil, motor, battery, draft, belly, ledger", [&scene] {
            auto world = std::make_shared<BulletWorld>(scene.field, scene.terrain, scene.vehicle);
            auto state = std::make_shared<MachineState>();
            stand(scene.machine, {0.0, 0.0}, 0.0, *world);
            DriverCommand command;
            command.working = true;
            command.direction = 1.0;
            return [&scene, command, world, state, speed_mps = 0.0]() mutable {
              command.wheel_torque_nm =
                  force_n(scene.mass_kg, speed_mps) * scene.vehicle.rear.radius_m;
              const StepReport step = step_machine(scene.machine, command, {kSteer_rad, 0.0}, 1.0,
                                                   kStep_s, *world, *state);
              speed_mps = step.chassis.v_W.dot(step.chassis.R_WB.col(0));
              return speed_mps;
            };
          }};
}

Contestant raycast_car(const char* name, const Scene& scene, bench::HullContact hull,
                       long& airborne) {
  return {name, [&scene, &airborne, hull] {
            auto car = std::make_shared<bench::RaycastCar>(scene.terrain, scene.vehicle, hull);
            return [&scene, &airborne, car] {
              car->step(force_n(scene.mass_kg, car->speed_mps()), kSteer_rad, kStep_s);
              airborne += car->wheels_on_ground() < 4 ? 1 : 0;
              return car->speed_mps();
            };
          }};
}

#ifdef HEADLAND_MUJOCO
Contestant mujoco_car(const Scene& scene) {
  return {"MuJoCo, straight on", [&scene] {
            auto car = std::make_shared<bench::MujocoCar>(&scene.terrain, 0.0, scene.vehicle, 0.8,
                                                          0.05, kStep_s);
            return [&scene, car] {
              const double force = force_n(scene.mass_kg, car->speed_mps());
              car->step(0.25 * force * scene.vehicle.rear.radius_m);
              return car->speed_mps();
            };
          }};
}
#endif

std::vector<bench::Figure> measure() {
  const Scene scene;
  long lean_airborne = 0;
  long shipped_airborne = 0;
  std::vector<Contestant> contestants{
      bare_body(scene), our_machine(scene),
      raycast_car("btRaycastVehicle, lean", scene, bench::HullContact::kNone, lean_airborne),
      raycast_car("btRaycastVehicle, its hull meets the terrain", scene,
                  bench::HullContact::kTerrain, shipped_airborne)};
#ifdef HEADLAND_MUJOCO
  contestants.push_back(mujoco_car(scene));
#endif
  run_batches(contestants);

  std::vector<bench::Figure> figures;
  for (const Contestant& contestant : contestants) {
    figures.push_back(
        {fmt::format("{}, one step", contestant.name), median_us(contestant), "us", ""});
    if (&contestant != &contestants.front()) {
      figures.push_back({"  its mean speed", contestant.mean_mps, "m/s", ""});
    }
  }
  constexpr const char* kTargets[] = {"<= 3.5", "", "<= 0.5 (lean: see docs/physics.md)", "<= 0.5",
                                      "<= 0.15"};
  const Contestant& ours = contestants[1];
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (i == 1) continue;
    figures.push_back({fmt::format("headland over {}", contestants[i].name),
                       median_ratio(ours, contestants[i]), "", kTargets[i]});
  }
  const auto share = [](long steps) {
    return 100.0 * static_cast<double>(steps) / (kBatches * kSteps);
  };
  figures.push_back(
      {"lean btRaycastVehicle's steps with a wheel in the air", share(lean_airborne), "%", ""});
  figures.push_back({"the other's", share(shipped_airborne), "%", ""});
  return figures;
}

}  // namespace
}  // namespace headland

int main(int argc, char** argv) {
  headland::bench::print(headland::measure(), headland::bench::wants_json(argc, argv));
  return EXIT_SUCCESS;
}

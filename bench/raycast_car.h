// Bullet's own vehicle, for comparison: wheels are rays, their spin is kinematic.
#pragma once

#include <memory>

#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland::bench {

// What the car's hull meets besides its wheels' rays.
enum class HullContact {
  kNone,    // kept out of the terrain, which it may sink into
  kTerrain  // as in Bullet's own demonstrations: a belly that grounds is felt
};

// A btRaycastVehicle with the mass, hull and wheels of `vehicle` over `terrain`, which must outlive
// it, driven at its rear wheels.
class RaycastCar {
 public:
  RaycastCar(const Heightfield& terrain, const Vehicle& vehicle, HullContact hull);
  ~RaycastCar();
  RaycastCar(const RaycastCar&) = delete;
  RaycastCar& operator=(const RaycastCar&) = delete;

  void step(double force_n, double steer_rad, double dt_s);
  double speed_mps() const;  // along its x axis
  int wheels_on_ground() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace headland::bench

// Bullet's own vehicle, for comparison: wheels are rays, their spin is kinematic.
#pragma once

#include <memory>

#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland::bench {

// A btRaycastVehicle with the mass, hull and wheels of `vehicle` over `terrain`, which must outlive
// it, driven at its rear wheels.
class RaycastCar {
 public:
  RaycastCar(const Heightfield& terrain, const Vehicle& vehicle);
  ~RaycastCar();
  RaycastCar(const RaycastCar&) = delete;
  RaycastCar& operator=(const RaycastCar&) = delete;

  void step(double force_n, double steer_rad, double dt_s);
  int wheels_on_ground() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace headland::bench

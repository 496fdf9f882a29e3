// A like car in MuJoCo, for comparison.
#pragma once

#include <memory>

#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland::bench {

// Body and four wheels on hinges with the masses, inertias and radii of `vehicle`, on `terrain` as
// MuJoCo's height field or, when that is null, on a plane tilted by `slope` (rise over run, uphill
// along x). The wheels are cylinders; friction is `mu`, rolling resistance a dry friction of the
// hinges for `crr` on the static loads. Axles are rigid: tyre springs are MuJoCo's soft contacts.
class MujocoCar {
 public:
  MujocoCar(const Heightfield* terrain, double slope, const Vehicle& vehicle, double mu, double crr,
            double dt_s);
  ~MujocoCar();
  MujocoCar(const MujocoCar&) = delete;
  MujocoCar& operator=(const MujocoCar&) = delete;

  void set_speed(double speed_mps);       // wheels rolling
  void step(double torque_per_wheel_nm);  // on all four wheels
  double speed_mps() const;               // along the body's x axis

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace headland::bench

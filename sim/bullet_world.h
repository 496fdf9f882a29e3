// The Bullet world of one run. Its source is the only file that includes Bullet.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "sim/chassis.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// One rigid body (the vehicle with a mounted implement), and a second one for a trailed implement,
// over the terrain, among the field's obstacles. Gravity acts; everything else comes in through
// step(). Hull and implement collide with obstacles but not with the terrain, where wheels carry
// them (a box resting on a heightfield costs 70 times a free body's step), nor with each other.
// `terrain` is not copied and must outlive the world. One world per thread.
class BulletWorld {
 public:
  BulletWorld(const Field& field, const Heightfield& terrain, const Vehicle& vehicle);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void set_state(const ChassisState& state);
  ChassisState state() const;

  // Of the trailed implement, where there is one.
  void set_trailer_state(const ChassisState& state);
  ChassisState trailer_state() const;

  // One fixed step with a force through the centre of mass and a torque, both in W, besides
  // gravity; `trailer` is what acts on a trailed implement.
  void step(const Eigen::Vector3d& force_W, const Eigen::Vector3d& torque_W, double dt_s,
            const Load& trailer = {});

  // Index of the obstacle that the hull or the implement touched in the last step.
  std::optional<std::size_t> touched_obstacle() const;

  // Height of Bullet's own terrain surface on the vertical through (x, y), by its ray cast.
  std::optional<double> ray_cast_height(double x_m, double y_m) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace headland

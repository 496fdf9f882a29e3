#include "bench/raycast_car.h"

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletDynamics/Vehicle/btRaycastVehicle.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>

#include "sim/chassis.h"

namespace headland::bench {

struct RaycastCar::Parts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btRaycastVehicle::btVehicleTuning tuning;
  std::unique_ptr<btHeightfieldTerrainShape> terrain_shape;
  std::unique_ptr<btRigidBody> terrain;
  std::unique_ptr<btBoxShape> box;
  btCompoundShape hull;
  std::unique_ptr<btRigidBody> chassis;
  std::unique_ptr<btDefaultVehicleRaycaster> raycaster;
  std::unique_ptr<btRaycastVehicle> car;
};

RaycastCar::RaycastCar(const Heightfield& terrain, const Vehicle& vehicle, HullContact hull)
    : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.world.setGravity({0.0, 0.0, -kGravity_mps2});
  p.world.setForceUpdateAllAabbs(false);
  const auto [low, high] = std::minmax_element(terrain.height_m.begin(), terrain.height_m.end());
  p.terrain_shape = std::make_unique<btHeightfieldTerrainShape>(
      terrain.columns, terrain.rows, terrain.height_m.data(), *low, *high, 2, false);
  p.terrain_shape->setLocalScaling({terrain.cell_m, terrain.cell_m, 1.0});
  btTransform pose = btTransform::getIdentity();
  pose.setOrigin({terrain.origin_W.x() + 0.5 * (terrain.columns - 1) * terrain.cell_m,
                  terrain.origin_W.y() + 0.5 * (terrain.rows - 1) * terrain.cell_m,
                  0.5 * (*low + *high)});
  // The vehicle's rays see rigid bodies only.
  p.terrain = std::make_unique<btRigidBody>(
      btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, p.terrain_shape.get()));
  p.terrain->setWorldTransform(pose);
  constexpr int kTerrainGroup = btBroadphaseProxy::StaticFilter;
  constexpr int kHullGroup = btBroadphaseProxy::CharacterFilter;
  p.world.addRigidBody(p.terrain.get(), kTerrainGroup,
                       btBroadphaseProxy::DefaultFilter | kHullGroup);

  const ChassisMass mass = chassis_mass(vehicle);
  const Body& body = vehicle.body;
  p.box = std::make_unique<btBoxShape>(btVector3(0.5 * body.length_m, 0.5 * body.width_m,
                                                 0.5 * (body.height_m - body.ground_clearance_m)));
  btTransform middle = btTransform::getIdentity();
  middle.setOrigin({0.5 * body.length_m - body.rear_overhang_m - mass.com_B.x(), -mass.com_B.y(),
                    0.5 * (body.height_m + body.ground_clearance_m) - mass.com_B.z()});
  p.hull.addChildShape(middle, p.box.get());
  btRigidBody::btRigidBodyConstructionInfo info(
      mass.mass_kg, nullptr, &p.hull,
      {mass.inertia_kg_m2.x(), mass.inertia_kg_m2.y(), mass.inertia_kg_m2.z()});
  p.chassis = std::make_unique<btRigidBody>(info);
  p.chassis->setActivationState(DISABLE_DEACTIVATION);
  pose.setIdentity();
  const double ground_m = surface_at(terrain, 0.0, 0.0).height_m;
  pose.setOrigin({mass.com_B.x(), 0.0, ground_m + mass.com_B.z() + 0.05});
  p.chassis->setWorldTransform(pose);
  p.world.addRigidBody(p.chassis.get(), kHullGroup,
                       hull == HullContact::kTerrain ? kTerrainGroup : 0);

  p.raycaster = std::make_unique<btDefaultVehicleRaycaster>(&p.world);
  p.car = std::make_unique<btRaycastVehicle>(p.tuning, p.chassis.get(), p.raycaster.get());
  p.car->setCoordinateSystem(1, 2, 0);
  constexpr double kRestLength_m = 0.2;
  for (const Axle* axle : {&vehicle.rear, &vehicle.front}) {
    for (const double side : {1.0, -1.0}) {
      const btVector3 hub(axle->x_B_m - mass.com_B.x(), side * 0.5 * axle->track_m,
                          axle->radius_m - mass.com_B.z() + kRestLength_m);
      btWheelInfo& wheel = p.car->addWheel(hub, {0, 0, -1}, {0, -1, 0}, kRestLength_m,
                                           axle->radius_m, p.tuning, axle == &vehicle.front);
      // Per mass. As soft as in Bullet's own demonstrations: with a tyre's stiffness it topples at
      // 240 Hz.
      wheel.m_suspensionStiffness = 40.0;
      wheel.m_wheelsDampingCompression = 4.0;
      wheel.m_wheelsDampingRelaxation = 4.0;
      wheel.m_maxSuspensionForce = 10.0 * mass.mass_kg * kGravity_mps2;
    }
  }
  p.world.addAction(p.car.get());
}

RaycastCar::~RaycastCar() {
  parts_->world.removeAction(parts_->car.get());
  parts_->world.removeRigidBody(parts_->chassis.get());
  parts_->world.removeRigidBody(parts_->terrain.get());
}

void RaycastCar::step(double force_n, double steer_rad, double dt_s) {
  for (const int wheel : {0, 1}) parts_->car->applyEngineForce(0.5 * force_n, wheel);
  for (const int wheel : {2, 3}) parts_->car->setSteeringValue(steer_rad, wheel);
  parts_->world.stepSimulation(dt_s, 0);
}

double RaycastCar::speed_mps() const {
  const btTransform& pose = parts_->chassis->getWorldTransform();
  return pose.getBasis().getColumn(0).dot(parts_->chassis->getLinearVelocity());
}

int RaycastCar::wheels_on_ground() const {
  int count = 0;
  for (int i = 0; i < parts_->car->getNumWheels(); ++i) {
    if (parts_->car->getWheelInfo(i).m_raycastInfo.m_isInContact) ++count;
  }
  return count;
}

}  // namespace headland::bench

#include "sim/bullet_world.h"

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/trailer.h"

namespace headland {
namespace {

enum CollisionGroup : int { kTerrain = 1, kHull = 2, kObstacle = 4 };

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

void set_motion(btRigidBody& body, const ChassisState& state) {
  const Eigen::Matrix3d& R = state.R_WB;
  const btMatrix3x3 basis(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                          R(2, 2));
  body.setWorldTransform(btTransform(basis, to_bullet(state.p_WC)));
  body.setLinearVelocity(to_bullet(state.v_W));
  body.setAngularVelocity(to_bullet(state.omega_W));
  body.updateInertiaTensor();
}

ChassisState motion_of(const btRigidBody& body) {
  ChassisState state;
  state.p_WC = from_bullet(body.getWorldTransform().getOrigin());
  const btMatrix3x3& basis = body.getWorldTransform().getBasis();
  for (int i = 0; i < 3; ++i) state.R_WB.row(i) = from_bullet(basis[i]).transpose();
  state.v_W = from_bullet(body.getLinearVelocity());
  state.omega_W = from_bullet(body.getAngularVelocity());
  return state;
}

}  // namespace

struct BulletWorld::Parts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

  std::unique_ptr<btHeightfieldTerrainShape> terrain_shape;
  std::unique_ptr<btCollisionObject> terrain;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> obstacles;
  btCompoundShape hull_shape;
  std::unique_ptr<btRigidBody> chassis;
  btCompoundShape trailer_shape;
  std::unique_ptr<btRigidBody> trailer;  // null without a trailed implement

  btVector3 force{0, 0, 0};
  btVector3 torque{0, 0, 0};
  btVector3 trailer_force{0, 0, 0};
  btVector3 trailer_torque{0, 0, 0};

  // Bullet clears forces after each step, and clears those of an action before they count when
  // there is a single sub-step; the pre-tick callback is the place where they do count.
  static void before_tick(btDynamicsWorld* world, btScalar) {
    auto* parts = static_cast<Parts*>(world->getWorldUserInfo());
    parts->chassis->applyCentralForce(parts->force);
    parts->chassis->applyTorque(parts->torque);
    if (parts->trailer == nullptr) return;
    parts->trailer->applyCentralForce(parts->trailer_force);
    parts->trailer->applyTorque(parts->trailer_torque);
  }

  void add_terrain(const Heightfield& heights) {
    const auto [low, high] = std::minmax_element(heights.height_m.begin(), heights.height_m.end());
    terrain_shape = std::make_unique<btHeightfieldTerrainShape>(
        heights.columns, heights.rows, heights.height_m.data(), *low, *high, 2, false);
    terrain_shape->setLocalScaling({heights.cell_m, heights.cell_m, 1.0});
    terrain = std::make_unique<btCollisionObject>();
    terrain->setCollisionShape(terrain_shape.get());
    btTransform pose = btTransform::getIdentity();
    pose.setOrigin({heights.origin_W.x() + 0.5 * (heights.columns - 1) * heights.cell_m,
                    heights.origin_W.y() + 0.5 * (heights.rows - 1) * heights.cell_m,
                    0.5 * (*low + *high)});
    terrain->setWorldTransform(pose);
    world.addCollisionObject(terrain.get(), kTerrain, kTerrain);
  }

  void add_solid(std::unique_ptr<btCollisionShape> shape, const btTransform& pose, int obstacle) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shape.get());
    object->setWorldTransform(pose);
    object->setUserIndex(obstacle);
    world.addCollisionObject(object.get(), kObstacle, kHull);
    shapes.push_back(std::move(shape));
    obstacles.push_back(std::move(object));
  }

  void add_cylinder(const Obstacle& obstacle, const Eigen::Vector2d& p_W,
                    const Heightfield& heights, int index) {
    const double half_m = 0.5 * obstacle.height_m;
    btTransform pose = btTransform::getIdentity();
    pose.setOrigin({p_W.x(), p_W.y(), surface_at(heights, p_W.x(), p_W.y()).height_m + half_m});
    add_solid(
        std::make_unique<btCylinderShapeZ>(btVector3(obstacle.radius_m, obstacle.radius_m, half_m)),
        pose, index);
  }

  // A box on the line from a to b that stands on the lower end's ground and has the obstacle's
  // height over the higher one's.
  void add_wall_box(const Obstacle& obstacle, const Eigen::Vector2d& a_W,
                    const Eigen::Vector2d& b_W, const Heightfield& heights, int index) {
    const double ground_a_m = surface_at(heights, a_W.x(), a_W.y()).height_m;
    const double ground_b_m = surface_at(heights, b_W.x(), b_W.y()).height_m;
    const double low_m = std::min(ground_a_m, ground_b_m);
    const double high_m = std::max(ground_a_m, ground_b_m) + obstacle.height_m;
    const Eigen::Vector2d run_W = b_W - a_W;
    const Eigen::Vector2d middle_W = 0.5 * (a_W + b_W);
    btTransform pose = btTransform::getIdentity();
    pose.setRotation({btVector3(0.0, 0.0, 1.0), std::atan2(run_W.y(), run_W.x())});
    pose.setOrigin({middle_W.x(), middle_W.y(), 0.5 * (low_m + high_m)});
    add_solid(std::make_unique<btBoxShape>(
                  btVector3(0.5 * run_W.norm(), obstacle.radius_m, 0.5 * (high_m - low_m))),
              pose, index);
  }

  // A cylinder, or boxes along the line, short enough to follow the terrain, with round ends.
  void add_obstacle(const Obstacle& obstacle, const Heightfield& heights, int index) {
    constexpr double kLongestBox_m = 2.0;
    add_cylinder(obstacle, obstacle.p_W, heights, index);
    const double length_m = obstacle.run_W.norm();
    if (length_m == 0.0) return;
    add_cylinder(obstacle, obstacle.p_W + obstacle.run_W, heights, index);
    const int boxes = static_cast<int>(std::ceil(length_m / kLongestBox_m));
    for (int i = 0; i < boxes; ++i) {
      add_wall_box(obstacle, obstacle.p_W + i * obstacle.run_W / boxes,
                   obstacle.p_W + (i + 1) * obstacle.run_W / boxes, heights, index);
    }
  }

  // A box of `compound`, between corners in the body's frame whose origin is `com` before its
  // centre of mass.
  void add_box(btCompoundShape& compound, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
               const Eigen::Vector3d& com) {
    shapes.push_back(std::make_unique<btBoxShape>(to_bullet(0.5 * (high - low))));
    btTransform pose = btTransform::getIdentity();
    pose.setOrigin(to_bullet(0.5 * (low + high) - com));
    compound.addChildShape(pose, shapes.back().get());
  }

  void add_bar(btCompoundShape& compound, const Implement& implement, double x_m,
               const Eigen::Vector3d& com) {
    if (!(implement.working_width_m > 0.0)) return;
    constexpr double kHalfDepth_m = 0.5 * kImplementDepth_m;
    const double z_m = implement.com_height_m;
    const double half_m = 0.5 * implement.working_width_m;
    add_box(compound, {x_m - kHalfDepth_m, -half_m, z_m - kHalfDepth_m},
            {x_m + kHalfDepth_m, half_m, z_m + kHalfDepth_m}, com);
  }

  // Boxes around the wheels, standing straight: what is lower than the hull is met by them.
  void add_wheels(btCompoundShape& compound, const Axle& axle, const Eigen::Vector3d& com) {
    for (const double side : {1.0, -1.0}) {
      const Eigen::Vector3d hub(axle.x_B_m, side * 0.5 * axle.track_m, axle.radius_m);
      const Eigen::Vector3d half(axle.radius_m, 0.5 * axle.width_m, axle.radius_m);
      add_box(compound, hub - half, hub + half, com);
    }
  }

  std::unique_ptr<btRigidBody> add_body(btCompoundShape& shape, const ChassisMass& mass) {
    btRigidBody::btRigidBodyConstructionInfo info(mass.mass_kg, nullptr, &shape,
                                                  to_bullet(mass.inertia_kg_m2));
    info.m_linearDamping = 0.0;
    info.m_angularDamping = 0.0;
    auto body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(body.get(), kHull, kObstacle);
    return body;
  }

  void add_vehicle(const Vehicle& vehicle) {
    const ChassisMass mass = chassis_mass(vehicle);
    const Body& body = vehicle.body;
    const double half_width_m = 0.5 * body.width_m;
    add_box(hull_shape, {-body.rear_overhang_m, -half_width_m, body.ground_clearance_m},
            {body.length_m - body.rear_overhang_m, half_width_m, body.height_m}, mass.com_B);
    add_wheels(hull_shape, vehicle.rear, mass.com_B);
    add_wheels(hull_shape, vehicle.front, mass.com_B);
    if (!vehicle.implement.trailing) {
      add_bar(hull_shape, vehicle.implement, vehicle.implement.x_B_m, mass.com_B);
    }
    chassis = add_body(hull_shape, mass);
    if (const auto trailed = make_trailer(vehicle, mass)) add_trailer(vehicle.implement, *trailed);
  }

  void add_trailer(const Implement& implement, const Trailer& trailed) {
    constexpr double kHalfBeam_m = 0.1;
    const Trailing& trailing = *implement.trailing;
    const double wheels_m = 0.5 * (trailing.track_m + trailing.wheel_width_m);
    const double radius_m = trailing.wheel_radius_m;
    const double beam_m = trailing.hitch_height_m;
    const Eigen::Vector3d& com = trailed.mass.com_B;
    add_bar(trailer_shape, implement, (trailed.tool_C + com).x(), com);
    add_box(trailer_shape, {0.0, -kHalfBeam_m, beam_m - kHalfBeam_m},
            {trailing.drawbar_length_m, kHalfBeam_m, beam_m + kHalfBeam_m}, com);
    add_box(trailer_shape, {-radius_m, -wheels_m, radius_m}, {radius_m, wheels_m, 2.0 * radius_m},
            com);
    Axle axle;
    axle.track_m = trailing.track_m;
    axle.radius_m = radius_m;
    axle.width_m = trailing.wheel_width_m;
    add_wheels(trailer_shape, axle, com);
    trailer = add_body(trailer_shape, trailed.mass);
  }
};

BulletWorld::BulletWorld(const Field& field, const Heightfield& terrain, const Vehicle& vehicle)
    : parts_(std::make_unique<Parts>()) {
  parts_->world.setGravity({0.0, 0.0, -kGravity_mps2});
  parts_->world.setInternalTickCallback(&Parts::before_tick, parts_.get(), true);
  // Static bodies never move: without this Bullet recomputes their bounds in every step.
  parts_->world.setForceUpdateAllAabbs(false);
  parts_->add_terrain(terrain);
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    parts_->add_obstacle(field.obstacles[i], terrain, static_cast<int>(i));
  }
  parts_->add_vehicle(vehicle);
}

BulletWorld::~BulletWorld() {
  parts_->world.removeRigidBody(parts_->chassis.get());
  if (parts_->trailer != nullptr) parts_->world.removeRigidBody(parts_->trailer.get());
  for (const auto& obstacle : parts_->obstacles) {
    parts_->world.removeCollisionObject(obstacle.get());
  }
  parts_->world.removeCollisionObject(parts_->terrain.get());
}

void BulletWorld::set_state(const ChassisState& state) { set_motion(*parts_->chassis, state); }

ChassisState BulletWorld::state() const { return motion_of(*parts_->chassis); }

void BulletWorld::set_trailer_state(const ChassisState& state) {
  set_motion(*parts_->trailer, state);
}

ChassisState BulletWorld::trailer_state() const { return motion_of(*parts_->trailer); }

void BulletWorld::step(const Eigen::Vector3d& force_W, const Eigen::Vector3d& torque_W, double dt_s,
                       const Load& trailer) {
  parts_->force = to_bullet(force_W);
  parts_->torque = to_bullet(torque_W);
  parts_->trailer_force = to_bullet(trailer.force_W);
  parts_->trailer_torque = to_bullet(trailer.torque_W);
  parts_->world.stepSimulation(dt_s, 0);
}

std::optional<std::size_t> BulletWorld::touched_obstacle() const {
  for (int i = 0; i < parts_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *parts_->dispatcher.getManifoldByIndexInternal(i);
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      if (manifold.getContactPoint(c).getDistance() > 0.0) continue;
      // The chassis itself has no index.
      const int index =
          std::max(manifold.getBody0()->getUserIndex(), manifold.getBody1()->getUserIndex());
      if (index >= 0) return static_cast<std::size_t>(index);
    }
  }
  return std::nullopt;
}

std::optional<double> BulletWorld::ray_cast_height(double x_m, double y_m) const {
  constexpr double kFar_m = 1e4;
  const btVector3 from(x_m, y_m, kFar_m);
  const btVector3 to(x_m, y_m, -kFar_m);
  btCollisionWorld::ClosestRayResultCallback result(from, to);
  result.m_collisionFilterGroup = kTerrain;
  result.m_collisionFilterMask = kTerrain;
  parts_->world.rayTest(from, to, result);
  if (!result.hasHit()) return std::nullopt;
  return result.m_hitPointWorld.z();
}

}  // namespace headland

#include "bench/mujoco_car.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/chassis.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland::bench {
namespace {

// Everything but the ground, in a body frame at the centre of mass.
std::string car_xml(const Vehicle& vehicle, double mu, double crr) {
  const ChassisMass mass = chassis_mass(vehicle);
  const AxleLoads loads = static_axle_loads(vehicle);
  // Wheels are part of headland's one body; here they need a mass of their own.
  constexpr double kWheelMass_kg = 1.0;
  const Eigen::Vector3d& I = mass.inertia_kg_m2;
  std::string xml = fmt::format(
      "<body name='car' pos='0 0 0'><freejoint/>"
      "<inertial pos='0 0 0' mass='{}' diaginertia='{} {} {}'/>",
      mass.mass_kg - 4.0 * kWheelMass_kg, I.x(), I.y(), I.z());
  int number = 0;
  for (const Axle* axle : {&vehicle.rear, &vehicle.front}) {
    const double load_n = 0.5 * (axle == &vehicle.rear ? loads.rear_n : loads.front_n);
    for (const double side : {1.0, -1.0}) {
      xml += fmt::format(
          "<body pos='{} {} {}'><joint name='w{}' type='hinge' axis='0 1 0' frictionloss='{}'/>"
          "<inertial pos='0 0 0' mass='{}' diaginertia='{} {} {}'/>"
          "<geom type='cylinder' size='{} {}' zaxis='0 1 0' friction='{} 0 0' condim='3'/></body>",
          axle->x_B_m - mass.com_B.x(), side * 0.5 * axle->track_m, axle->radius_m - mass.com_B.z(),
          number++, crr * load_n * axle->radius_m, kWheelMass_kg, axle->wheel_inertia_kg_m2,
          axle->wheel_inertia_kg_m2, axle->wheel_inertia_kg_m2, axle->radius_m, 0.5 * axle->width_m,
          mu);
    }
  }
  return xml + "</body>";
}

}  // namespace

struct MujocoCar::Parts {
  mjModel* model = nullptr;
  mjData* data = nullptr;
  double radius_m = 0.0;
};

MujocoCar::MujocoCar(const Heightfield* terrain, double slope, const Vehicle& vehicle, double mu,
                     double crr, double dt_s)
    : parts_(std::make_unique<Parts>()) {
  std::string asset;
  std::string ground;
  double low_m = 0.0;
  double range_m = 1.0;
  const double tilt_rad = std::atan(slope);
  if (terrain != nullptr) {
    const auto [low, high] =
        std::minmax_element(terrain->height_m.begin(), terrain->height_m.end());
    low_m = *low;
    range_m = std::max(*high - *low, 1e-3);
    const double half_x_m = 0.5 * (terrain->columns - 1) * terrain->cell_m;
    const double half_y_m = 0.5 * (terrain->rows - 1) * terrain->cell_m;
    asset = fmt::format("<asset><hfield name='h' nrow='{}' ncol='{}' size='{} {} {} 1'/></asset>",
                        terrain->rows, terrain->columns, half_x_m, half_y_m, range_m);
    ground =
        fmt::format("<geom type='hfield' hfield='h' pos='{} {} {}' friction='{} 0 0'/>",
                    terrain->origin_W.x() + half_x_m, terrain->origin_W.y() + half_y_m, low_m, mu);
  } else {
    ground = fmt::format("<geom type='plane' size='500 500 1' friction='{} 0 0'/>", mu);
  }
  // On a plane the slope is in the direction of gravity.
  const std::string xml = fmt::format(
      "<mujoco><option timestep='{}' gravity='{} 0 {}'/>{}<worldbody>{}{}</worldbody></mujoco>",
      dt_s, -kGravity_mps2 * std::sin(tilt_rad), -kGravity_mps2 * std::cos(tilt_rad), asset, ground,
      car_xml(vehicle, mu, crr));
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "car.xml", static_cast<int>(xml.size()));
  std::memcpy(files.filedata[0], xml.data(), xml.size());
  std::array<char, 1000> error{};
  parts_->model = mj_loadXML("car.xml", &files, error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(&files);
  if (parts_->model == nullptr) throw std::runtime_error(error.data());
  if (terrain != nullptr) {
    for (std::size_t i = 0; i < terrain->height_m.size(); ++i) {
      parts_->model->hfield_data[i] = static_cast<float>((terrain->height_m[i] - low_m) / range_m);
    }
  }
  parts_->data = mj_makeData(parts_->model);
  parts_->radius_m = vehicle.rear.radius_m;
  const double ground_m = terrain != nullptr ? surface_at(*terrain, 0.0, 0.0).height_m : 0.0;
  parts_->data->qpos[2] = ground_m + chassis_mass(vehicle).com_B.z();
}

MujocoCar::~MujocoCar() {
  mj_deleteData(parts_->data);
  mj_deleteModel(parts_->model);
}

void MujocoCar::set_speed(double speed_mps) {
  parts_->data->qvel[0] = speed_mps;
  for (int wheel = 0; wheel < 4; ++wheel) {
    parts_->data->qvel[6 + wheel] = speed_mps / parts_->radius_m;
  }
}

void MujocoCar::step(double torque_per_wheel_nm) {
  for (int wheel = 0; wheel < 4; ++wheel) {
    parts_->data->qfrc_applied[6 + wheel] = torque_per_wheel_nm;
  }
  mj_step(parts_->model, parts_->data);
}

double MujocoCar::speed_mps() const {
  // The free joint's linear velocity is in the world's frame.
  const double* q = parts_->data->qpos + 3;
  const double* v = parts_->data->qvel;
  const Eigen::Vector3d ahead =
      Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Vector3d::UnitX();
  return ahead.dot(Eigen::Vector3d(v[0], v[1], v[2]));
}

}  // namespace headland::bench

// The vehicles that come with the program must be machines that could exist.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "vehicle_models/draft.h"
#include "vehicle_models/vehicle_figures.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Tilled soil, the hardest of the usual grounds to roll on.
constexpr double kSoftRolling = 0.10;
// What a tractor tyre holds on firm soil.
constexpr double kFirmFriction = 0.6;

class BuiltInVehicle : public testing::TestWithParam<std::string> {
 protected:
  const Vehicle vehicle = load_vehicle(GetParam());
};

INSTANTIATE_TEST_SUITE_P(All, BuiltInVehicle, testing::ValuesIn(vehicle_names()),
                         [](const auto& test) { return test.param; });

// What stands or presses on the vehicle's wheels besides its body: mass [kg] and place.
struct Carried {
  double mass_kg = 0.0;
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
};
Carried carried(const Implement& implement) {
  if (const auto& trailing = implement.trailing) {
    return {implement.mass_kg * trailing->com_ahead_m / trailing->drawbar_length_m,
            {trailing->hitch_x_B_m, 0.0, trailing->hitch_height_m}};
  }
  return {implement.mass_kg, {implement.x_B_m, 0.0, implement.com_height_m}};
}

TEST_P(BuiltInVehicle, AxleLoadsSumToTheWeightAndBalanceTheMoment) {
  const AxleLoads loads = static_axle_loads(vehicle);
  const Carried implement = carried(vehicle.implement);
  const double weight_n = kGravity_mps2 * (vehicle.body.mass_kg + implement.mass_kg);
  EXPECT_NEAR(loads.rear_n + loads.front_n, weight_n, 1e-9 * weight_n);
  const double rear_x_m = vehicle.rear.x_B_m;
  const double moment_nm =
      kGravity_mps2 * (vehicle.body.mass_kg * (vehicle.body.com_B.x() - rear_x_m) +
                       implement.mass_kg * (implement.p_B.x() - rear_x_m));
  EXPECT_NEAR(loads.front_n * wheelbase_m(vehicle), moment_nm, 1e-9 * weight_n);
  // An implement must leave a fifth of the weight on the steered axle (common rule).
  EXPECT_GT(loads.front_n, 0.2 * weight_n);
}

TEST_P(BuiltInVehicle, TyresSagAndDampAsTyresDo) {
  const AxleLoads loads = static_axle_loads(vehicle);
  const auto check = [](const Axle& axle, double axle_load_n) {
    const double wheel_load_n = 0.5 * axle_load_n;
    const double sag_m = wheel_load_n / axle.vertical_stiffness_n_per_m;
    EXPECT_GT(sag_m, 0.01);
    EXPECT_LT(sag_m, 0.03);
    const double critical_n_s_per_m =
        2.0 * std::sqrt(axle.vertical_stiffness_n_per_m * wheel_load_n / kGravity_mps2);
    const double ratio = axle.vertical_damping_n_s_per_m / critical_n_s_per_m;
    EXPECT_GT(ratio, 0.10);
    EXPECT_LT(ratio, 0.20);
  };
  check(vehicle.rear, loads.rear_n);
  check(vehicle.front, loads.front_n);
}

TEST_P(BuiltInVehicle, StandsOnTheSideSlopesThatSuchMachinesStandOn) {
  EXPECT_GT(side_stability_angle_rad(vehicle), 30.0 * kDegree);
  EXPECT_LT(side_stability_angle_rad(vehicle), 55.0 * kDegree);
}

// The slope turned until the weight's line passes the rear axle: the mass centre's x and height.
TEST_P(BuiltInVehicle, LiftsItsNoseOnlyOnSlopesThatAreTooSteepAnyway) {
  const double mounted_kg = vehicle.implement.trailing ? 0.0 : vehicle.implement.mass_kg;
  const Eigen::Vector3d com_B =
      (vehicle.body.mass_kg * vehicle.body.com_B + mounted_kg * carried(vehicle.implement).p_B) /
      (vehicle.body.mass_kg + mounted_kg);
  EXPECT_NEAR(std::tan(nose_up_stability_angle_rad(vehicle)),
              (com_B.x() - vehicle.rear.x_B_m) / com_B.z(), 1e-12);
  EXPECT_GT(nose_up_stability_angle_rad(vehicle), std::atan(0.25));
}

TEST_P(BuiltInVehicle, ClimbsAQuarterWithTheImplementRaised) {
  const double climb = max_grade(vehicle, kSoftRolling);
  EXPECT_GT(climb, 0.25);
  const double angle_rad = std::atan(climb);
  const double weight_n = kGravity_mps2 * total_mass_kg(vehicle);
  EXPECT_NEAR(drive_force_n(vehicle, 0.0),
              weight_n * (std::sin(angle_rad) + kSoftRolling * std::cos(angle_rad)),
              1e-9 * weight_n);
}

TEST_P(BuiltInVehicle, HoldsAQuarterClimbByTractionOfTheDrivenWheels) {
  const double slope_rad = std::atan(0.25);
  const AxleLoads loads = static_axle_loads(vehicle);
  const double weight_n = loads.rear_n + loads.front_n;
  // Only weight transfer to the rear helps, so the level loads are the cautious ones.
  const double driven_n = std::cos(slope_rad) * ((vehicle.rear.driven ? loads.rear_n : 0.0) +
                                                 (vehicle.front.driven ? loads.front_n : 0.0));
  const double needed_n = weight_n * (std::sin(slope_rad) + 0.05 * std::cos(slope_rad));
  EXPECT_GT(kFirmFriction * driven_n, needed_n);
}

TEST_P(BuiltInVehicle, ReachesItsSpeedsWithSomethingLeft) {
  EXPECT_GT(top_speed_mps(vehicle), 1.2 * vehicle.driver.transit_speed_mps);
  EXPECT_LT(top_speed_mps(vehicle), 15.0);
  EXPECT_EQ(drive_force_n(vehicle, 1.01 * top_speed_mps(vehicle)), 0.0);
}

TEST_P(BuiltInVehicle, PullsItsImplementUpATenPercentSlope) {
  const double speed_mps = vehicle.driver.work_speed_mps;
  const double resistance_n =
      draft_n(vehicle.implement, SoilTexture::kMedium, speed_mps) +
      kGravity_mps2 * total_mass_kg(vehicle) * (std::sin(std::atan(0.10)) + kSoftRolling);
  EXPECT_GT(drive_force_n(vehicle, speed_mps), resistance_n);
  EXPECT_LT(resistance_n * speed_mps, motor_count(vehicle) * vehicle.motor.max_power_w);
}

TEST_P(BuiltInVehicle, BatteryHoldsMostOfItsVoltageAtFullPower) {
  const double power_w = drive_peak_input_w(vehicle) + vehicle.implement.shaft_power_w +
                         vehicle.battery.auxiliary_power_w;
  const double emf_v = nominal_voltage_v(vehicle.battery);
  const double r_ohm = vehicle.battery.resistance_ohm + vehicle.battery.polarisation_resistance_ohm;
  const double root = emf_v * emf_v - 4.0 * r_ohm * power_w;
  ASSERT_GT(root, 0.0);
  const double loaded_v = 0.5 * (emf_v + std::sqrt(root));
  EXPECT_GT(loaded_v, 0.9 * emf_v);
  EXPECT_GT(max_battery_power_w(vehicle.battery), power_w);
}

TEST_P(BuiltInVehicle, BatteryLastsForHoursOfWork) {
  const double pull_n =
      draft_n(vehicle.implement, SoilTexture::kMedium, vehicle.driver.work_speed_mps);
  const double rolling_n = 0.05 * kGravity_mps2 * total_mass_kg(vehicle);
  constexpr double kDriveEfficiency = 0.75;
  const double power_w = (pull_n + rolling_n) * vehicle.driver.work_speed_mps / kDriveEfficiency +
                         vehicle.implement.shaft_power_w + vehicle.battery.auxiliary_power_w;
  const double hours = nominal_energy_wh(vehicle.battery) / power_w;
  EXPECT_GT(hours, 1.0);
  EXPECT_LT(hours, 10.0);
}

// The triangles of an OBJ file as its author wrote them, without a mesh library in between.
struct ObjMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;
  std::vector<std::array<std::array<std::size_t, 2>, 3>> triangles;  // vertex and normal index
};

ObjMesh read_obj(const std::filesystem::path& file) {
  ObjMesh mesh;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v" || kind == "vn") {
      Eigen::Vector3d p;
      words >> p.x() >> p.y() >> p.z();
      (kind == "v" ? mesh.vertices : mesh.normals).push_back(p);
    } else if (kind == "f") {
      auto& triangle = mesh.triangles.emplace_back();
      char slash = 0;
      for (auto& corner : triangle) words >> corner[0] >> slash >> slash >> corner[1];
    }
  }
  return mesh;
}

TEST_P(BuiltInVehicle, MeshFillsItsHullAndFacesOutwards) {
  EXPECT_TRUE(vehicle.notes.empty());
  ASSERT_EQ(vehicle.shapes.size(), 1U);
  ObjMesh mesh = read_obj(vehicle.shapes[0].mesh_file);
  for (Eigen::Vector3d& p : mesh.vertices) p = vehicle.shapes[0].X * p;
  ASSERT_GT(mesh.triangles.size(), 100U);
  EXPECT_LT(mesh.triangles.size(), 3000U);
  const Body& body = vehicle.body;
  // Seedlings, receivers and linkage may stand out by a hand's breadth.
  constexpr double kStandOut_m = 0.1;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(p);
  EXPECT_GT(box.min().x(), -body.rear_overhang_m - kStandOut_m);
  EXPECT_LT(box.max().x(), body.length_m - body.rear_overhang_m + kStandOut_m);
  EXPECT_LT(box.max().y(), 0.5 * body.width_m + kStandOut_m);
  EXPECT_LT(box.max().z(), body.height_m + kStandOut_m);
  EXPECT_GT(box.sizes().x(), 0.8 * body.length_m);
  EXPECT_GT(box.sizes().y(), 0.8 * body.width_m);
  EXPECT_GT(box.max().z(), 0.9 * body.height_m);

  // The divergence theorem: outward triangles of closed solids enclose a positive volume, and each
  // triangle's normals lie on its outer side.
  double volume_m3 = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices.at(triangle[0][0] - 1);
    const Eigen::Vector3d& b = mesh.vertices.at(triangle[1][0] - 1);
    const Eigen::Vector3d& c = mesh.vertices.at(triangle[2][0] - 1);
    volume_m3 += a.dot(b.cross(c)) / 6.0;
    const Eigen::Vector3d face = (b - a).cross(c - a).normalized();
    for (const auto& corner : triangle) {
      EXPECT_GT(mesh.normals.at(corner[1] - 1).dot(face), 0.5);
    }
  }
  EXPECT_GT(volume_m3, 0.05);
  EXPECT_LT(volume_m3, body.length_m * body.width_m * body.height_m);
}

}  // namespace
}  // namespace headland

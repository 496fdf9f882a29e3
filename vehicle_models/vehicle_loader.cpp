#include "vehicle_models/vehicle_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "terrains/input_error.h"
#include "vehicle_models/drive_file.h"
#include "vehicle_models/robot_body.h"
#include "vehicle_models/robot_file.h"
#include "vehicle_models/running_gear.h"
#include "vehicle_models/vehicle_check.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRobotFile = "vehicle.urdf";
constexpr std::string_view kDriveFile = "drive.yaml";

struct Range {
  std::string_view what;
  double value = 0.0;
  double min = 0.0;
  double max = 0.0;
};

// Sizes that a robot description in other units or of another kind of robot would miss.
void check_sizes(const Vehicle& vehicle, const std::string& file) {
  const Body& body = vehicle.body;
  const Range ranges[] = {{"mass [kg]", body.mass_kg, 10.0, 60000.0},
                          {"length [m]", body.length_m, 0.3, 20.0},
                          {"width [m]", body.width_m, 0.2, 10.0},
                          {"height [m]", body.height_m, 0.1, 6.0},
                          {"ground clearance [m]", body.ground_clearance_m, 0.02, 3.0},
                          {"wheelbase [m]", wheelbase_m(vehicle), 0.3, 10.0},
                          {"rear track [m]", vehicle.rear.track_m, 0.2, 6.0},
                          {"front track [m]", vehicle.front.track_m, 0.2, 6.0},
                          {"rear wheel radius [m]", vehicle.rear.radius_m, 0.05, 2.0},
                          {"front wheel radius [m]", vehicle.front.radius_m, 0.05, 2.0}};
  for (const Range& range : ranges) {
    if (range.value >= range.min && range.value <= range.max) continue;
    throw InputError(file, std::string(range.what), fmt::format("{:.4g}", range.value),
                     fmt::format("must be from {:g} to {:g}", range.min, range.max));
  }
}

void place_axle(const Wheel& left, const Wheel& right, const Eigen::Vector3d& origin_R,
                Axle& axle) {
  axle.x_B_m = 0.5 * (left.centre_R.x() + right.centre_R.x()) - origin_R.x();
  axle.track_m = left.centre_R.y() - right.centre_R.y();
  axle.radius_m = left.radius_m;
  axle.width_m = left.width_m;
  axle.wheel_inertia_kg_m2 = left.inertia_kg_m2;
  axle.oscillation_max_rad = left.pivot_rad.value_or(0.0);
}

void apply_robot(const Robot& robot, const std::string& drive_file, Vehicle& vehicle) {
  RunningGear gear = find_running_gear(robot);
  place_axle(gear.wheels[0], gear.wheels[1], gear.origin_R, vehicle.rear);
  place_axle(gear.wheels[2], gear.wheels[3], gear.origin_R, vehicle.front);
  // Exactly about the origin of B, whatever the sums above were rounded to.
  vehicle.rear.x_B_m = gear.steering == SteeringKind::kFront ? 0.0 : -vehicle.front.x_B_m;
  vehicle.body = body_of(robot, gear);
  vehicle.shapes = body_shapes(robot, gear);
  vehicle.notes = std::move(gear.notes);
  if (gear.steering != vehicle.steering.kind) {
    throw InputError(drive_file, "steering.kind", std::string(steering_word(vehicle.steering.kind)),
                     fmt::format("the steering joints of {} make it '{}' (revolute joints about z "
                                 "between the root and the wheels steer)",
                                 kRobotFile, steering_word(gear.steering)));
  }
  Steering& steering = vehicle.steering;
  steering.max_angle_rad = gear.max_angle_rad;
  if (gear.steering == SteeringKind::kSkid) {
    if (steering.max_rate_rad_per_s > 0.0) {
      throw InputError(drive_file, "steering.max_rate_deg_per_s", "",
                       "only for wheel steering; this vehicle's is 'skid'");
    }
    // The virtual front wheel of the tightest arc, as fast as the vehicle may turn.
    steering.max_angle_rad = steer_for(vehicle, 1.0 / steering.turning_radius_m);
    steering.max_rate_rad_per_s = steering.max_yaw_rate_rad_per_s;
  }
}

// The rotors turn with the wheels, seen through the gear.
void add_rotors(Vehicle& vehicle) {
  const Drivetrain& drivetrain = vehicle.drivetrain;
  const int driven =
      2 * (static_cast<int>(vehicle.rear.driven) + static_cast<int>(vehicle.front.driven));
  const double seen_kg_m2 =
      vehicle.motor.rotor_inertia_kg_m2 * drivetrain.gear_ratio * drivetrain.gear_ratio;
  const double share_kg_m2 = drivetrain.motor_per_wheel ? seen_kg_m2 : seen_kg_m2 / driven;
  for (Axle* axle : {&vehicle.rear, &vehicle.front}) {
    if (axle->driven) axle->wheel_inertia_kg_m2 += share_kg_m2;
  }
}

void note_missing_meshes(Vehicle& vehicle) {
  for (const Shape& shape : vehicle.shapes) {
    if (shape.kind == ShapeKind::kMesh && !fs::is_regular_file(shape.mesh_file)) {
      vehicle.notes.push_back(
          fmt::format("mesh {}: no such file; a plain box is drawn",
                      shape.mesh_file.lexically_proximate(vehicle.folder).string()));
    }
  }
}

Vehicle read_vehicle(const fs::path& folder) {
  const std::string robot_file = (folder / kRobotFile).string();
  const std::string drive_file = (folder / kDriveFile).string();
  Vehicle vehicle;
  vehicle.folder = folder;
  vehicle.name = folder.filename().string();
  const Robot robot = read_robot(robot_file);
  read_drive(drive_file, vehicle);
  apply_robot(robot, drive_file, vehicle);
  check_sizes(vehicle, robot_file);
  add_rotors(vehicle);
  note_missing_meshes(vehicle);
  check_vehicle(vehicle, folder.string());
  return vehicle;
}

fs::path built_in_folder() {
  const char* const replaced = std::getenv("HEADLAND_VEHICLE_DIR");
  return replaced != nullptr ? replaced : HEADLAND_VEHICLE_DIR;
}

}  // namespace

Vehicle load_vehicle(const std::string& name_or_folder) {
  const std::vector<std::string> names = vehicle_names();
  if (std::find(names.begin(), names.end(), name_or_folder) != names.end()) {
    return read_vehicle(built_in_folder() / name_or_folder);
  }
  fs::path folder = name_or_folder;
  if (!folder.has_filename()) folder = folder.parent_path();
  if (fs::is_directory(folder)) return read_vehicle(folder);
  throw InputError("", "vehicle", name_or_folder,
                   fmt::format("no such vehicle or folder; the nearest known vehicle is '{}' of {}",
                               nearest_name(name_or_folder, names), fmt::join(names, ", ")));
}

std::vector<std::string> vehicle_names() {
  const fs::path folder = built_in_folder();
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (fs::is_regular_file(entry.path() / kRobotFile)) {
      names.push_back(entry.path().filename().string());
    }
  }
  if (names.empty()) {
    throw InputError(folder.string(), "", "", "holds no vehicles; check HEADLAND_VEHICLE_DIR");
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace headland

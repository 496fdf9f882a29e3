#include "vehicle_models/vehicle_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "terrains/input_error.h"
#include "tests/vehicle_models/changed_vehicle.h"

namespace headland {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

// What the loader says about the plain vehicle with one change in its drive.yaml.
std::string load_refusal(const std::string& from, const std::string& to) {
  return refusal_of("drive.yaml", from, to);
}

TEST(VehicleLoader, TakesThePlainVehicleSoThatEveryRefusalBelowIsOfItsOneChange) {
  EXPECT_EQ(load_refusal("gear_ratio", "gear_ratio"), "");
}

TEST(VehicleLoader, ReadsEveryKindOfKey) {
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_EQ(vehicle.name, "plain");
  EXPECT_EQ(vehicle.description, "a plain vehicle for tests");
  EXPECT_EQ(vehicle.steering.kind, SteeringKind::kFront);
  EXPECT_EQ(vehicle.rear.section_height_m, 0.13);
  EXPECT_EQ(vehicle.front.section_height_m, 0.11);
  EXPECT_TRUE(vehicle.rear.driven);
  EXPECT_FALSE(vehicle.front.driven);
  EXPECT_EQ(vehicle.battery.chemistry, Chemistry::kLeadAcid);
  EXPECT_EQ(vehicle.battery.cells_in_series, 24);
  EXPECT_EQ(vehicle.motor.windage_loss_kw, 1e-5);
  EXPECT_EQ(vehicle.implement.name, "bar");
}

TEST(VehicleLoader, ConvertsDegreesToRadians) {
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_DOUBLE_EQ(vehicle.steering.max_rate_rad_per_s, 40.0 * std::numbers::pi / 180.0);
}

TEST(VehicleLoader, TakesAFolderWithATrailingSlash) {
  EXPECT_EQ(load_vehicle(kPlain.string() + "/").name, "plain");
}

TEST(VehicleLoader, ListsTheBuiltInVehiclesSorted) {
  const std::vector<std::string> names = vehicle_names();
  EXPECT_THAT(names, testing::IsSupersetOf({"transplanter", "utility_tractor"}));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(VehicleLoader, TheEnvironmentReplacesTheBuiltInFolder) {
  ASSERT_EQ(setenv("HEADLAND_VEHICLE_DIR", kPlain.parent_path().c_str(), 1), 0);
  EXPECT_THAT(vehicle_names(), Contains("plain"));
  EXPECT_EQ(load_vehicle("plain").name, "plain");
  ASSERT_EQ(setenv("HEADLAND_VEHICLE_DIR", "/nowhere", 1), 0);
  EXPECT_THROW(vehicle_names(), InputError);
  ASSERT_EQ(unsetenv("HEADLAND_VEHICLE_DIR"), 0);
}

TEST(VehicleLoader, RefusesAnUnknownVehicleWithTheNearestName) {
  try {
    load_vehicle("transplnter");
    FAIL() << "took an unknown vehicle";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'transplnter'"), HasSubstr("'transplanter'"),
                                    HasSubstr("utility_tractor")));
  }
}

TEST(VehicleLoader, RefusesAFolderWithoutAVehicleFile) {
  try {
    load_vehicle(HEADLAND_TEST_DATA);
    FAIL() << "took a folder without a vehicle";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("vehicle.urdf"), HasSubstr("cannot be read")));
  }
}

TEST(VehicleLoader, RefusesMalformedYamlWithItsLine) {
  EXPECT_THAT(load_refusal("motor:\n", "motor: [\n"),
              AllOf(HasSubstr("drive.yaml: line "), HasSubstr("malformed YAML")));
}

TEST(VehicleLoader, RefusesAFileThatIsNotAMap) {
  EXPECT_THAT(load_refusal("description: a plain vehicle for tests\n", "- a list\n"),
              HasSubstr("drive.yaml: line "));
  EXPECT_THAT(load_refusal("steering:\n  kind: front\n"
                           "  max_rate_deg_per_s: {value: 40, source: \"assumed\"}\n",
                           "steering: 5\n"),
              AllOf(HasSubstr("steering: '5'"), HasSubstr("a map of keys")));
}

TEST(VehicleLoader, RefusesAnUnknownKeyWithItsLineAndTheNearestOne) {
  EXPECT_THAT(load_refusal("gear_ratio", "gear_rato"),
              AllOf(HasSubstr("line 15: drivetrain.gear_rato"), HasSubstr("'gear_ratio'")));
  EXPECT_THAT(load_refusal("steering:", "stering:"),
              AllOf(HasSubstr("stering"), HasSubstr("'steering'")));
}

TEST(VehicleLoader, RefusesAMissingKeyAndAKeyGivenTwice) {
  EXPECT_THAT(load_refusal("  driven: rear\n", ""),
              AllOf(HasSubstr("drivetrain.driven"), HasSubstr("missing key")));
  EXPECT_THAT(load_refusal("  driven: rear\n", "  driven: rear\n  driven: rear\n"),
              AllOf(HasSubstr("drivetrain.driven"), HasSubstr("twice")));
}

TEST(VehicleLoader, RefusesANumberWithoutASource) {
  EXPECT_THAT(
      load_refusal("{value: 42, source: \"assumed\"}", "42"),
      AllOf(HasSubstr("line 15: drivetrain.gear_ratio: '42'"), HasSubstr("needs its source")));
  EXPECT_THAT(load_refusal("{value: 42, source: \"assumed\"}", "{value: 42}"),
              AllOf(HasSubstr("drivetrain.gear_ratio.source"), HasSubstr("missing key")));
  EXPECT_THAT(
      load_refusal("{value: 42, source: \"assumed\"}", "{value: 42, source: \"\"}"),
      AllOf(HasSubstr("drivetrain.gear_ratio.source"), HasSubstr("where the number is from")));
  EXPECT_THAT(load_refusal("{value: 42, source: \"assumed\"}", "{value: 42, sourc: \"x\"}"),
              AllOf(HasSubstr("drivetrain.gear_ratio.sourc"), HasSubstr("'source'")));
}

TEST(VehicleLoader, RefusesNumbersThatAreNoneOrOutOfRange) {
  for (const std::string bad : {"heavy", ".nan", "nan", ".inf", "inf", "-42", "0", "1e9", "42 to 1",
                                "[42]", "0x208", "''"}) {
    EXPECT_THAT(
        load_refusal("value: 42,", "value: " + bad + ","),
        AllOf(HasSubstr("line 15: drivetrain.gear_ratio"), HasSubstr("a number from 0.1 to 1000")))
        << bad;
  }
}

TEST(VehicleLoader, RefusesWholeNumbersThatAreNot) {
  EXPECT_THAT(load_refusal("value: 24,", "value: 24.5,"),
              AllOf(HasSubstr("battery.cells_in_series"), HasSubstr("whole number")));
}

TEST(VehicleLoader, RefusesWordsThatMeanNothing) {
  EXPECT_THAT(load_refusal("lead_acid", "nickel"),
              AllOf(HasSubstr("battery.chemistry: 'nickel'"), HasSubstr("lead_acid or lfp")));
  EXPECT_THAT(load_refusal("driven: rear", "driven: both"),
              HasSubstr("rear or front or all or per_wheel"));
  EXPECT_THAT(load_refusal("name: bar", "name:"), HasSubstr("implement.name"));
}

TEST(VehicleLoader, ChecksTheNumbersTogether) {
  EXPECT_THAT(load_refusal("gear_ratio: {value: 42", "gear_ratio: {value: 420"),
              HasSubstr("drivetrain.gear_ratio: '420'"));
}

TEST(VehicleLoader, ReadsWhatIsDriven) {
  const ChangedVehicle changed("drive.yaml", "driven: rear", "driven: front");
  const Vehicle vehicle = load_vehicle(changed.folder());
  EXPECT_TRUE(!vehicle.rear.driven && vehicle.front.driven && !vehicle.drivetrain.motor_per_wheel);
  const Vehicle robot = load_vehicle("four_wheel_steer_robot");
  EXPECT_TRUE(robot.rear.driven && robot.front.driven && robot.drivetrain.motor_per_wheel);
  EXPECT_EQ(motor_count(robot), 4);
}

TEST(VehicleLoader, AddsTheRotorToTheDrivenWheels) {
  const double gear = 42.0;
  const double rotor_kg_m2 = 0.002;
  const Vehicle plain = load_vehicle(kPlain.string());
  const ChangedVehicle changed(
      "drive.yaml", "  regeneration_fraction",
      "  rotor_inertia_kg_m2: {value: 0.002, source: \"assumed\"}\n  regeneration_fraction");
  const Vehicle vehicle = load_vehicle(changed.folder());
  EXPECT_NEAR(vehicle.rear.wheel_inertia_kg_m2 - plain.rear.wheel_inertia_kg_m2,
              rotor_kg_m2 * gear * gear / 2.0, 1e-12);
  EXPECT_EQ(vehicle.front.wheel_inertia_kg_m2, plain.front.wheel_inertia_kg_m2);
}

std::string trailer(const std::string& hitch_x_m) {
  return "\ntrailing:\n  hitch_x_B_m: {value: " + hitch_x_m +
         ", source: \"assumed\"}\n"
         "  drawbar_length_m: {value: 2, source: \"assumed\"}\n"
         "  max_angle_deg: {value: 90, source: \"assumed\"}\ndriver:\n";
}

TEST(VehicleLoader, ReadsATrailedImplement) {
  const ChangedVehicle changed("drive.yaml", "\ndriver:\n", trailer("-0.5"));
  const Vehicle vehicle = load_vehicle(changed.folder());
  ASSERT_TRUE(vehicle.implement.trailing.has_value());
  EXPECT_EQ(vehicle.implement.trailing->hitch_x_B_m, -0.5);
  EXPECT_EQ(vehicle.implement.trailing->drawbar_length_m, 2.0);
  EXPECT_DOUBLE_EQ(vehicle.implement.trailing->max_angle_rad, std::numbers::pi / 2.0);
  EXPECT_FALSE(load_vehicle(kPlain.string()).implement.trailing.has_value());
}

TEST(VehicleLoader, RefusesATrailedImplementThatCannotStandOrTurn) {
  const auto with = [](const std::string& key, const std::string& value) {
    return load_refusal("\ndriver:\n",
                        "\ntrailing:\n  hitch_x_B_m: {value: -0.5, source: \"assumed\"}\n"
                        "  drawbar_length_m: {value: 2, source: \"assumed\"}\n  " +
                            key + ": {value: " + value + ", source: \"assumed\"}\ndriver:\n");
  };
  EXPECT_THAT(with("com_ahead_m", "2"),
              AllOf(HasSubstr("trailing.com_ahead_m: '2'"), HasSubstr("below 2 m")));
  EXPECT_THAT(
      with("vertical_stiffness_n_per_m", "1000"),
      AllOf(HasSubstr("trailing.vertical_stiffness_n_per_m: '1000'"), HasSubstr("would sag")));
  EXPECT_THAT(with("max_angle_deg", "20"),
              AllOf(HasSubstr("trailing.drawbar_length_m: '2'"), HasSubstr("jackknife")));
}

TEST(VehicleLoader, RefusesATrailedImplementThatDoesNotTrail) {
  EXPECT_THAT(load_refusal("\ndriver:\n", trailer("-0.9")),
              AllOf(HasSubstr("implement.x_B_m"), HasSubstr("behind its hitch")));
  EXPECT_THAT(load_refusal("\ndriver:\n", trailer("0.2")),
              AllOf(HasSubstr("trailing.hitch_x_B_m: '0.2'"), HasSubstr("at most 0 m")));
  EXPECT_THAT(load_refusal("\ndriver:\n",
                           "\ntrailing:\n  hitch_x_m: {value: -0.5, source: \"a\"}\ndriver:\n"),
              AllOf(HasSubstr("trailing.hitch_x_m"), HasSubstr("'hitch_x_B_m'")));
}

TEST(VehicleLoader, RefusesSteeringThatTheJointsDoNotHave) {
  EXPECT_THAT(load_refusal("kind: front", "kind: four_wheel"),
              AllOf(HasSubstr("steering.kind: 'four_wheel'"), HasSubstr("make it 'front'")));
}

TEST(VehicleLoader, NotesAMissingMeshAndTakesTheVehicle) {
  const ChangedVehicle changed("vehicle.urdf", "meshes/body.obj", "meshes/absent.obj");
  const Vehicle vehicle = load_vehicle(changed.folder());
  ASSERT_EQ(vehicle.notes.size(), 1U);
  EXPECT_EQ(vehicle.notes[0], "mesh meshes/absent.obj: no such file; a plain box is drawn");
  EXPECT_TRUE(load_vehicle(kPlain.string()).notes.empty());
}

}  // namespace
}  // namespace headland

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

namespace headland {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path kPlain = std::filesystem::path(HEADLAND_TEST_DATA) / "vehicles/plain";

// A copy of the plain vehicle in which one piece of text is replaced by another.
class ChangedVehicle {
 public:
  ChangedVehicle(const std::string& from, const std::string& to)
      : folder_(std::filesystem::temp_directory_path() /
                ("headland_vehicle_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::create_directories(folder_);
    std::filesystem::copy_file(kPlain / "body.obj", folder_ / "body.obj",
                               std::filesystem::copy_options::overwrite_existing);
    std::ifstream original(kPlain / "vehicle.yaml");
    std::stringstream text;
    text << original.rdbuf();
    std::string changed = text.str();
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << "the plain vehicle has no text '" << from << "'";
    if (at != std::string::npos) changed.replace(at, from.size(), to);
    std::ofstream(folder_ / "vehicle.yaml") << changed;
  }
  ~ChangedVehicle() { std::filesystem::remove_all(folder_); }
  ChangedVehicle(const ChangedVehicle&) = delete;
  ChangedVehicle& operator=(const ChangedVehicle&) = delete;

  std::string folder() const { return folder_.string(); }

 private:
  std::filesystem::path folder_;
};

// What the loader says about the plain vehicle with one change; empty when it takes it.
std::string refusal(const std::string& from, const std::string& to) {
  const ChangedVehicle vehicle(from, to);
  try {
    load_vehicle(vehicle.folder());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(VehicleLoader, TakesThePlainVehicleSoThatEveryRefusalBelowIsOfItsOneChange) {
  EXPECT_EQ(refusal("mass_kg", "mass_kg"), "");
}

TEST(VehicleLoader, ReadsEveryKindOfKey) {
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_EQ(vehicle.name, "plain");
  EXPECT_EQ(vehicle.description, "a plain vehicle for tests");
  EXPECT_EQ(vehicle.mesh_file, kPlain / "body.obj");
  EXPECT_EQ(vehicle.body.mass_kg, 520.0);
  EXPECT_EQ(vehicle.body.com_B, Eigen::Vector3d(0.6, 0.0, 0.62));
  EXPECT_EQ(vehicle.rear.x_B_m, 0.0);
  EXPECT_EQ(vehicle.front.x_B_m, 1.4);
  EXPECT_TRUE(vehicle.rear.driven);
  EXPECT_FALSE(vehicle.front.driven);
  EXPECT_EQ(vehicle.battery.chemistry, Chemistry::kLeadAcid);
  EXPECT_EQ(vehicle.battery.cells_in_series, 24);
  EXPECT_EQ(vehicle.motor.windage_loss_kw, 1e-5);
  EXPECT_EQ(vehicle.implement.name, "bar");
}

TEST(VehicleLoader, ConvertsDegreesToRadians) {
  const Vehicle vehicle = load_vehicle(kPlain.string());
  EXPECT_DOUBLE_EQ(vehicle.steering.max_angle_rad, 35.0 * std::numbers::pi / 180.0);
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
    EXPECT_THAT(error.what(), HasSubstr("vehicle.yaml: no such file"));
  }
}

TEST(VehicleLoader, RefusesMalformedYamlWithItsLine) {
  EXPECT_THAT(refusal("body:\n", "body: [\n"),
              AllOf(HasSubstr("vehicle.yaml: line "), HasSubstr("malformed YAML")));
}

TEST(VehicleLoader, RefusesAFileThatIsNotAMap) {
  EXPECT_THAT(refusal("description: a plain vehicle for tests\nmesh", "- a list\n- mesh"),
              HasSubstr("vehicle.yaml: line "));
  EXPECT_THAT(refusal("steering:\n  max_angle_deg: {value: 35, source: \"assumed\"}\n"
                      "  max_rate_deg_per_s: {value: 40, source: \"assumed\"}\n",
                      "steering: 5\n"),
              AllOf(HasSubstr("steering: '5'"), HasSubstr("a map of keys")));
}

TEST(VehicleLoader, RefusesAnUnknownKeyWithItsLineAndTheNearestOne) {
  EXPECT_THAT(refusal("mass_kg", "mas_kg"),
              AllOf(HasSubstr("line 4: body.mas_kg"), HasSubstr("'mass_kg'")));
  EXPECT_THAT(refusal("steering:", "stering:"),
              AllOf(HasSubstr("stering"), HasSubstr("'steering'")));
}

TEST(VehicleLoader, RefusesAMissingKeyAndAKeyGivenTwice) {
  EXPECT_THAT(refusal("  driven: true\n", ""),
              AllOf(HasSubstr("rear.driven"), HasSubstr("missing key")));
  EXPECT_THAT(refusal("  driven: true\n", "  driven: true\n  driven: true\n"),
              AllOf(HasSubstr("rear.driven"), HasSubstr("twice")));
}

TEST(VehicleLoader, RefusesANumberWithoutASource) {
  EXPECT_THAT(refusal("{value: 520, source: \"assumed\"}", "520"),
              AllOf(HasSubstr("line 4: body.mass_kg: '520'"), HasSubstr("needs its source")));
  EXPECT_THAT(refusal("{value: 520, source: \"assumed\"}", "{value: 520}"),
              AllOf(HasSubstr("body.mass_kg.source"), HasSubstr("missing key")));
  EXPECT_THAT(refusal("{value: 520, source: \"assumed\"}", "{value: 520, source: \"\"}"),
              AllOf(HasSubstr("body.mass_kg.source"), HasSubstr("where the number is from")));
  EXPECT_THAT(refusal("{value: 520, source: \"assumed\"}", "{value: 520, sourc: \"x\"}"),
              AllOf(HasSubstr("body.mass_kg.sourc"), HasSubstr("'source'")));
}

TEST(VehicleLoader, RefusesNumbersThatAreNoneOrOutOfRange) {
  for (const std::string bad : {"heavy", ".nan", "nan", ".inf", "inf", "-520", "0", "1e9", "520 kg",
                                "[520]", "0x208", "''"}) {
    EXPECT_THAT(refusal("value: 520,", "value: " + bad + ","),
                AllOf(HasSubstr("line 4: body.mass_kg"), HasSubstr("a number from 10 to 60000")))
        << bad;
  }
}

TEST(VehicleLoader, RefusesVectorsOfAnotherLengthAndWholeNumbersThatAreNot) {
  EXPECT_THAT(refusal("[0.6, 0, 0.62]", "[0.6, 0]"),
              AllOf(HasSubstr("body.com_B"), HasSubstr("three numbers")));
  EXPECT_THAT(refusal("[0.6, 0, 0.62]", "0.6"), HasSubstr("three numbers"));
  EXPECT_THAT(refusal("value: 24,", "value: 24.5,"),
              AllOf(HasSubstr("battery.cells_in_series"), HasSubstr("whole number")));
}

TEST(VehicleLoader, RefusesWordsThatMeanNothing) {
  EXPECT_THAT(refusal("lead_acid", "nickel"),
              AllOf(HasSubstr("battery.chemistry: 'nickel'"), HasSubstr("lead_acid or lfp")));
  EXPECT_THAT(refusal("driven: true", "driven: perhaps"), HasSubstr("true or false"));
  EXPECT_THAT(refusal("name: bar", "name:"), HasSubstr("implement.name"));
  EXPECT_THAT(refusal("body.obj", "absent.obj"),
              AllOf(HasSubstr("line 2: mesh: 'absent.obj'"), HasSubstr("no such file")));
}

TEST(VehicleLoader, ChecksTheNumbersTogether) {
  EXPECT_THAT(refusal("gear_ratio: {value: 42", "gear_ratio: {value: 420"),
              HasSubstr("vehicle.yaml: drivetrain.gear_ratio: '420'"));
}

}  // namespace
}  // namespace headland

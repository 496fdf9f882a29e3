// Robot descriptions that are no vehicle's: each is refused in one line that says what to mend.
#include "vehicle_models/robot_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/vehicle_models/changed_vehicle.h"

namespace headland {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string refusal(const std::string& from, const std::string& to) {
  return refusal_of("vehicle.urdf", from, to);
}

struct BadRobot {
  std::string name;
  std::string from;
  std::string to;
  std::string where;  // parts of the line
  std::string message;
};

const std::string kLeftWheel = "<joint name=\"rear_left_wheel\" type=\"continuous\">";
const std::string kLeftSteering = "<joint name=\"front_left_steering\" type=\"revolute\">";

const BadRobot kBadRobots[] = {
    {"MalformedXml", "</robot>", "", "vehicle.urdf: line ", "malformed XML"},
    {"UnclosedTag", "<mass value=\"464\"/>", "<mass value=\"464\">", "line ", "malformed XML"},
    {"NoRobot", "robot", "vehicle", "line 3", "must hold one <robot>"},
    {"Empty", "<", "", "vehicle.urdf: line 1", "malformed XML"},
    {"NoNumber", "value=\"464\"", "value=\"heavy\"", "vehicle.urdf: no valid URDF", "heavy"},
    {"MissingLink", "<child link=\"rear_left_wheel\"/>", "<child link=\"nobody\"/>",
     "no valid URDF", "nobody"},
    {"TwoRoots", "</robot>", "<link name=\"spare\"/></robot>", "no valid URDF",
     "Two root links found"},
    {"NegativeMass", "value=\"464\"", "value=\"-464\"", "line 5: link 'base_link': '-464'",
     "must be 0 kg or more"},
    {"NotANumber", "value=\"464\"", "value=\"nan\"", "vehicle.urdf", "nan"},
    {"ZeroInertia", "ixx=\"136.129\" ixy=\"0\" ixz=\"0\" iyy=\"319.157\" iyz=\"0\" izz=\"344.813\"",
     "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"", "line 5: link 'base_link': '0'",
     "above 0 kg m2"},
    {"IndefiniteInertia", "ixy=\"0\" ixz=\"0\" iyy=\"319.157\"",
     "ixy=\"9999\" ixz=\"0\" iyy=\"319.157\"", "link 'base_link'", "above 0 kg m2"},
    {"NoAxis", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 0 0\"/>", "joint ", "no direction"},
    {"FloatingJoint", "type=\"continuous\"", "type=\"floating\"", "_wheel'",
     "fixed, continuous, revolute or prismatic"},
    {"TwoCarriers", "</robot>",
     "<joint name=\"again\" type=\"fixed\"><parent link=\"base_link\"/>"
     "<child link=\"rear_left_wheel\"/></joint></robot>",
     "'rear_left_wheel'", "one joint to each link"},
    {"RingOfJoints", "</robot>",
     "<link name=\"a\"/><link name=\"b\"/>"
     "<joint name=\"ab\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>"
     "<joint name=\"ba\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint></robot>",
     "link 'a'", "ring of joints"},
    {"NegativeRadius", "radius=\"0.34\"", "radius=\"-0.34\"", "rear_left_wheel",
     "must be above 0 m"},
    {"NoWheels", "type=\"continuous\"", "type=\"fixed\"", "vehicle.urdf: wheels",
     "each wheel needs a joint of type continuous"},
    {"ThreeWheels", kLeftWheel, "<joint name=\"rear_left_wheel\" type=\"fixed\">",
     "front_left_wheel", "3 continuous joints; headland drives vehicles with four"},
    {"UprightWheelAxle", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 0 1\"/>", "'0 0 1'",
     "must turn about y"},
    {"MeshWheels", "<cylinder radius=\"0.34\" length=\"0.16\"/>", "<mesh filename=\"wheel.stl\"/>",
     "joint 'rear_", "tells the radius"},
    {"LyingCylinder", "rpy=\"1.5707963 0 0\"", "rpy=\"0 0 0\"", "_wheel",
     "does not lie along its axle"},
    {"UnequalWheels", "<origin xyz=\"0 0.75 0.34\"/>", "<origin xyz=\"0 0.75 0.5\"/>",
     "rear_left_wheel, rear_right_wheel", "side by side"},
    {"FloatingFront", "0.75 0.3\"", "0.75 0.5\"", "'0.2'", "above the rear wheels' ground"},
    {"LeaningSteering", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1 1\"/>", "front_left_steering",
     "upright (z) to steer"},
    {"OneSidedLimits", "lower=\"-0.842", "lower=\"0.1", "front_left_steering",
     "both sides of 0 rad"},
    {"WideSteering", "upper=\"0.842", "upper=\"1.842", "front_left_steering", "less than 1.57 rad"},
    {"NoLimits", kLeftSteering, "<joint name=\"front_left_steering\" type=\"continuous\">",
     "front_left_steering", "must turn about y"},
    {"NoHull", "<box size=\"3.05 2 1.47\"/>", "<mesh filename=\"hull.stl\"/>",
     "vehicle.urdf: collision", "the body has no hull"},
    {"WheelsUnderTheClearance", "<origin xyz=\"0.575 0 1.015\"/>", "<origin xyz=\"0.575 0 1.2\"/>",
     "rear wheel radius [m]: '0.34'", "the ground clearance"},
    {"InMillimetres", "<mass value=\"464\"/>", "<mass value=\"464000\"/>", "mass [kg]: '4.64",
     "from 10 to 60000"},
};

class BadRobotTest : public testing::TestWithParam<BadRobot> {};

TEST_P(BadRobotTest, IsRefusedInOneLine) {
  const std::string message = refusal(GetParam().from, GetParam().to);
  EXPECT_THAT(message, AllOf(HasSubstr(GetParam().where), HasSubstr(GetParam().message)));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
}

INSTANTIATE_TEST_SUITE_P(All, BadRobotTest, testing::ValuesIn(kBadRobots),
                         [](const auto& test) { return test.param.name; });

TEST(RobotFile, TakesThePlainVehicleSoThatEveryRefusalIsOfItsOneChange) {
  EXPECT_EQ(refusal("plain", "plain"), "");
}

TEST(RobotFile, RefusesAMissingFile) {
  try {
    read_robot("/nowhere/vehicle.urdf");
    FAIL() << "read a file that is not there";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("/nowhere/vehicle.urdf"), HasSubstr("cannot be")));
  }
}

TEST(RobotFile, FindsMeshesOfPackagesInItsOwnFolder) {
  for (const std::string name : {"package://a_robot/meshes/body.obj", "file://meshes/body.obj"}) {
    const ChangedVehicle changed("vehicle.urdf", "meshes/body.obj", name);
    const Vehicle vehicle = load_vehicle(changed.folder());
    ASSERT_EQ(vehicle.shapes.size(), 1U);
    EXPECT_EQ(vehicle.shapes[0].mesh_file,
              std::filesystem::path(changed.folder()) / "meshes/body.obj");
    EXPECT_TRUE(vehicle.notes.empty());
  }
}

TEST(RobotFile, IgnoresWhatSimulatorsAddToRobotDescriptions) {
  EXPECT_EQ(refusal("</robot>",
                    "<gazebo reference=\"base_link\"><mu1>0.9</mu1></gazebo>"
                    "<transmission name=\"t\"><type>simple</type></transmission></robot>"),
            "");
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

// Parsers that call themselves for each would run out of stack.
TEST(RobotFile, RefusesElementsNestedTooDeep) {
  EXPECT_THAT(
      refusal("</robot>", repeated("<a b='>'>", 60000) + repeated("</a>", 60000) + "</robot>"),
      AllOf(HasSubstr("vehicle.urdf: line "), HasSubstr("deeper than 256 levels")));
  // As many beside each other, and in a comment, are only many.
  EXPECT_EQ(refusal("</robot>", "<!--" + repeated("<a>", 1000) + "-->" +
                                    repeated("<a b='/>'></a><a/>", 1000) + "</robot>"),
            "");
}

TEST(RobotFile, RefusesAChainOfVeryManyLinks) {
  std::string chain;
  for (int i = 0; i < 15000; ++i) {
    chain += "<link name=\"l" + std::to_string(i) + "\"/><joint name=\"j" + std::to_string(i) +
             "\" type=\"fixed\"><parent link=\"" +
             (i == 0 ? "base_link" : "l" + std::to_string(i - 1)) + "\"/><child link=\"l" +
             std::to_string(i) + "\"/></joint>\n";
  }
  EXPECT_THAT(refusal("</robot>", chain + "</robot>"),
              AllOf(HasSubstr("vehicle.urdf: line "), HasSubstr("more than 2000 links")));
}

TEST(RobotFile, RefusesAPipeWithoutWaitingForIt) {
  const ChangedVehicle vehicle("vehicle.urdf", "<robot", "<robot");
  const std::filesystem::path file = std::filesystem::path(vehicle.folder()) / "vehicle.urdf";
  std::filesystem::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_THAT(load_message(vehicle.folder()), HasSubstr("is a pipe"));
}

}  // namespace
}  // namespace headland

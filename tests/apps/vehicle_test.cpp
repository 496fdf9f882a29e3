// headland vehicle check, and vehicles that are not driven.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace headland {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using VehicleCommand = CommandTest;

const std::filesystem::path kVehicles =
    std::filesystem::path(HEADLAND_SOURCE_DIR) / "vehicle_models";

TEST_F(VehicleCommand, TellsTheFiguresOfABuiltInVehicle) {
  const CommandResult result = headland("vehicle check transplanter --soil tilled");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("520 kg"), HasSubstr("2.00 m"), HasSubstr("Tips"),
                                HasSubstr("tilled"), Not(HasSubstr("note:"))));
}

TEST_F(VehicleCommand, GivesTheSameFiguresAsJson) {
  const CommandResult result = headland("vehicle check utility_tractor --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["name"], "utility_tractor");
  EXPECT_NEAR(json["mass_kg"].get<double>(), 4000.0, 0.01);
  // Four wheel loads carry the whole weight.
  const double loads_n =
      2.0 * (json["wheel_load_n"][0].get<double>() + json["wheel_load_n"][1].get<double>());
  EXPECT_NEAR(loads_n, 9.80665 * json["total_mass_kg"].get<double>(), 0.1);
  EXPECT_EQ(json["soil"], "firm");
}

TEST_F(VehicleCommand, DrawsIt) {
  const CommandResult result =
      headland("vehicle check four_wheel_steer_robot -o robot.png --size 640x400");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(text_of(folder_ / "robot.png"), HasSubstr("PNG"));
  EXPECT_THAT(result.out, HasSubstr("robot.png"));
}

TEST_F(VehicleCommand, ChartsIt) {
  const CommandResult result =
      headland("vehicle check skid_steer_robot --soil soft --charts charts.svg");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string svg = text_of(folder_ / "charts.svg");
  EXPECT_TRUE(svg.ends_with("</svg>\n\n")) << svg.size();
  for (const char* word : {"Net pull", "concrete_wet", "Efficiency of one motor", "state of charge",
                           "Power of driving on soft ground"}) {
    EXPECT_TRUE(svg.find(word) != std::string::npos) << word;
  }
}

TEST_F(VehicleCommand, ReplacesPlainFilesOnly) {
  const std::filesystem::path pipe = folder_ / "pipe.png";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const CommandResult result = headland("vehicle check transplanter -o pipe.png --size 640x400");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("something that is no plain file"));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST_F(VehicleCommand, SaysThatGnuplotIsMissingBeforeAnyWork) {
  for (const char* call : {"vehicle check transplanter --charts charts.svg",
                           "measure --vehicle transplanter --repeats 1000 -o costs"}) {
    const CommandResult result = headland(call, "env PATH=/nowhere");
    EXPECT_EQ(result.exit_code, 2) << call;
    EXPECT_THAT(result.err, HasSubstr("gnuplot: is not installed"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "charts.svg"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "costs"));
  }
}

TEST_F(VehicleCommand, TakesAFolderWithABrokenMeshAsAPlainBoxAndSaysSo) {
  std::filesystem::copy(kVehicles / "transplanter", folder_ / "mine",
                        std::filesystem::copy_options::recursive);
  write("mine/meshes/transplanter.obj", "f 1 2 3\nf nonsense");
  const CommandResult broken = headland("vehicle check mine -o mine.png --size 640x400");
  EXPECT_EQ(broken.exit_code, 0) << broken.err;
  EXPECT_THAT(broken.out, HasSubstr("note: transplanter.obj cannot be read: plain box"));
  std::filesystem::remove_all(folder_ / "mine/meshes");
  const CommandResult missing = headland("vehicle check mine/");
  EXPECT_EQ(missing.exit_code, 0) << missing.err;
  EXPECT_THAT(missing.out, HasSubstr("no such file; a plain box is drawn"));
}

TEST_F(VehicleCommand, ShowsNoControlCharactersOfAVehicle) {
  std::filesystem::copy(kVehicles / "transplanter", folder_ / "mine",
                        std::filesystem::copy_options::recursive);
  std::string text = text_of(folder_ / "mine/drive.yaml");
  const std::size_t at = text.find("description:");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find('\n', at) - at, "description: \"red \\e[31m\"");
  write("mine/drive.yaml", text);
  const CommandResult result = headland("vehicle check mine");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("\\x1B[31m"), Not(HasSubstr("\x1B"))));
}

TEST_F(VehicleCommand, WritesPictureAndChartsToTwoFiles) {
  const CommandResult result = headland("vehicle check transplanter -o a.png --charts ./a.png");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("another file than the picture's"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

struct BadCall {
  std::string name;
  std::string arguments;
  std::string message;
};

const BadCall kBadCalls[] = {
    {"UnknownVehicle", "vehicle check tranplanter", "nearest known vehicle is 'transplanter'"},
    {"UnknownSoil", "vehicle check transplanter --soil frm", "did you mean 'firm'?"},
    {"UnknownSubcommand", "vehicle chek transplanter", "did you mean 'check'?"},
    {"FolderWithoutVehicle", "vehicle check .", "vehicle.urdf"},
    {"PictureInAFile", "vehicle check transplanter -o tiny.yaml/x.png --size 640x640", "tiny.yaml"},
    {"ChartsOfNoFormat", "vehicle check transplanter --charts x.pdf", ".svg or .png"},
    {"PictureOfNoFormat", "vehicle check transplanter -o x.jpg", ".png"},
    {"EmptyName", "vehicle check transplanter --charts ''", "the value is empty"},
    {"TooSmallPicture", "vehicle check transplanter -o x.png --size 20x20", "--size"},
};

class BadVehicleCall : public CommandTest, public ::testing::WithParamInterface<BadCall> {};

TEST_P(BadVehicleCall, ExitsWithTwoAndOneLine) {
  const CommandResult result = headland(GetParam().arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  EXPECT_EQ(result.out, "");
}

INSTANTIATE_TEST_SUITE_P(All, BadVehicleCall, ::testing::ValuesIn(kBadCalls),
                         [](const auto& test) { return test.param.name; });

TEST_F(VehicleCommand, TellsWhatATrailedImplementPulls) {
  const CommandResult result = headland("vehicle check utility_tractor_trailed --json --soil firm");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  // ASABE D497.7: 0.85 (46 + 2.8 * 7.2) N for each of 17 tools and 8 cm.
  EXPECT_NEAR(json["draft_n"].get<double>(), 0.85 * (46.0 + 2.8 * 7.2) * 17.0 * 8.0, 1e-6);
  EXPECT_GT(json["pull_needed_n"].get<double>(), json["draft_n"].get<double>());
  EXPECT_GT(json["pull_by_grip_n"].get<double>(), json["pull_needed_n"].get<double>());
  EXPECT_GT(json["hitch_load_n"].get<double>(), 0.0);
}

TEST_F(VehicleCommand, EvaluatesATrailedImplement) {
  write("trailed.yaml",
        "field: {boundary: [[0, 0], [90, 0], [90, 70], [0, 70]]}\n"
        "vehicle: utility_tractor_trailed\n");
  const CommandResult result = headland("evaluate trailed.yaml -o out --json --size 640x400");
  ASSERT_LT(result.exit_code, 2) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["outcome"]["name"], "finished");
}

}  // namespace
}  // namespace headland

#include "render/vehicle_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "render/mesh_file.h"
#include "terrains/input_error.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kSinglePrecision_m = 1e-5;

std::filesystem::path scratch(const char* name, const char* text) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "headland_mesh";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
  return folder / name;
}

TEST(MeshFile, KeepsPlaceAndColourOfItsTriangles) {
  scratch("red.mtl", "newmtl red\nKd 1.0 0.2 0.0\n");
  const auto file =
      scratch("one.obj", "mtllib red.mtl\nv 1 2 3\nv 2 2 3\nv 1 2 4\nusemtl red\nf 1 2 3\n");
  const Mesh mesh = read_mesh(file).mesh;
  ASSERT_EQ(mesh.indices.size(), 3U);
  EXPECT_EQ(mesh.vertices[mesh.indices[0]].p, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(mesh.vertices[0].colour, (Rgba{255, 51, 0}));
  EXPECT_NEAR(std::abs(mesh.vertices[0].normal.y()), 1.0, kSinglePrecision_m);
}

TEST(MeshFile, RefusesAMissingAndABrokenOne) {
  const auto message = [](const std::filesystem::path& file) -> std::string {
    try {
      read_mesh(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_THAT(message("/nowhere/body.obj"), HasSubstr("/nowhere/body.obj"));
  EXPECT_THAT(message(scratch("noise.obj", "f 1 2 3\nf nonsense")), HasSubstr("mesh"));
  // Millimetres, and a number that none is.
  EXPECT_EQ(message(scratch("mm.obj", "v 0 0 1\nv 3600 0 1\nv 0 1500 1\nf 1 2 3\n")),
            (std::filesystem::path(testing::TempDir()) / "headland_mesh/mm.obj").string() +
                ": '3600, 0, 1': vertices within 100 m of the origin are needed, in metres");
  EXPECT_THAT(message(scratch("nan.obj", "v 0 0 1\nv nan 0 1\nv 0 1 1\nf 1 2 3\n")),
              HasSubstr("vertices within 100 m"));
}

TEST(MeshFile, NamesTheMaterialsAndTexturesThatItIsDrawnWithout) {
  const char* const triangle = "v 0 0 1\nv 1 0 1\nv 0 1 1\nvt 0 0\nusemtl paint\nf 1/1 2/1 3/1\n";
  const auto plain = scratch("plain.obj", ("mtllib gone.mtl\n" + std::string(triangle)).c_str());
  EXPECT_THAT(
      read_mesh(plain).lacks,
      ElementsAre("plain.obj names the materials gone.mtl, which cannot be read: drawn grey"));
  EXPECT_EQ(read_mesh(plain).mesh.indices.size(), 3U);
  scratch("real.mtl", "newmtl paint\nKd 1.0 0.2 0.0\n");
  EXPECT_THAT(
      read_mesh(scratch("both.obj",
                        ("mtllib gone.mtl\nmtllib real.mtl\n" + std::string(triangle)).c_str()))
          .lacks,
      ElementsAre("both.obj names the materials gone.mtl, which cannot be read: drawn grey"));
  scratch("paint.mtl", "newmtl paint\nKd 1.0 0.2 0.0\nmap_Kd wood.png\n");
  const auto wooden = scratch("wooden.obj", ("mtllib paint.mtl\n" + std::string(triangle)).c_str());
  EXPECT_THAT(
      read_mesh(wooden).lacks,
      ElementsAre("wooden.obj has the texture wood.png, which is missing: drawn in plain colour"));
  EXPECT_EQ(read_mesh(wooden).mesh.vertices[0].colour, (Rgba{255, 51, 0}));
  scratch("paint.mtl", "newmtl paint\nKd 1.0 0.2 0.0\n");
  EXPECT_TRUE(read_mesh(wooden).lacks.empty());
  for (const char* const nothing : {"", "\x01 no materials\n"}) {
    scratch("paint.mtl", nothing);
    EXPECT_THAT(read_mesh(wooden).lacks,
                ElementsAre("wooden.obj names the materials paint.mtl, which defines none: drawn "
                            "grey"));
  }
  scratch("paint.mtl", "newmtl paint\nKd 1.0 0.2 0.0\n");

  Vehicle vehicle = level_run(10.0, 10.0, 5.0).vehicle;
  Shape body;
  body.kind = ShapeKind::kMesh;
  body.mesh_file = plain;
  vehicle.shapes = {body, body};
  EXPECT_EQ(body_mesh(vehicle).lacks.size(), 1U);
  EXPECT_EQ(body_mesh(vehicle).note, "");
  EXPECT_THAT(vehicle_notes(vehicle).back(), HasSubstr("gone.mtl"));
  // Painted as a whole it lacks nothing.
  for (Shape& shape : vehicle.shapes) shape.rgb = {0.1, 0.2, 0.3};
  EXPECT_TRUE(body_mesh(vehicle).lacks.empty());
}

TEST(VehicleMesh, SaysWhyTheBodyIsAPlainBox) {
  Vehicle vehicle = level_run(10.0, 10.0, 5.0).vehicle;
  EXPECT_THAT(vehicle_mesh(vehicle, {}).note, HasSubstr("no mesh"));
  Shape body;
  body.kind = ShapeKind::kMesh;
  body.mesh_file = "/nowhere/body.obj";
  vehicle.shapes = {body};
  EXPECT_THAT(vehicle_mesh(vehicle, {}).note, HasSubstr("body.obj cannot be read"));
  vehicle.shapes[0].mesh_file = scratch("body.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
  EXPECT_EQ(vehicle_mesh(vehicle, {}).note, "");
}

TEST(VehicleMesh, StandsOnItsWheelsAndReachesToItsSides) {
  const Vehicle vehicle = level_run(10.0, 10.0, 5.0).vehicle;
  RunSample sample;
  sample.implement_down = false;
  const Mesh mesh = vehicle_mesh(vehicle, sample).mesh;
  float low = 1e9F;
  float left = -1e9F;
  for (const MeshVertex& vertex : mesh.vertices) {
    low = std::min(low, vertex.p.z());
    left = std::max(left, vertex.p.y());
  }
  // One of 32 lugs stands within 1/64 of a turn of the lowest place.
  EXPECT_LE(low, 0.75F * (1.0F - std::cos(0.05F)));
  EXPECT_GE(low, -kSinglePrecision_m);
  EXPECT_NEAR(left, 0.5 * vehicle.implement.working_width_m, kSinglePrecision_m);
}

TEST(VehicleMesh, PoseFollowsTheAngleConventions) {
  RunSample sample;
  sample.p_WB = {10.0, 20.0, 105.0};
  sample.yaw_rad = 0.5 * 3.14159265358979323846;
  const Relief relief{100.0, 1.0};
  const Eigen::Vector3d ahead(2.0, 0.0, 0.0);
  const Eigen::Vector3d right(0.0, -1.0, 0.0);
  EXPECT_TRUE((pose_in_D(sample, relief) * ahead).isApprox(Eigen::Vector3d(10.0, 22.0, 5.0)));
  sample.pitch_rad = 0.1;
  EXPECT_NEAR((pose_in_D(sample, relief) * ahead).z(), 5.0 + 2.0 * std::sin(0.1),
              kSinglePrecision_m);
  sample.pitch_rad = 0.0;
  sample.roll_rad = 0.2;
  EXPECT_NEAR((pose_in_D(sample, relief) * right).z(), 5.0 - std::sin(0.2), kSinglePrecision_m);
}

TEST(VehicleMesh, PoseOnStretchedReliefStaysOnTheGround) {
  // On a slope of 0.1 along the heading, stretched three times, the nose follows 0.3.
  RunSample sample;
  sample.pitch_rad = std::atan(0.1);
  const Eigen::Isometry3d X = pose_in_D(sample, {0.0, 3.0});
  const Eigen::Vector3d ahead = X.linear() * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(ahead.z() / ahead.x(), 0.3, kSinglePrecision_m);
}

}  // namespace
}  // namespace headland

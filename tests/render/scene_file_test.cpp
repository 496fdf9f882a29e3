#include "render/scene_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <cmath>

#include "render/gltf.h"
#include "render/ground_images.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

constexpr float kFloat_m = 1e-4F;

// The file read back, each node's vertices in the file's own frame.
class ReadGlb {
 public:
  explicit ReadGlb(const std::string& glb)
      : scene_(importer_.ReadFileFromMemory(glb.data(), glb.size(), 0, "glb")) {}

  const aiNode* node(const char* name) const { return scene_->mRootNode->FindNode(name); }

  const aiMesh& mesh(const char* name) const { return *scene_->mMeshes[node(name)->mMeshes[0]]; }

  std::vector<Eigen::Vector3f> points(const char* name) const {
    aiMatrix4x4 X;
    for (const aiNode* at = node(name); at != nullptr; at = at->mParent) {
      X = at->mTransformation * X;
    }
    std::vector<Eigen::Vector3f> points;
    const aiMesh& part = mesh(name);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D p = X * part.mVertices[i];
      points.emplace_back(p.x, p.y, p.z);
    }
    return points;
  }

 private:
  Assimp::Importer importer_;
  const aiScene* scene_;
};

TEST(Gltf, KeepsPlacesAndStandsUpright) {
  const Mesh box = box_mesh({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}, {255, 0, 0});
  GltfNode root{.name = "root"};
  root.children = {
      {.name = "box", .X = Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, 0.0)), .mesh = &box},
      {.name = "line", .lines = {{{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}, false}}}};
  const ReadGlb file(glb_of(root));
  float top = 0.0F;
  for (const Eigen::Vector3f& p : file.points("box")) {
    EXPECT_GE(p.x(), 10.0F - kFloat_m);
    EXPECT_LE(p.z(), kFloat_m);  // north is -z
    top = std::max(top, p.y());
  }
  EXPECT_NEAR(top, 3.0F, kFloat_m);
  const auto line = file.points("line");
  ASSERT_EQ(line.size(), 2U);
  EXPECT_NEAR((line[1] - Eigen::Vector3f(4.0F, 6.0F, -5.0F)).norm(), 0.0F, kFloat_m);
  EXPECT_EQ(file.mesh("line").mPrimitiveTypes, static_cast<unsigned>(aiPrimitiveType_LINE));
  ASSERT_TRUE(file.mesh("box").HasVertexColors(0));
  EXPECT_EQ(file.mesh("box").mColors[0][0].r, 1.0F);
  EXPECT_EQ(file.mesh("box").mColors[0][0].g, 0.0F);
}

TEST(SceneFile, TheGroundIsTheTerrain) {
  const MadeRun made = rolling_run(120.0, 6.0);
  const SceneFile scene = scene_file(made.scene());
  const ReadGlb file(scene.glb);
  const auto points = file.points("terrain");
  EXPECT_LE(points.size(), static_cast<std::size_t>(kSceneNodes) * kSceneNodes);
  float lowest = 1e9F;
  for (const Eigen::Vector3f& p : points) {
    const double height_m = surface_at(made.terrain, p.x(), -p.z()).height_m;
    ASSERT_NEAR(p.y(), height_m - scene.base_m, 1e-3);
    lowest = std::min(lowest, p.y());
  }
  EXPECT_NEAR(lowest, 0.0F, kFloat_m);
  EXPECT_FALSE(file.mesh("terrain").HasVertexColors(0));
}

TEST(SceneFile, HasTheMachineInParts) {
  const MadeRun made = rolling_run(120.0, 6.0);
  const ReadGlb file(scene_file(made.scene()).glb);
  const aiNode* wheel = file.node("wheel_3");  // front right
  ASSERT_NE(wheel, nullptr);
  EXPECT_EQ(std::string(wheel->mParent->mName.C_Str()), "vehicle");
  EXPECT_NEAR(wheel->mTransformation.a4, made.vehicle.front.x_B_m, kFloat_m);
  EXPECT_NEAR(wheel->mTransformation.b4, -0.5 * made.vehicle.front.track_m, kFloat_m);
  // Left and right wheels share a mesh.
  EXPECT_EQ(wheel->mMeshes[0], file.node("wheel_2")->mMeshes[0]);
  const auto lowest = [&](const char* name) {
    float low = 1e9F;
    for (const Eigen::Vector3f& p : file.points(name)) low = std::min(low, p.y());
    return low;
  };
  EXPECT_GT(lowest("up"), lowest("down") + 0.3F);
}

TEST(SceneFile, IsTheSameAgainAndDoesWithoutARun) {
  MadeRun made = rolling_run(60.0, 6.0);
  EXPECT_EQ(scene_file(made.scene()).glb, scene_file(made.scene()).glb);
  made.path.segments.clear();
  made.run = {};
  made.vehicle.implement.working_width_m = 0.0;
  const ReadGlb file(scene_file(made.scene()).glb);
  EXPECT_EQ(file.node("passes")->mNumMeshes, 0U);
  EXPECT_EQ(file.node("down")->mNumMeshes, 0U);
}

TEST(GroundImages, CoverageHasTheMapsColoursAtItsPlaces) {
  MadeRun made = level_run(20.0, 10.0, 5.0);
  cover_strip(made.coverage, {2.0, 5.0}, {18.0, 5.0}, 2.0);
  cover_strip(made.coverage, {2.0, 5.0}, {10.0, 5.0}, 2.0);
  const GroundImage ground = coverage_image(made.coverage, 10000);
  const auto pixel = [&](double x_m, double y_m) {
    const int column = static_cast<int>((x_m - ground.extent.low.x()) / made.coverage.cell_m);
    const int row = static_cast<int>((ground.extent.high.y() - y_m) / made.coverage.cell_m);
    const auto at = static_cast<std::size_t>(4 * (row * ground.image.width + column));
    const auto& rgba = ground.image.rgba;
    return Rgba{rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
  };
  EXPECT_EQ(pixel(5.0, 5.1), colours::kTwice);
  EXPECT_EQ(pixel(15.0, 5.1), colours::kOnce);
  EXPECT_EQ(pixel(15.0, 8.1), colours::kMissed);
  EXPECT_EQ(pixel(-0.4, -0.4).a, 0);
  const GroundImage coarse = coverage_image(made.coverage, 16);
  EXPECT_LE(std::max(coarse.image.width, coarse.image.height), 16);
}

TEST(GroundImages, ReliefFillsItsExtentWithSquarePixels) {
  const MadeRun made = rolling_run(80.0, 6.0);
  const GroundImage ground = draw_relief(made.scene(), 200);
  EXPECT_EQ(std::max(ground.image.width, ground.image.height), 200);
  const Eigen::Vector2d size = ground.extent.size();
  EXPECT_NEAR(ground.image.width / size.x(), ground.image.height / size.y(), 0.02);
  // No pixel is left of the background.
  for (std::size_t i = 0; i < ground.image.rgba.size(); i += 4) {
    const auto& rgba = ground.image.rgba;
    ASSERT_FALSE((Rgba{rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]} == colours::kPaper)) << i;
  }
}

}  // namespace
}  // namespace headland

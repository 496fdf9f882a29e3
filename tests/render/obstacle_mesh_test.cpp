#include "render/obstacle_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace headland {
namespace {

Eigen::AlignedBox3d box_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const MeshVertex& vertex : mesh.vertices) box.extend(vertex.p.cast<double>().eval());
  return box;
}

constexpr double kBarrierPrecision_m = 1e-5;

// Volume by the divergence theorem; positive when the triangles face outwards.
double volume_m3(const Mesh& mesh) {
  double six_m3 = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) {
      return mesh.vertices[mesh.indices[i + k]].p.cast<double>().eval();
    };
    six_m3 += p(0).dot(p(1).cross(p(2)));
  }
  return six_m3 / 6.0;
}

TEST(BarrierMesh, AWallIsASolidOfItsThicknessOverTheGround) {
  const Obstacle wall{ObstacleKind::kWall, {0.0, 0.0}, 0.2, 1.5, {4.0, 0.0}};
  const Mesh mesh = barrier_mesh(wall, {0.0, 0.0, 10.0}, {4.0, 0.0, 11.0});
  const Eigen::AlignedBox3d box = box_of(mesh);
  EXPECT_NEAR(box.max().z(), 11.0 + 1.5, kBarrierPrecision_m);
  EXPECT_LT(box.min().z(), 10.0);  // its foot is in the ground
  EXPECT_NEAR(box.sizes().x(), 4.0, kBarrierPrecision_m);
  EXPECT_NEAR(box.sizes().y(), 0.4, kBarrierPrecision_m);
  const double height_m = 10.0 + 1.5 - box.min().z();
  EXPECT_NEAR(volume_m3(mesh), 4.0 * 0.4 * height_m, 1e-4);
}

TEST(BarrierMesh, AFenceHasAPostAtEitherEndAndIsMostlyAir) {
  const Obstacle fence{ObstacleKind::kFence, {0.0, 0.0}, 0.05, 1.2, {0.0, 2.5}};
  const Mesh mesh = barrier_mesh(fence, {0.0, 0.0, 3.0}, {0.0, 2.5, 3.0});
  const Eigen::AlignedBox3d box = box_of(mesh);
  EXPECT_NEAR(box.min().z(), 3.0, kBarrierPrecision_m);
  EXPECT_NEAR(box.max().z(), 4.2, kBarrierPrecision_m);
  // Posts have ten sides: a corner may miss the circle's edge by r (1 - cos 18 deg) at either end.
  EXPECT_NEAR(box.sizes().y(), 2.5 + 0.1, 2.0 * 0.05 * 0.05);
  EXPECT_LT(volume_m3(mesh), 0.2 * 2.5 * 0.1 * 1.2);
  EXPECT_GT(volume_m3(mesh), 0.0);
}

}  // namespace
}  // namespace headland

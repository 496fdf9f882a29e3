// What is left out of a picture is nowhere in it.
#include "render/sight.h"

#include <gtest/gtest.h>

#include <random>

#include "render/camera.h"

namespace headland {
namespace {

Camera some_camera() {
  Camera camera;
  camera.eye_D = {3.0, -2.0, 6.0};
  camera.target_D = {15.0, 5.0, 1.0};
  camera.focal_px = 500.0;
  camera.view_px = {0.0, 0.0, 640.0, 400.0};
  camera.centre_px = {320.0, 220.0};
  return camera;
}

bool seen(const Camera& camera, const Eigen::Vector3f& p_D) {
  const Eigen::Vector4f clip = clip_from_D(camera) * p_D.homogeneous();
  return clip.w() > 0.0F && (clip.head<2>().array().abs() <= clip.w()).all() &&
         clip.z() >= -clip.w();
}

TEST(Sight, MissesOnlyWhatIsNotSeen) {
  const Camera camera = some_camera();
  const Sight sight(clip_from_D(camera));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-40.0F, 60.0F);
  std::uniform_real_distribution<float> size(0.0F, 20.0F);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  const auto point = [&] {
    return Eigen::Vector3f(place(random), place(random), 0.2F * place(random));
  };
  int missed = 0;
  int shown = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector3f a = point();
    const Eigen::Vector3f b = a + Eigen::Vector3f(size(random), size(random), size(random));
    const Eigen::Vector3f c = a + Eigen::Vector3f(size(random), -size(random), 0.0F);
    const bool no_triangle = sight.misses_triangle(a, b, c);
    const bool no_box = sight.misses_box(a, b);
    missed += no_triangle ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      const float u = share(random);
      const float v = (1.0F - u) * share(random);
      const bool in_triangle = seen(camera, a + u * (b - a) + v * (c - a));
      const Eigen::Array3f w(share(random), share(random), share(random));
      const bool in_box = seen(camera, a + (w * (b - a).array()).matrix());
      shown += in_triangle ? 1 : 0;
      ASSERT_FALSE(no_triangle && in_triangle);
      ASSERT_FALSE(no_box && in_box);
    }
  }
  // Both happen often: most of the ground lies beside a camera's view.
  EXPECT_GT(missed, 500);
  EXPECT_GT(shown, 500);
}

TEST(Sight, DropsTrianglesBehindTheCameraAndKeepsThoseAhead) {
  const Camera camera = some_camera();
  Mesh mesh = box_mesh({14.0, 4.0, 0.0}, {16.0, 6.0, 2.0}, colours::kInk);
  const std::size_t ahead = mesh.indices.size();
  append(mesh, box_mesh({-20.0, -20.0, 0.0}, {-10.0, -10.0, 2.0}, colours::kInk),
         Eigen::Isometry3d::Identity());
  drop_unseen(mesh, Sight(clip_from_D(camera)));
  EXPECT_EQ(mesh.indices.size(), ahead);
}

}  // namespace
}  // namespace headland

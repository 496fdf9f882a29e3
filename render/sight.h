// What a camera cannot see need not be drawn.
#pragma once

#include <Eigen/Core>

#include "render/mesh.h"

namespace headland {

// Of a camera's clip_from_D (render/camera.h), without its far end. What is told to be out of sight
// is; what is not may be out of sight all the same.
class Sight {
 public:
  explicit Sight(const Eigen::Matrix4f& clip_from_D);
  // The axis-parallel box between two corners in D.
  bool misses_box(const Eigen::Vector3f& low_D, const Eigen::Vector3f& high_D) const;
  bool misses_triangle(const Eigen::Vector3f& a_D, const Eigen::Vector3f& b_D,
                       const Eigen::Vector3f& c_D) const;

 private:
  // Rows: left, right, bottom, top, near; a point is beyond one where its product is negative.
  Eigen::Matrix<float, 5, 4> planes_;
};

// The triangles that the camera may see.
void drop_unseen(Mesh& mesh, const Sight& sight);

}  // namespace headland

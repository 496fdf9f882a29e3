#include "render/sight.h"

namespace headland {

Sight::Sight(const Eigen::Matrix4f& clip) {
  planes_ << clip.row(3) + clip.row(0), clip.row(3) - clip.row(0), clip.row(3) + clip.row(1),
      clip.row(3) - clip.row(1), clip.row(3) + clip.row(2);
}

bool Sight::misses_box(const Eigen::Vector3f& low_D, const Eigen::Vector3f& high_D) const {
  for (Eigen::Index k = 0; k < planes_.rows(); ++k) {
    const Eigen::RowVector3f normal = planes_.row(k).head<3>();
    // The corner that lies farthest on the near side of the plane.
    const Eigen::Vector3f corner = (normal.transpose().array() > 0.0F).select(high_D, low_D);
    if (normal.dot(corner) + planes_(k, 3) < 0.0F) return true;
  }
  return false;
}

bool Sight::misses_triangle(const Eigen::Vector3f& a_D, const Eigen::Vector3f& b_D,
                            const Eigen::Vector3f& c_D) const {
  using Sides = Eigen::Array<float, 5, 1>;
  const Sides a = (planes_ * a_D.homogeneous()).array();
  const Sides b = (planes_ * b_D.homogeneous()).array();
  const Sides c = (planes_ * c_D.homogeneous()).array();
  return (a.max(b).max(c) < 0.0F).any();
}

void drop_unseen(Mesh& mesh, const Sight& sight) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].p; };
    if (sight.misses_triangle(at(0), at(1), at(2))) continue;
    for (std::size_t k = 0; k < 3; ++k) mesh.indices[kept + k] = mesh.indices[i + k];
    kept += 3;
  }
  mesh.indices.resize(kept);
}

}  // namespace headland

#include "vehicle_models/shape.h"

namespace headland {

Eigen::AlignedBox3d bounds_of(const Shape& shape) {
  const Eigen::Matrix3d R = shape.X.linear();
  Eigen::Vector3d reach = Eigen::Vector3d::Zero();
  switch (shape.kind) {
    case ShapeKind::kBox:
      reach = 0.5 * R.cwiseAbs() * shape.size;
      break;
    case ShapeKind::kCylinder: {
      const Eigen::Array3d along = R.col(2).array();
      reach = 0.5 * shape.size.z() * along.abs() +
              shape.size.x() * (1.0 - along.square()).max(0.0).sqrt();
      break;
    }
    case ShapeKind::kSphere:
      reach = shape.size;
      break;
    case ShapeKind::kMesh:
      return {};
  }
  return {shape.X.translation() - reach, shape.X.translation() + reach};
}

}  // namespace headland

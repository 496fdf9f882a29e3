#include "render/mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace headland {
namespace {

using Point = Eigen::Vector3d;

// A flat quadrilateral with its own vertices, so that its edges stay sharp.
void add_quad(Mesh& mesh, const Point& a, const Point& b, const Point& c, const Point& d,
              Rgba colour) {
  const Point normal = (c - a).cross(d - b).normalized();
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Point* p : {&a, &b, &c, &d}) {
    mesh.vertices.push_back({p->cast<float>(), normal.cast<float>(), colour});
  }
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
}

}  // namespace

void append(Mesh& mesh, const Mesh& part, const Eigen::Isometry3d& X) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const MeshVertex& vertex : part.vertices) {
    const Point p = X * vertex.p.cast<double>();
    const Point normal = X.linear() * vertex.normal.cast<double>();
    mesh.vertices.push_back({p.cast<float>(), normal.cast<float>(), vertex.colour});
  }
  for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

Mesh box_mesh(const Point& low, const Point& high, Rgba colour) {
  const auto corner = [&](int x, int y, int z) {
    return Point(x != 0 ? high.x() : low.x(), y != 0 ? high.y() : low.y(),
                 z != 0 ? high.z() : low.z());
  };
  Mesh mesh;
  add_quad(mesh, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1), colour);
  add_quad(mesh, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0), colour);
  add_quad(mesh, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1), colour);
  add_quad(mesh, corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), colour);
  add_quad(mesh, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1), colour);
  add_quad(mesh, corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), colour);
  return mesh;
}

Mesh prism_mesh(const std::array<Point, 4>& bottom, const std::array<Point, 4>& top, Rgba colour) {
  Mesh mesh;
  add_quad(mesh, top[0], top[1], top[2], top[3], colour);
  add_quad(mesh, bottom[3], bottom[2], bottom[1], bottom[0], colour);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    add_quad(mesh, bottom[i], bottom[next], top[next], top[i], colour);
  }
  return mesh;
}

Mesh revolved_mesh(std::span<const Eigen::Vector2d> radius_z, int sides, Rgba colour) {
  Mesh mesh;
  for (std::size_t i = 1; i < radius_z.size(); ++i) {
    const Eigen::Vector2d& low = radius_z[i - 1];
    const Eigen::Vector2d& high = radius_z[i];
    // Smooth around the axis, sharp between the profile's pieces.
    const Eigen::Vector2d outward =
        Eigen::Vector2d(high.y() - low.y(), low.x() - high.x()).normalized();
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int side = 0; side <= sides; ++side) {
      const double angle = 2.0 * std::numbers::pi * side / sides;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const Point normal(outward.x() * c, outward.x() * s, outward.y());
      for (const Eigen::Vector2d& ring : {low, high}) {
        const Point p(ring.x() * c, ring.x() * s, ring.y());
        mesh.vertices.push_back({p.cast<float>(), normal.cast<float>(), colour});
      }
    }
    for (int side = 0; side < sides; ++side) {
      const std::uint32_t a = first + 2 * static_cast<std::uint32_t>(side);
      for (const std::uint32_t k : {0U, 2U, 3U, 0U, 3U, 1U}) mesh.indices.push_back(a + k);
    }
  }
  return mesh;
}

Mesh bar_mesh(const Point& from, const Point& to, double radius, Rgba colour) {
  constexpr int kSides = 10;
  const double length = (to - from).norm();
  const std::array<Eigen::Vector2d, 4> profile = {
      {{0.0, 0.0}, {radius, 0.0}, {radius, length}, {0.0, length}}};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Point::UnitZ(), to - from).toRotationMatrix();
  X.translation() = from;
  Mesh mesh;
  append(mesh, revolved_mesh(profile, kSides, colour), X);
  return mesh;
}

GlTriangles upload(const Mesh& mesh) {
  const std::array<GlAttribute, 3> attributes = {
      {{3, GL_FLOAT, offsetof(MeshVertex, p)},
       {3, GL_FLOAT, offsetof(MeshVertex, normal)},
       {4, GL_UNSIGNED_BYTE, offsetof(MeshVertex, colour)}}};
  return {std::as_bytes(std::span(mesh.vertices)), sizeof(MeshVertex), attributes, mesh.indices};
}

}  // namespace headland

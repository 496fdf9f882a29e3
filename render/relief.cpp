#include "render/relief.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

using Point = Eigen::Vector3d;

// Columns or rows of nodes that are drawn: the ends and every `step`-th between, at least
// `least_step`.
std::vector<int> drawn_nodes(double low, double high, int count, int least_step) {
  const int first = std::clamp(static_cast<int>(std::ceil(low - 1e-9)), 0, count - 2);
  const int last = std::clamp(static_cast<int>(std::floor(high + 1e-9)), first + 1, count - 1);
  const int step = std::max((last - first + kMaxNodes - 2) / (kMaxNodes - 1), least_step);
  std::vector<int> nodes;
  for (int i = first; i < last; i += step) nodes.push_back(i);
  nodes.push_back(last);
  return nodes;
}

struct Nodes {
  std::vector<int> columns;
  std::vector<int> rows;
};

Nodes nodes_inside(const Heightfield& terrain, const Extent& extent, double spacing_m = 0.0) {
  const Eigen::Vector2d low = (extent.low - terrain.origin_W) / terrain.cell_m;
  const Eigen::Vector2d high = (extent.high - terrain.origin_W) / terrain.cell_m;
  constexpr double kMostStep = 1e6;
  const int step = static_cast<int>(std::clamp(spacing_m / terrain.cell_m, 1.0, kMostStep));
  return {drawn_nodes(low.x(), high.x(), terrain.columns, step),
          drawn_nodes(low.y(), high.y(), terrain.rows, step)};
}

Point node_D(const Heightfield& terrain, const Relief& relief, int column, int row) {
  const Eigen::Vector2d p = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(column, row);
  return {p.x(), p.y(), (terrain.at(column, row) - relief.base_m) * relief.exaggeration};
}

Eigen::Vector2d slope_at(const Heightfield& terrain, int column, int row) {
  const int west = std::max(column - 1, 0);
  const int east = std::min(column + 1, terrain.columns - 1);
  const int south = std::max(row - 1, 0);
  const int north = std::min(row + 1, terrain.rows - 1);
  return {
      (terrain.at(east, row) - terrain.at(west, row)) / ((east - west) * terrain.cell_m),
      (terrain.at(column, north) - terrain.at(column, south)) / ((north - south) * terrain.cell_m)};
}

}  // namespace

Extent extent_of(const Ring& ring) {
  Extent extent{ring.front(), ring.front()};
  for (const Eigen::Vector2d& p : ring) {
    extent.low = extent.low.cwiseMin(p);
    extent.high = extent.high.cwiseMax(p);
  }
  return extent;
}

Extent extent_of(const Heightfield& terrain) {
  const Eigen::Vector2d size(terrain.columns - 1, terrain.rows - 1);
  return {terrain.origin_W, terrain.origin_W + terrain.cell_m * size};
}

Extent grown(const Extent& extent, double by_m) {
  const Eigen::Vector2d by = Eigen::Vector2d::Constant(by_m);
  return {extent.low - by, extent.high + by};
}

Extent overlap(const Extent& a, const Extent& b) {
  return {a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
}

HeightRange height_range(const Heightfield& terrain, const Extent& extent) {
  const Nodes nodes = nodes_inside(terrain, extent);
  const double first = terrain.at(nodes.columns.front(), nodes.rows.front());
  HeightRange range{first, first};
  for (const int row : nodes.rows) {
    for (const int column : nodes.columns) {
      range.low_m = std::min(range.low_m, terrain.at(column, row));
      range.high_m = std::max(range.high_m, terrain.at(column, row));
    }
  }
  return range;
}

double steep_slope(const Heightfield& terrain, const Extent& extent) {
  const Nodes nodes = nodes_inside(terrain, extent);
  std::vector<double> slopes;
  for (const int row : nodes.rows) {
    for (const int column : nodes.columns) slopes.push_back(slope_at(terrain, column, row).norm());
  }
  const auto place = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() * 9 / 10);
  std::nth_element(slopes.begin(), place, slopes.end());
  return *place;
}

Point on_ground(const Heightfield& terrain, const Relief& relief, const Eigen::Vector2d& p_W) {
  const double height_m = surface_at(terrain, p_W.x(), p_W.y()).height_m;
  return {p_W.x(), p_W.y(), (height_m - relief.base_m) * relief.exaggeration};
}

std::vector<Point> draped(const Heightfield& terrain, const Relief& relief,
                          const std::vector<Eigen::Vector2d>& line, bool closed, double spacing_m,
                          double lift_m) {
  const Point lift(0.0, 0.0, lift_m);
  std::vector<Point> points;
  const std::size_t legs = closed ? line.size() : line.size() - 1;
  for (std::size_t i = 0; i < legs && !line.empty(); ++i) {
    const Eigen::Vector2d& from = line[i];
    const Eigen::Vector2d& to = line[(i + 1) % line.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / spacing_m)));
    for (int k = 0; k < pieces; ++k) {
      points.push_back(on_ground(terrain, relief, from + (to - from) * k / pieces) + lift);
    }
  }
  if (!closed && !line.empty()) points.push_back(on_ground(terrain, relief, line.back()) + lift);
  return points;
}

namespace {

// Nodes of an axis: all near the centre, ever fewer with distance. Each is a whole multiple of its
// spacing, so that they stay the same ones while the centre moves.
std::vector<int> graded_nodes(double low, double high, double centre, double cell_m, int count) {
  constexpr double kFinest_m = 0.5;
  constexpr double kDistancePerSpacing = 22.0;
  const int first = std::clamp(static_cast<int>(std::ceil(low - 1e-9)), 0, count - 2);
  const int last = std::clamp(static_cast<int>(std::floor(high + 1e-9)), first + 1, count - 1);
  std::vector<int> nodes = {first};
  for (int i = first + 1; i < last; ++i) {
    const double away_m = std::abs(i - centre) * cell_m;
    const double wanted_m = std::max(kFinest_m, away_m / kDistancePerSpacing);
    int step = 1;
    while (2 * step * cell_m <= wanted_m) step *= 2;
    if (i % step == 0) nodes.push_back(i);
  }
  nodes.push_back(last);
  return nodes;
}

Mesh mesh_of(const Heightfield& terrain, const Relief& relief, const Nodes& nodes, Rgba colour) {
  Mesh mesh;
  mesh.vertices.reserve(nodes.columns.size() * nodes.rows.size());
  mesh.indices.reserve(6 * nodes.columns.size() * nodes.rows.size());
  for (const int row : nodes.rows) {
    for (const int column : nodes.columns) {
      const Eigen::Vector2d slope = relief.exaggeration * slope_at(terrain, column, row);
      const Point normal = Point(-slope.x(), -slope.y(), 1.0).normalized();
      mesh.vertices.push_back(
          {node_D(terrain, relief, column, row).cast<float>(), normal.cast<float>(), colour});
    }
  }
  const auto width = static_cast<std::uint32_t>(nodes.columns.size());
  for (std::uint32_t j = 0; j + 1 < nodes.rows.size(); ++j) {
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t sw = j * width + i;
      const std::uint32_t nw = sw + width;
      // The same diagonal as surface_at, so that what stands on the ground touches it.
      for (const std::uint32_t k : {sw, sw + 1, nw, sw + 1, nw + 1, nw}) mesh.indices.push_back(k);
    }
  }
  return mesh;
}

}  // namespace

Mesh relief_mesh(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                 Rgba colour, double spacing_m) {
  return mesh_of(terrain, relief, nodes_inside(terrain, extent, spacing_m), colour);
}

Mesh graded_relief_mesh(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                        const Eigen::Vector2d& centre_W, Rgba colour) {
  const auto in_cells = [&](const Eigen::Vector2d& p_W) -> Eigen::Vector2d {
    return (p_W - terrain.origin_W) / terrain.cell_m;
  };
  const Eigen::Vector2d low = in_cells(extent.low);
  const Eigen::Vector2d high = in_cells(extent.high);
  const Eigen::Vector2d centre = in_cells(centre_W);
  const Nodes nodes{graded_nodes(low.x(), high.x(), centre.x(), terrain.cell_m, terrain.columns),
                    graded_nodes(low.y(), high.y(), centre.y(), terrain.cell_m, terrain.rows)};
  return mesh_of(terrain, relief, nodes, colour);
}

Mesh relief_sides(const Heightfield& terrain, const Relief& relief, const Extent& extent,
                  double bottom_D, Rgba colour) {
  const Nodes nodes = nodes_inside(terrain, extent);
  // Around the edge counter-clockwise seen from above.
  std::vector<Point> edge;
  for (const int i : nodes.columns) edge.push_back(node_D(terrain, relief, i, nodes.rows.front()));
  for (const int j : nodes.rows) edge.push_back(node_D(terrain, relief, nodes.columns.back(), j));
  for (auto i = nodes.columns.rbegin(); i != nodes.columns.rend(); ++i) {
    edge.push_back(node_D(terrain, relief, *i, nodes.rows.back()));
  }
  for (auto j = nodes.rows.rbegin(); j != nodes.rows.rend(); ++j) {
    edge.push_back(node_D(terrain, relief, nodes.columns.front(), *j));
  }
  Mesh mesh;
  for (std::size_t i = 1; i < edge.size(); ++i) {
    const Point along = edge[i] - edge[i - 1];
    if (along.head<2>().norm() <= 0.0) continue;
    const Point normal = Point(along.y(), -along.x(), 0.0).normalized();
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Point& top : {edge[i - 1], edge[i]}) {
      const Point foot(top.x(), top.y(), bottom_D);
      mesh.vertices.push_back({foot.cast<float>(), normal.cast<float>(), colour});
      mesh.vertices.push_back({top.cast<float>(), normal.cast<float>(), colour});
    }
    for (const std::uint32_t k : {0U, 2U, 3U, 0U, 3U, 1U}) mesh.indices.push_back(first + k);
  }
  return mesh;
}

}  // namespace headland

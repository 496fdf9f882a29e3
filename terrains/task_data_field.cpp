// Partfields of task data as fields: which rings are outlines and which are holes is a matter of
// how they lie, not only of what they are marked as.
#include <fmt/format.h>

#include <algorithm>

#include "terrains/given_polygon.h"
#include "terrains/input_error.h"
#include "terrains/task_data.h"

namespace headland {
namespace {

// Whether `inner` lies in `outer`, told from some of its points: rings that cross are refused when
// the field is checked.
bool encloses(const Ring& outer, const Ring& inner) {
  constexpr std::size_t kMostPoints = 64;
  const std::size_t stride = 1 + inner.size() / kMostPoints;
  for (std::size_t i = 0; i < inner.size(); i += stride) {
    if (!inside_ring(outer, inner[i]) && std::ranges::count(outer, inner[i]) == 0) return false;
  }
  return true;
}

bool is_no_ground(TaskPolygonType type) {
  return type == TaskPolygonType::kWater || type == TaskPolygonType::kBuilding ||
         type == TaskPolygonType::kObstacle || type == TaskPolygonType::kWindbreak;
}

// The outlines of a polygon, each with the rings inside it as holes. One marked as an outline
// inside another can only be a hole.
void append_outlines(const TaskPolygon& polygon, const GivenPolygon& like,
                     std::vector<GivenPolygon>& outlines) {
  const std::size_t first = outlines.size();
  std::vector<const Ring*> inner;
  for (const TaskLine& ring : polygon.rings) {
    const auto around = [&](const TaskLine& other) {
      return &other != &ring && other.type == TaskLineType::kExterior &&
             encloses(other.lon_lat_deg, ring.lon_lat_deg);
    };
    if (ring.type == TaskLineType::kInterior || std::ranges::any_of(polygon.rings, around)) {
      inner.push_back(&ring.lon_lat_deg);
    } else {
      outlines.push_back(like);
      outlines.back().boundary = ring.lon_lat_deg;
    }
  }
  if (outlines.size() == first) return;
  for (const Ring* hole : inner) {
    const auto begin = outlines.begin() + static_cast<std::ptrdiff_t>(first);
    const auto owner = std::find_if(begin, outlines.end(), [&](const GivenPolygon& outline) {
      return encloses(outline.boundary, *hole);
    });
    // One that lies in none is refused with its place when the field is checked.
    (owner == outlines.end() ? *begin : *owner).holes.push_back(*hole);
  }
}

void add_no_ground(const Partfield& partfield, GivenPolygon& outline) {
  for (const TaskPolygon& polygon : partfield.polygons) {
    if (!is_no_ground(polygon.type)) continue;
    for (const TaskLine& ring : polygon.rings) {
      if (ring.type != TaskLineType::kExterior) continue;
      const auto meets = [&](const Eigen::Vector2d& point) {
        return inside_ring(outline.boundary, point);
      };
      const auto known = [&](const Ring& hole) { return encloses(hole, ring.lon_lat_deg); };
      if (std::ranges::none_of(ring.lon_lat_deg, meets)) continue;
      // Often told twice: as an interior ring and as what it is.
      if (std::ranges::none_of(outline.holes, known)) outline.holes.push_back(ring.lon_lat_deg);
    }
  }
}

void add_obstacles(const Partfield& partfield, GivenPolygon& outline) {
  const auto is_in = [&](const Eigen::Vector2d& point) {
    return inside_ring(outline.boundary, point);
  };
  const std::string place = partfield.name + ": obstacles";
  for (const TaskPoint& point : partfield.points) {
    if (point.type != TaskPointType::kObstacle || !is_in(point.lon_lat_deg)) continue;
    ObstacleSource obstacle = default_obstacle(ObstacleKind::kPole);
    for (const ObstacleKind kind : kEveryObstacleKind) {
      if (!runs_along_line(kind) && point.name == obstacle_kind_name(kind)) obstacle.kind = kind;
    }
    obstacle.line = {point.lon_lat_deg};
    obstacle.place = place;
    outline.obstacles.push_back(obstacle);
  }
  for (const TaskLine& line : partfield.lines) {
    const bool fence = line.type == TaskLineType::kFence;
    if ((!fence && line.type != TaskLineType::kObstacle) || line.lon_lat_deg.size() < 2 ||
        std::ranges::none_of(line.lon_lat_deg, is_in)) {
      continue;
    }
    ObstacleSource obstacle = default_obstacle(fence ? ObstacleKind::kFence : ObstacleKind::kWall);
    if (line.width_m > 0.0) {
      obstacle.radius_m = 0.5 * std::clamp(line.width_m, kMinThickness_m, kMaxThickness_m);
    }
    obstacle.line = line.lon_lat_deg;
    obstacle.place = place;
    outline.obstacles.push_back(obstacle);
  }
}

}  // namespace

std::vector<GivenPolygon> polygons_of_task_data(const std::filesystem::path& file) {
  std::vector<GivenPolygon> outlines;
  for (const Partfield& partfield : read_task_data(file).partfields) {
    GivenPolygon like;
    like.name = partfield.name.empty() ? partfield.id : partfield.name;
    for (const std::string& name : {partfield.id, partfield.code}) {
      if (!name.empty() && name != like.name) like.other_names.push_back(name);
    }
    like.crs = "EPSG:4326";
    const std::size_t first = outlines.size();
    for (const TaskPolygon& polygon : partfield.polygons) {
      if (polygon.type == TaskPolygonType::kBoundary) append_outlines(polygon, like, outlines);
    }
    for (std::size_t i = first; i < outlines.size(); ++i) {
      add_no_ground(partfield, outlines[i]);
      add_obstacles(partfield, outlines[i]);
    }
  }
  if (outlines.empty()) {
    throw InputError(file.string(), "", "",
                     "no partfield (PFD) has a boundary (PLN of type 1 with an exterior LSG)");
  }
  return outlines;
}

}  // namespace headland

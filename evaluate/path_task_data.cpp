#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "evaluate/path_export.h"
#include "planner/arcs.h"
#include "terrains/field_outline.h"
#include "terrains/task_data.h"

namespace headland {
namespace {

// Swaths whose directions differ by less are parallel; headings are no rounder than that.
constexpr double kParallel_rad = 1e-3;

// A pass as a line of the implement's middle.
struct Guided {
  PathKind kind = PathKind::kSwath;
  std::vector<Eigen::Vector2d> points_W;
};

Guided guided(const PathSegment& segment, const Vehicle& vehicle) {
  Guided pass;
  pass.kind = segment.kind;
  for (const PathPoint& point : segment.points) {
    pass.points_W.emplace_back(point.p_W +
                               vehicle.implement.x_B_m * direction_of(point.heading_rad));
  }
  pass.points_W = simplified_line(pass.points_W, kGuidanceRounding_m);
  return pass;
}

GuidancePattern pattern_of(const Guided& pass, const GeoFrame& frame, double width_m) {
  GuidancePattern pattern;
  pattern.kind = pass.points_W.size() == 2 ? GuidanceKind::kAb : GuidanceKind::kCurve;
  pattern.repeats = false;
  pattern.line.type = TaskLineType::kGuidance;
  pattern.line.width_m = width_m;
  pattern.line.lon_lat_deg = wgs84_from_local(frame, pass.points_W);
  return pattern;
}

double direction_of_line_rad(const Guided& pass) {
  const Eigen::Vector2d along = pass.points_W.back() - pass.points_W.front();
  return std::atan2(along.y(), along.x());
}

// The longest straight swath of every direction, to be repeated to both sides.
void append_ab_lines(const std::vector<Guided>& passes, const GeoFrame& frame, double width_m,
                     std::vector<GuidancePattern>& patterns) {
  std::vector<const Guided*> longest;
  const auto length = [](const Guided& pass) {
    return (pass.points_W.back() - pass.points_W.front()).norm();
  };
  for (const Guided& pass : passes) {
    if (pass.kind != PathKind::kSwath || pass.points_W.size() != 2) continue;
    const double direction_rad = direction_of_line_rad(pass);
    const auto parallel = std::ranges::find_if(longest, [&](const Guided* other) {
      const double between_rad =
          std::remainder(direction_rad - direction_of_line_rad(*other), std::numbers::pi);
      return std::abs(between_rad) < kParallel_rad;
    });
    if (parallel == longest.end()) {
      longest.push_back(&pass);
    } else if (length(pass) > length(**parallel)) {
      *parallel = &pass;
    }
  }
  for (const Guided* pass : longest) {
    GuidancePattern pattern = pattern_of(*pass, frame, width_m);
    pattern.group = "AB lines";
    pattern.name = fmt::format("AB {}", patterns.size() + 1);
    pattern.repeats = true;
    patterns.push_back(std::move(pattern));
  }
}

TaskLine ring_line(TaskLineType type, const Ring& ring, const GeoFrame& frame) {
  return {type, "", 0.0, wgs84_from_local(frame, ring)};
}

void add_obstacle(const Obstacle& obstacle, const GeoFrame& frame, Partfield& partfield) {
  const std::string name(obstacle_kind_name(obstacle.kind));
  if (!runs_along_line(obstacle.kind)) {
    partfield.points.push_back(
        {TaskPointType::kObstacle, name, wgs84_from_local(frame, {obstacle.p_W}).front()});
    return;
  }
  partfield.lines.push_back(
      {obstacle.kind == ObstacleKind::kFence ? TaskLineType::kFence : TaskLineType::kObstacle, name,
       2.0 * obstacle.radius_m,
       wgs84_from_local(frame, {obstacle.p_W, obstacle.p_W + obstacle.run_W})});
}

Partfield partfield_of(const Field& field) {
  Partfield partfield;
  partfield.name = field.name;
  partfield.area_m2 = field_area_m2(field);
  TaskPolygon outline;
  outline.rings.push_back(ring_line(TaskLineType::kExterior, field.boundary, field.frame));
  for (const Ring& hole : field.holes) {
    outline.rings.push_back(ring_line(TaskLineType::kInterior, hole, field.frame));
  }
  partfield.polygons.push_back(std::move(outline));
  for (const Obstacle& obstacle : field.obstacles) add_obstacle(obstacle, field.frame, partfield);
  if (field.entry_W) {
    partfield.points.push_back({TaskPointType::kFieldAccess, "entry",
                                wgs84_from_local(field.frame, {*field.entry_W}).front()});
  }
  return partfield;
}

}  // namespace

std::string path_task_data(const PathExport& made) {
  const GeoFrame& frame = made.field.frame;
  const double width_m = made.vehicle.implement.working_width_m;
  std::vector<Guided> passes;
  for (const PathSegment& segment : made.path.segments) {
    if (segment.implement_down) passes.push_back(guided(segment, made.vehicle));
  }
  TaskData data;
  Partfield& partfield = data.partfields.emplace_back(partfield_of(made.field));
  append_ab_lines(passes, frame, width_m, partfield.guidance);
  int number = 0;
  for (const Guided& pass : passes) {
    GuidancePattern pattern = pattern_of(pass, frame, width_m);
    pattern.group = "passes in order";
    pattern.name = fmt::format("{} {}", ++number, path_kind_name(pass.kind));
    partfield.guidance.push_back(std::move(pattern));
  }
  return task_data_text(data, made.version);
}

}  // namespace headland

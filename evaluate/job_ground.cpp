#include "evaluate/job_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "planner/segment.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr double kOverlap_m2 = 1.0;  // of neighbours that were digitised one by one

std::vector<Field> fields_of(const JobSpec& job, std::optional<GeoFrame> frame,
                             std::vector<std::string>& notes) {
  std::vector<Field> fields;
  const std::string file = job.common.file.string();
  for (const JobField& given : job.fields) {
    FieldSource source = given.source;
    source.frame = frame;
    Field field = read_field(source, file, &notes);
    field.name = given.name;
    if (!fields.empty() && field.frame.georeferenced != fields.front().frame.georeferenced) {
      throw InputError(
          file, given.place, given.name,
          fmt::format("one of '{}' and '{}' has a place on the earth and the other has "
                      "none; give the crs of its coordinates as field.crs",
                      fields.front().name, given.name));
    }
    if (field.frame.georeferenced) frame = field.frame;
    fields.push_back(std::move(field));
  }
  return fields;
}

void refuse_overlaps(const JobSpec& job, const std::vector<Field>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const PolygonSet one = from_field({"", fields[i].boundary, fields[i].holes, {}, {}, {}, {}});
      const PolygonSet other =
          from_field({"", fields[k].boundary, fields[k].holes, {}, {}, {}, {}});
      const double shared_m2 = area_m2(one) - area_m2(difference(one, other));
      if (shared_m2 <= kOverlap_m2) continue;
      throw InputError(job.common.file.string(), job.fields[i].place, fields[i].name,
                       fmt::format("shares {:.0f} m2 with '{}'; fields of a job do not overlap",
                                   shared_m2, fields[k].name));
    }
  }
}

struct NearestBoundary {
  Vector2d p_W = Vector2d::Zero();
  Vector2d inward = Vector2d::Zero();
  double distance_m = std::numeric_limits<double>::infinity();
};

NearestBoundary nearest_boundary(const Field& field, const Vector2d& p_W) {
  NearestBoundary nearest;
  for (std::size_t i = 0; i < field.boundary.size(); ++i) {
    const Vector2d& a = field.boundary[i];
    const Vector2d along = field.boundary[(i + 1) % field.boundary.size()] - a;
    const double t = std::clamp((p_W - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance_m = (p_W - a - t * along).norm();
    if (distance_m >= nearest.distance_m) continue;
    // The boundary runs counter-clockwise.
    nearest = {a + t * along, Vector2d(-along.y(), along.x()).normalized(), distance_m};
  }
  return nearest;
}

std::vector<Vector2d> placed_points(const JobSpec& job, const GeoFrame& frame,
                                    const std::vector<Vector2d>& points, const std::string& where) {
  const std::string file = job.common.file.string();
  if (!frame.georeferenced) {
    if (job.crs.empty()) return points;
    throw InputError(file, "crs", job.crs, "the fields have no place on the earth: give their crs");
  }
  const std::string crs = job.crs.empty() ? "EPSG:4326" : job.crs;
  return local_from_wgs84(frame, wgs84_from_crs(crs, points, file + ": " + where));
}

void add_gates(const JobSpec& job, JobGround& ground) {
  for (std::size_t i = 0; i < job.fields.size(); ++i) {
    const JobField& given = job.fields[i];
    const Field& field = ground.fields[i];
    ground.gates_of.emplace_back();
    for (const Vector2d& p_W :
         placed_points(job, field.frame, given.gates, given.place + ": gates")) {
      const double away_m = nearest_boundary(field, p_W).distance_m;
      if (!(away_m <= kGateReach_m)) {
        throw InputError(job.common.file.string(), given.place + ": gates",
                         place_text(field.frame, p_W),
                         fmt::format("lies {:.1f} m from the boundary of '{}' (at most {:g} m)",
                                     away_m, field.name, kGateReach_m));
      }
      ground.gates_of.back().push_back(ground.gates.size());
      ground.gates.push_back({i, p_W});
    }
  }
}

// Without roads: straight ways that no hole lies in.
void leave_out_ways_through_holes(JobGround& ground) {
  PolygonSet holes;
  for (const Field& field : ground.fields) {
    for (Ring hole : field.holes) {
      std::ranges::reverse(hole);
      holes.parts.push_back({std::move(hole), {}});
    }
  }
  if (holes.parts.empty()) return;
  for (std::size_t node = 0; node < ground.network.edges.size(); ++node) {
    std::erase_if(ground.network.edges[node], [&](const RoadNetwork::Edge& edge) {
      const Polyline line = {ground.network.nodes_W[node],
                             ground.network.nodes_W[static_cast<std::size_t>(edge.to)]};
      return length_m(line) > 0.0 && !clip_line(line, holes).empty();
    });
  }
}

}  // namespace

JobGround job_ground(const JobSpec& job, const std::optional<GeoFrame>& frame) {
  JobGround ground;
  ground.road_width_m = job.road_width_m;
  ground.roads_given = !job.roads.empty();
  ground.fields = fields_of(job, frame, ground.notes);
  refuse_overlaps(job, ground.fields);
  add_gates(job, ground);
  const GeoFrame& placed_in = ground.fields.front().frame;
  std::vector<Vector2d> places;
  for (const JobGate& gate : ground.gates) places.push_back(gate.p_W);
  std::vector<std::string> names;
  for (const JobGate& gate : ground.gates) {
    names.push_back(job.fields[gate.field].place + ": gates");
  }
  const auto add_place = [&](const std::optional<Vector2d>& given, const std::string& name,
                             std::optional<std::size_t>& index) {
    if (!given) return;
    index = places.size();
    places.push_back(placed_points(job, placed_in, {*given}, name).front());
    names.push_back(name);
  };
  add_place(job.start, "start", ground.start);
  add_place(job.end, "end", ground.end);
  std::vector<Polyline> roads;
  for (const auto& road : job.roads) {
    roads.push_back(placed_points(job, placed_in, road, "roads"));
  }
  ground.network = road_network(roads, places, kRoadReach_m);
  if (!ground.roads_given) leave_out_ways_through_holes(ground);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (ground.network.node_of_place[i] >= 0) continue;
    throw InputError(job.common.file.string(), names[i], place_text(placed_in, places[i]),
                     fmt::format("no road comes nearer than {:g} m; draw one to it", kRoadReach_m));
  }
  return ground;
}

PolygonSet corridor(const JobGround& ground, const Polyline& way_W, double vehicle_reach_m) {
  std::vector<PolygonSet> parts;
  const double width_m = ground.road_width_m;
  const auto is_at = [](const Vector2d& p_W) {
    return [p_W](const JobGate& gate) { return gate.p_W == p_W; };
  };
  if (length_m(way_W) > 0.0) {
    Polyline line = way_W;
    // A vehicle that stands at a start or end reaches beyond it; at a gate the field is beyond.
    const auto lengthen = [&](Vector2d& end, const Vector2d& neighbour) {
      if (std::ranges::any_of(ground.gates, is_at(end))) return;
      end += vehicle_reach_m * (end - neighbour).normalized();
    };
    lengthen(line.front(), line[1]);
    lengthen(line.back(), line[line.size() - 2]);
    parts.push_back(strip(line, width_m));
  }
  for (const JobGate& gate : ground.gates) {
    if (gate.p_W != way_W.front() && gate.p_W != way_W.back()) continue;
    const NearestBoundary at = nearest_boundary(ground.fields[gate.field], gate.p_W);
    const Vector2d outside_W = at.p_W - std::max(at.distance_m, 1.0) * at.inward;
    parts.push_back(strip({outside_W, at.p_W, at.p_W + at.inward}, width_m));
  }
  PolygonSet all = united(parts);
  if (ground.roads_given) return all;
  for (const Field& field : ground.fields) {
    for (Ring hole : field.holes) {
      std::ranges::reverse(hole);
      all = difference(all, {{PolygonPart{hole, {}}}});
    }
  }
  return all;
}

Field joined_ground(const JobGround& ground, const std::vector<PolygonSet>& sets,
                    const std::string& what) {
  const PolygonSet all = buffered(buffered(united(sets), 0.5 * kJoinedGap_m, Join::kMitre),
                                  -0.5 * kJoinedGap_m, Join::kMitre);
  if (all.parts.size() != 1) {
    throw InputError(what, "", fmt::format("{} pieces", all.parts.size()),
                     "their ground does not hang together; draw roads up to the gates and make "
                     "them wide enough (road_width_m)");
  }
  Field field;
  field.name = what;
  field.boundary = all.parts.front().outer;
  field.holes = all.parts.front().holes;
  field.frame = ground.fields.front().frame;
  for (const Field& one : ground.fields) {
    field.obstacles.insert(field.obstacles.end(), one.obstacles.begin(), one.obstacles.end());
  }
  return field;
}

}  // namespace headland

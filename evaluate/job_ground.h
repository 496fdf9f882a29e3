// The ground of a job: its fields and roads in one frame, and what of them a transit may use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/job_spec.h"
#include "planner/polygon.h"
#include "planner/road_network.h"
#include "terrains/field.h"

namespace headland {

struct JobGate {
  std::size_t field = 0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
};

// Places of the network: the gates, then the start and the end where there are any.
struct JobGround {
  std::vector<Field> fields;
  std::vector<JobGate> gates;
  std::vector<std::vector<std::size_t>> gates_of;  // by field
  std::optional<std::size_t> start;
  std::optional<std::size_t> end;
  RoadNetwork network;
  double road_width_m = 0.0;
  bool roads_given = false;  // without, transits go straight
  std::vector<std::string> notes;
};

// Of fields on the earth in `frame`, or where that is not given in the first one's. Throws
// InputError: as read_field, fields on the earth beside others that are not, fields that overlap, a
// gate further than kGateReach_m from its field's boundary, a gate, start or end further than
// kRoadReach_m from every road.
JobGround job_ground(const JobSpec& job, const std::optional<GeoFrame>& frame = std::nullopt);

// The strip along a way, with what lies between gates and their fields and behind a start or end.
// Roads that are drawn may cross holes of fields, as tracks do; straight transits may not.
PolygonSet corridor(const JobGround& ground, const Polyline& way_W, double vehicle_reach_m);

// All of the sets as one field, gaps up to kJoinedGap_m closed. Throws InputError naming `what`
// when they do not hang together.
Field joined_ground(const JobGround& ground, const std::vector<PolygonSet>& sets,
                    const std::string& what);

inline constexpr double kGateReach_m = 10.0;
inline constexpr double kRoadReach_m = 30.0;
inline constexpr double kJoinedGap_m = 0.04;

}  // namespace headland

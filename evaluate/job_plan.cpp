#include "evaluate/job_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "evaluate/job_ground.h"
#include "evaluate/plan_scenario.h"
#include "planner/drivable_path.h"
#include "planner/hull.h"
#include "planner/planners.h"
#include "planner/transit.h"
#include "planner/visit_order.h"
#include "planner/worked_rows.h"
#include "sim/route.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();

// Plans a field that is entered at a gate.
Plan planned_from(const JobSpec& job, const JobGround& ground, const Stage& stage,
                  std::size_t field, const Eigen::Vector2d& gate_W, const CancelAsked& cancelled) {
  const JobField& given = job.fields[field];
  const std::string source = job.common.file.string();
  Scenario scenario = job.common;
  scenario.planner = given.planner;
  scenario.field.crs = job.crs;
  PlanRequest request = plan_request(scenario, stage);
  request.field = ground.fields[field];
  request.field.entry_W = gate_W;
  request.cancelled = cancelled;
  try {
    return find_planner(given.planner.name, source).plan(request);
  } catch (const InputError& refused) {
    const InputError in_job = as_in_scenario(refused, source, given.planner);
    if (in_job.source != source) throw;
    throw InputError(source, in_job.where, in_job.value,
                     fmt::format("{} (field '{}')", in_job.allowed, given.name));
  } catch (const PlanInfeasible& refused) {
    throw PlanInfeasible(fmt::format("{}: field '{}': {}", source, given.name, refused.what()));
  }
}

double way_length_m(const JobGround& ground, std::size_t from, std::size_t to) {
  const auto way = shortest_way(ground.network, from, to);
  return way ? length_m(*way) : kNoWay;
}

VisitCosts costs_of(const JobSpec& job, const JobGround& ground, const Stage& stage,
                    const CancelAsked& cancelled) {
  const std::size_t gates = ground.gates.size();
  VisitCosts costs;
  costs.gates = ground.gates_of;
  costs.within.assign(gates, std::vector<double>(gates, kNoWay));
  costs.between.assign(gates, std::vector<double>(gates, kNoWay));
  for (std::size_t in = 0; in < gates; ++in) {
    stop_if(cancelled);
    const JobGate& gate = ground.gates[in];
    const Plan plan = planned_from(job, ground, stage, gate.field, gate.p_W, cancelled);
    const Eigen::Vector2d& first_W = plan.passes.front().points_W.front();
    const Eigen::Vector2d& last_W = plan.passes.back().points_W.back();
    for (const std::size_t out : ground.gates_of[gate.field]) {
      costs.within[in][out] = plan.planned_length_m + (first_W - gate.p_W).norm() +
                              (last_W - ground.gates[out].p_W).norm();
    }
    for (std::size_t to = 0; to < gates; ++to) costs.between[in][to] = way_length_m(ground, in, to);
    if (ground.start) costs.from_start.push_back(way_length_m(ground, *ground.start, in));
    if (ground.end) costs.to_end.push_back(way_length_m(ground, in, *ground.end));
  }
  return costs;
}

// Where a transit leads: fields by their place in the sequence, or the start or end.
struct Leg {
  std::optional<std::size_t> from;  // visit
  std::optional<std::size_t> to;
  std::size_t from_place = 0;
  std::size_t to_place = 0;
};

std::vector<Leg> legs_of(const JobGround& ground, const std::vector<Visit>& visits) {
  std::vector<Leg> legs;
  if (ground.start) legs.push_back({std::nullopt, 0, *ground.start, visits.front().in});
  for (std::size_t i = 1; i < visits.size(); ++i) {
    legs.push_back({i - 1, i, visits[i - 1].out, visits[i].in});
  }
  if (ground.end) legs.push_back({visits.size() - 1, std::nullopt, visits.back().out, *ground.end});
  return legs;
}

PolygonSet ground_of(const Field& field) { return {{PolygonPart{field.boundary, field.holes}}}; }

std::vector<Ring> in_degrees(const GeoFrame& frame, std::vector<Ring> rings) {
  if (!frame.georeferenced) return rings;
  for (Ring& ring : rings) ring = wgs84_from_local(frame, ring);
  return rings;
}

// Fields and roads as one field's source: its ground, of which the fields are to be worked.
FieldSource source_of(const JobGround& ground, const Field& whole) {
  const GeoFrame& frame = whole.frame;
  FieldSource source;
  if (frame.georeferenced) source.crs = "EPSG:4326";
  source.boundary = in_degrees(frame, {whole.boundary}).front();
  source.holes = in_degrees(frame, whole.holes);
  for (const Field& field : ground.fields) {
    std::vector<Ring> rings = {field.boundary};
    rings.insert(rings.end(), field.holes.begin(), field.holes.end());
    for (Ring& ring : in_degrees(frame, std::move(rings)))
      source.to_work.push_back(std::move(ring));
  }
  for (const Obstacle& obstacle : whole.obstacles) {
    std::vector<Eigen::Vector2d> line = {obstacle.p_W};
    if (runs_along_line(obstacle.kind)) line.push_back(obstacle.p_W + obstacle.run_W);
    source.obstacles.push_back({obstacle.kind, in_degrees(frame, {line}).front(), obstacle.radius_m,
                                obstacle.height_m, "field.obstacles"});
  }
  return source;
}

// The network's way, of which road_network knows that there is one.
Polyline way_of(const JobGround& ground, const Leg& leg) {
  return shortest_way(ground.network, leg.from_place, leg.to_place).value();
}

Field whole_ground(const JobGround& ground, const std::vector<Leg>& legs, double reach_m,
                   const std::string& file) {
  std::vector<PolygonSet> sets;
  for (const Field& field : ground.fields) sets.push_back(ground_of(field));
  for (const Leg& leg : legs) sets.push_back(corridor(ground, way_of(ground, leg), reach_m));
  return joined_ground(ground, sets, file + ": the fields and roads");
}

std::string place_name(const JobSpec& job, const std::vector<Visit>& visits,
                       const std::optional<std::size_t>& visit, const char* otherwise) {
  return visit ? job.fields[visits[*visit].field].name : otherwise;
}

// Appends a path that begins where the other one ends, its passes counted from `first_pass` on.
void append(const Path& more, JobPart part, std::size_t first_pass, JobPlan& made) {
  const int last = made.path.segments.empty() ? -1 : made.path.segments.back().manoeuvre;
  part.first_segment = made.path.segments.size();
  part.segments = more.segments.size();
  part.length_m = length_m(more);
  for (PathSegment segment : more.segments) {
    segment.manoeuvre += last + 1;
    made.path.segments.push_back(std::move(segment));
  }
  for (PathViolation violation : more.violations) {
    violation.manoeuvre += last + 1;
    made.path.violations.push_back(std::move(violation));
  }
  made.path.cut_back_m.insert(made.path.cut_back_m.end(), more.cut_back_m.begin(),
                              more.cut_back_m.end());
  made.path.abrupt_turns += more.abrupt_turns;
  made.path.abrupt_joints += more.abrupt_joints;
  for (LeftOutPass left_out : more.left_out) {
    left_out.pass += first_pass;
    left_out.why = part.name + ": " + left_out.why;
    made.path.left_out.push_back(std::move(left_out));
  }
  std::ranges::stable_sort(made.path.left_out, std::greater{}, &LeftOutPass::area_m2);
  if (more.tightest.clearance_m < made.path.tightest.clearance_m) {
    made.path.tightest = more.tightest;
  }
  if (part.segments > 0) made.parts.push_back(std::move(part));
}

void append(const Plan& more, Plan& plan) {
  if (plan.passes.empty()) {
    plan = more;
    return;
  }
  plan.passes.insert(plan.passes.end(), more.passes.begin(), more.passes.end());
  plan.planned_length_m += more.planned_length_m;
  plan.headland_width_m = std::max(plan.headland_width_m, more.headland_width_m);
}

// The time of each segment at the route's speeds.
void set_expected_times(JobPlan& made) {
  const Route route = make_route(made.path, made.stage.vehicle);
  std::vector<double> times_s(made.path.segments.size(), 0.0);
  for (const RouteRun& run : route.runs) {
    for (std::size_t i = run.first; i < run.last; ++i) {
      const double speed_mps =
          0.5 * (route.points[i].speed_limit_mps + route.points[i + 1].speed_limit_mps);
      times_s[static_cast<std::size_t>(route.points[i].segment)] +=
          (route.points[i + 1].along_m - route.points[i].along_m) / std::max(speed_mps, kCreep_mps);
    }
  }
  for (JobPart& part : made.parts) {
    for (std::size_t i = 0; i < part.segments; ++i) {
      part.expected_time_s += times_s[part.first_segment + i];
    }
  }
}

}  // namespace

JobPlan plan_job(const JobSpec& job, const CancelAsked& cancelled) {
  const std::string file = job.common.file.string();
  const Vehicle vehicle = vehicle_of(job.common, file);
  check_path_keys(job.common, vehicle);
  const double reach = reach_m(hull_of(vehicle));
  JobGround ground = job_ground(job);
  Stage flat;
  flat.vehicle = vehicle;
  flat.field = ground.fields.front();
  flat.terrain = read_terrain({}, flat.field, file);
  const auto visits =
      cheapest_visits(costs_of(job, ground, flat, cancelled), job.order_given, cancelled);
  if (!visits) {
    throw PlanInfeasible(
        file +
        ": no sequence of the fields has a way from each to the next one; draw roads that meet "
        "(straight ways from gate to gate do not cross holes)");
  }
  const std::vector<Leg> legs = legs_of(ground, *visits);

  JobPlan made;
  made.scenario = job.common;
  made.scenario.planner = job.fields.front().planner;
  made.scenario.field = source_of(ground, whole_ground(ground, legs, reach, file));
  made.stage = load_stage(made.scenario);
  // The frame is the whole ground's from here on.
  ground =
      job_ground(job, made.stage.field.frame.georeferenced ? std::optional(made.stage.field.frame)
                                                           : std::nullopt);
  made.stage.notes.insert(made.stage.notes.begin(), ground.notes.begin(), ground.notes.end());

  std::vector<Path> paths;
  std::vector<std::size_t> first_passes;
  for (const Visit& visit : *visits) {
    stop_if(cancelled);
    const Plan plan =
        planned_from(job, ground, made.stage, visit.field, ground.gates[visit.in].p_W, cancelled);
    first_passes.push_back(made.plan.passes.size());
    append(plan, made.plan);
    const std::string& name = job.fields[visit.field].name;
    try {
      paths.push_back(
          make_path(ground.fields[visit.field], vehicle, plan, job.common.path, cancelled));
    } catch (const PlanInfeasible& refused) {
      throw PlanInfeasible(fmt::format("{}: field '{}': {}", file, name, refused.what()));
    }
  }
  std::vector<std::pair<JobPart, Path>> transits;
  for (const Leg& leg : legs) {
    JobPart part;
    part.transit = true;
    part.from = place_name(job, *visits, leg.from, "start");
    part.to = place_name(job, *visits, leg.to, "end");
    TransitRequest request;
    request.way_W = way_of(ground, leg);
    made.road_length_m += length_m(request.way_W);
    const PolygonSet road = corridor(ground, request.way_W, reach);
    std::optional<WorkedGround> rows;
    std::vector<PolygonSet> leaving = {road};
    std::vector<PolygonSet> arriving = {road};
    if (leg.from) {
      request.from = paths[*leg.from].segments.back().points.back();
      const Field& left = ground.fields[(*visits)[*leg.from].field];
      leaving.push_back(ground_of(left));
      if (job.common.path.keep_off_worked) {
        request.rows = &rows.emplace(rows_behind(left, vehicle, paths[*leg.from]));
      }
    }
    if (leg.to) {
      request.to = paths[*leg.to].segments.front().points.front();
      arriving.push_back(ground_of(ground.fields[(*visits)[*leg.to].field]));
    }
    if (length_m(request.way_W) < kLeastRoad_m) {
      leaving.insert(leaving.end(), arriving.begin() + 1, arriving.end());
    }
    const std::string what = fmt::format("{}: transit from {} to {}", file, part.from, part.to);
    request.leaving = joined_ground(ground, leaving, what);
    request.arriving = joined_ground(ground, arriving, what);
    request.road = made.stage.field;
    try {
      transits.emplace_back(part, transit_path(request, vehicle, job.common.path, cancelled));
    } catch (const PlanInfeasible& refused) {
      throw PlanInfeasible(what + ": " + refused.what());
    }
  }

  auto transit = transits.begin();
  if (ground.start) {
    append(transit->second, transit->first, 0, made);
    ++transit;
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Field& field = ground.fields[(*visits)[i].field];
    JobPart part;
    part.name = field.name;
    part.area_m2 = field_area_m2(field);
    for (const PathSegment& segment : paths[i].segments) {
      if (segment.implement_down) ++part.passes;
    }
    append(paths[i], part, first_passes[i], made);
    if (transit == transits.end()) continue;
    append(transit->second, transit->first, 0, made);
    ++transit;
  }
  set_expected_times(made);
  return made;
}

}  // namespace headland

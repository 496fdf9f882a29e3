#include "planner/worked_rows.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "planner/free_space.h"

namespace headland {
namespace {

// Of the raster and of where work ends [m].
constexpr double kTailMargin_m = 0.5;
// Places that differ by rounding alone [m].
constexpr double kSamePlace_m = 1e-3;

double tail_m(const Vehicle& vehicle) {
  return std::max(0.0, vehicle.implement.x_B_m - vehicle.rear.x_B_m) + kTailMargin_m;
}

// Of a row between two poses.
Quadrangle row_between(const Pose& from, const Pose& to, const Vehicle& vehicle) {
  const auto middle_W = [&](const Pose& pose) -> Eigen::Vector2d {
    return pose.p_W + vehicle.implement.x_B_m * direction_of(pose.heading_rad);
  };
  const double half_m = 0.5 * kRowShare * vehicle.implement.working_width_m;
  return between_bars(middle_W(from), middle_W(to), half_m * left_of(from.heading_rad),
                      half_m * left_of(to.heading_rad));
}

// Rows behind a vehicle at work: the last stretch becomes one when the next row begins.
struct RowsBehind {
  WorkedGround& ground;
  const Vehicle& vehicle;
  std::deque<WorkState> tail{};
  double length_m = 0.0;

  void work_first() {
    work(ground, row_between(tail[0].pose, tail[1].pose, vehicle));
    length_m -= tail[1].step_m;
    tail.pop_front();
  }
  // The place that the vehicle comes to next; `begins` where its way does not go on.
  void pass(const WorkState& state, bool begins) {
    if (state.does == WorkState::Does::kDrive) return;
    if (begins) finish();
    if (state.does == WorkState::Does::kWork) add(state);
  }
  void add(const WorkState& state) {
    tail.push_back(state);
    length_m += tail.size() > 1 ? state.step_m : 0.0;
    while (tail.size() > 1 && length_m - tail[1].step_m >= tail_m(vehicle)) work_first();
  }
  void finish() {
    while (tail.size() > 1) work_first();
    tail.clear();
    length_m = 0.0;
  }
};

// Whether work, or driving, begins at a state rather than going on from the one before.
bool begins_at(const WorkState& state, const WorkState* before) {
  return before == nullptr || state.does != before->does ||
         (state.pose.p_W - before->pose.p_W).norm() > state.step_m + kSamePlace_m;
}

std::vector<WorkState> states_of(const Path& path) {
  std::vector<WorkState> states;
  for (const PathSegment& segment : path.segments) {
    const bool is_row = segment.kind == PathKind::kSwath && !segment.optional;
    const auto does = !segment.implement_down ? WorkState::Does::kDrive
                      : is_row                ? WorkState::Does::kWork
                                              : WorkState::Does::kWorkThatDoesNotCount;
    for (std::size_t i = 0; i < segment.points.size(); ++i) {
      const double step_m =
          i == 0 ? 0.0 : (segment.points[i].p_W - segment.points[i - 1].p_W).norm();
      states.push_back({pose_of(segment.points[i]), step_m, does});
    }
  }
  return states;
}

}  // namespace

std::vector<std::size_t> work_rows(WorkedGround& ground, const WorkLine& line, std::size_t from,
                                   std::size_t to, const Vehicle& vehicle) {
  std::vector<std::size_t> newly;
  if (line.kind != PathKind::kSwath || line.optional) return newly;
  for (std::size_t i = std::max(from, line.run_in); i < to; ++i) {
    work(ground, row_between(pose_of(line.points[i]), pose_of(line.points[i + 1]), vehicle),
         &newly);
  }
  return newly;
}

std::size_t tail_edges(const WorkLine& line, const Vehicle& vehicle, double cut_m) {
  const double spacing_m = (line.points[1].p_W - line.points[0].p_W).norm();
  const auto edges = static_cast<std::size_t>(std::ceil((tail_m(vehicle) + cut_m) / spacing_m));
  return std::min(edges, line.points.size() - 1);
}

WorkedGround rows_behind(const Field& field, const Vehicle& vehicle, const Path& path) {
  WorkedGround ground = ground_to_work(field);
  RowsBehind rows{ground, vehicle};
  const std::vector<WorkState> states = states_of(path);
  const WorkState* before = nullptr;
  for (const WorkState& state : states) {
    rows.pass(state, begins_at(state, before));
    before = &state;
  }
  return ground;
}

DrivenOverWorked driven_over_worked(const Field& field, const Vehicle& vehicle,
                                    const std::vector<WorkState>& states) {
  WorkedGround ground = ground_to_work(field);
  FreeSpace wheels;
  wheels.hull = hull_of(vehicle);
  wheels.worked = &ground;
  RowsBehind rows{ground, vehicle};
  DrivenOverWorked over;
  double longest_m = 0.0;
  double stretch_m = 0.0;
  Eigen::Vector2d begin_W = Eigen::Vector2d::Zero();
  const auto end_stretch = [&] {
    if (stretch_m > longest_m) {
      longest_m = stretch_m;
      over.p_W = begin_W;
    }
    over.stretches += stretch_m > 0.0 ? 1 : 0;
    stretch_m = 0.0;
  };
  const WorkState* before = nullptr;
  for (const WorkState& state : states) {
    const bool begins = begins_at(state, before);
    before = &state;
    rows.pass(state, begins);
    if (state.does != WorkState::Does::kDrive) {
      end_stretch();
      continue;
    }
    if (begins || keeps_off_worked(wheels, state.pose)) {
      end_stretch();
      continue;
    }
    if (stretch_m == 0.0) begin_W = state.pose.p_W;
    stretch_m += state.step_m;
    over.length_m += state.step_m;
  }
  end_stretch();
  return over;
}

DrivenOverWorked driven_over_worked(const Field& field, const Vehicle& vehicle, const Path& path) {
  return driven_over_worked(field, vehicle, states_of(path));
}

}  // namespace headland

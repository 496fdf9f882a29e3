#include "planner/path_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/arcs.h"

namespace headland {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;
constexpr double kPivot_rad = 0.05;  // a heading that jumps by more is turned on the spot

const SlopeCost& slope_cost_of(const DriveCost& cost, const PathSegment& segment) {
  if (segment.implement_down) return cost.working;
  return segment.kind == PathKind::kTransit ? cost.transit : cost.raised;
}

double wh_between(const SlopeCost& cost, const Heightfield* terrain, const Eigen::Vector2d& from_W,
                  const Eigen::Vector2d& to_W) {
  const double step_m = (to_W - from_W).norm();
  if (step_m == 0.0) return 0.0;
  if (terrain == nullptr) return step_m * wh_per_m(cost, 0.0);
  const Eigen::Vector2d along_W = (to_W - from_W) / step_m;
  const Eigen::Vector2d middle_W = 0.5 * (from_W + to_W);
  const SurfacePoint ground = surface_at(*terrain, middle_W.x(), middle_W.y());
  const Eigen::Vector2d left_W(-along_W.y(), along_W.x());
  return step_m * wh_per_m(cost, ground.gradient.dot(along_W), ground.gradient.dot(left_W));
}

// Driving along a segment as if nothing were before and after it.
void drive_along(const PathSegment& segment, const Heightfield* terrain, const DriveCost& cost,
                 PredictedEnergy& predicted) {
  const SlopeCost& slopes = slope_cost_of(cost, segment);
  double segment_m = 0.0;
  double quarters = 0.0;
  double& wh = predicted.by_kind_wh[static_cast<std::size_t>(segment.kind)];
  for (std::size_t i = 1; i < segment.points.size(); ++i) {
    const PathPoint& from = segment.points[i - 1];
    const PathPoint& to = segment.points[i];
    const double step_m = (to.p_W - from.p_W).norm();
    const double turned = std::abs(wrap_angle(to.heading_rad - from.heading_rad)) / kQuarter_rad;
    wh += wh_between(slopes, terrain, from.p_W, to.p_W);
    segment_m += step_m;
    quarters += turned;
    if (segment.implement_down) {
      // Wheels that slide sideways do so in proportion to curvature, over a way that falls with it.
      const double tightness =
          step_m > 0.0 ? turned * kQuarter_rad / step_m * cost.turning_radius_m : 1.0;
      wh += cost.bend_wh * turned * std::min(tightness, 1.0);
    } else {
      wh += cost.movement.quarter_wh * turned;
    }
  }
  (segment.implement_down ? predicted.working_m : predicted.raised_m) += segment_m;
  (segment.implement_down ? predicted.working_quarters : predicted.raised_quarters) += quarters;
}

// A stop at an end of a segment, or a start from it.
double half_stop_wh(const DriveCost& cost, const PathSegment& segment) {
  return 0.5 * (segment.implement_down ? cost.stop_working_wh : cost.stop_raised_wh);
}

// What lies between two segments that follow each other.
void pass_on(const PathSegment& from, const PathSegment& to, const DriveCost& cost,
             PredictedEnergy& predicted) {
  const bool lowered = !from.implement_down && to.implement_down;
  // A lowering belongs to the movement that it ends.
  double& wh = predicted.by_kind_wh[static_cast<std::size_t>(lowered ? from.kind : to.kind)];
  if (lowered) {
    ++predicted.cycles;
    wh += cost.movement.cycle_wh;
  }
  const double jump_rad =
      std::abs(wrap_angle(to.points.front().heading_rad - from.points.back().heading_rad));
  const bool pivots = jump_rad > kPivot_rad;
  if (pivots) {
    predicted.pivot_quarters += jump_rad / kQuarter_rad;
    wh += cost.movement.pivot_wh * jump_rad / kQuarter_rad;
  }
  if (from.gear == to.gear && !pivots) return;
  predicted.cusps += from.gear != to.gear ? 1 : 0;
  for (const PathSegment* side : {&from, &to}) {
    const bool raised_cusp = from.gear != to.gear && !side->implement_down;
    predicted.by_kind_wh[static_cast<std::size_t>(side->kind)] +=
        raised_cusp ? 0.5 * cost.movement.cusp_wh : half_stop_wh(cost, *side);
  }
}

}  // namespace

PredictedEnergy predicted_energy(const Path& path, const Heightfield* terrain,
                                 const DriveCost& cost) {
  PredictedEnergy predicted;
  const PathSegment* before = nullptr;
  for (const PathSegment& segment : path.segments) {
    if (before != nullptr) pass_on(*before, segment, cost, predicted);
    drive_along(segment, terrain, cost, predicted);
    before = &segment;
  }
  if (before == nullptr) return predicted;
  for (const PathSegment* end : {&path.segments.front(), before}) {
    predicted.by_kind_wh[static_cast<std::size_t>(end->kind)] += half_stop_wh(cost, *end);
  }
  for (const double wh : predicted.by_kind_wh) predicted.energy_wh += wh;
  return predicted;
}

}  // namespace headland

#include "planner/worked_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/indexed.h"
#include "planner/segment.h"

namespace headland {
namespace {

// Between two lines, 0 to pi / 2.
double angle_between_rad(double one_rad, double other_rad) {
  const double difference_rad = std::fmod(std::abs(one_rad - other_rad), std::numbers::pi);
  return std::min(difference_rad, std::numbers::pi - difference_rad);
}

std::vector<PartSweep> sweeps_of(const RegionPart& part, double width_m, PartSweeps sweeps) {
  std::vector<PartSweep> own = {sweep_of(part.outline_W, part.sweep_rad, width_m)};
  if (sweeps == PartSweeps::kOwn) return own;
  std::vector<PartSweep> others;
  const Ring corners = corners_of(part.outline_W);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double direction_rad = line_direction_rad(corners[(i + 1) % corners.size()] - corners[i]);
    const auto known = [&](const PartSweep& sweep) {
      return angle_between_rad(sweep.direction_rad, direction_rad) < kSameSweep_rad;
    };
    if (known(own.front()) || std::ranges::any_of(others, known)) continue;
    if (!is_swept_whole(part.outline_W, direction_rad)) continue;
    others.push_back(sweep_of(part.outline_W, direction_rad, width_m));
  }
  std::ranges::stable_sort(others, {}, [](const PartSweep& sweep) { return sweep.lines.size(); });
  if (others.size() >= kMostSweeps) others.resize(kMostSweeps - 1);
  std::ranges::move(others, std::back_inserter(own));
  return own;
}

}  // namespace

std::vector<WorkedPart> worked_parts(const RegionParts& parts, double width_m, PartSweeps sweeps) {
  std::vector<WorkedPart> worked;
  worked.reserve(parts.parts.size());
  for (const RegionPart& part : parts.parts) {
    worked.push_back({part.outline_W, sweeps_of(part, width_m, sweeps)});
  }
  return worked;
}

RegionProblem region_problem(const std::vector<WorkedPart>& parts,
                             const std::optional<Eigen::Vector2d>& start_W,
                             const std::optional<Eigen::Vector2d>& end_W) {
  RegionProblem problem;
  problem.start_W = start_W;
  problem.end_W = end_W;
  for (const WorkedPart& part : parts) {
    std::vector<RegionVariant>& variants = problem.parts.emplace_back();
    for (const PartSweep& sweep : part.sweeps) {
      for (const SweepWay way : kSweepWays) {
        const Polyline line = points_of(sweep, way);
        variants.push_back({line.front(), line.back(), length_m(line)});
      }
    }
  }
  return problem;
}

const PartSweep& sweep_of(const std::vector<WorkedPart>& parts, RegionVisit visit) {
  return at(at(parts, visit.part).sweeps, visit.variant / static_cast<int>(kSweepWays.size()));
}

Polyline way_of(const std::vector<WorkedPart>& parts, RegionVisit visit) {
  return points_of(sweep_of(parts, visit),
                   at(kSweepWays, visit.variant % static_cast<int>(kSweepWays.size())));
}

}  // namespace headland

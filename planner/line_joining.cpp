#include "planner/line_joining.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "planner/continuous_turns.h"

namespace headland {
namespace {

// Headland widths are named in steps of this.
constexpr double kWidthStep_m = 0.1;

}  // namespace

ConnectionOptions connection_options(const LineJoining& joining, double clearance_m) {
  ConnectionOptions options{joining.radius_m, clearance_m, joining.cancelled};
  if (joining.options.continuous_turns) {
    options.sharpness_per_m2 = turning_sharpness_per_m2(joining.vehicle);
  }
  return options;
}

std::optional<std::vector<Arc>> connect_within(LineJoining& joining, const Pose& from,
                                               const Pose& to, double clearance_m, int most_nodes) {
  const int allowed = std::min(joining.node_budget, most_nodes);
  int nodes = allowed;
  auto arcs = connect(joining.space, from, to, connection_options(joining, clearance_m), nodes);
  joining.node_budget -= allowed - nodes;
  return arcs;
}

Eigen::Vector2d implement_at(const LineJoining& joining, const PathPoint& axle) {
  return axle.p_W + joining.space.hull.bar_x_m * direction_of(axle.heading_rad);
}

std::string place_name(const Field& field, const Eigen::Vector2d& p_W) {
  std::string place = fmt::format("({:.1f}, {:.1f}) m", p_W.x(), p_W.y());
  if (field.frame.georeferenced) {
    const Eigen::Vector2d lon_lat = wgs84_from_local(field.frame, {p_W}).front();
    place += fmt::format(" [lon {:.6f}, lat {:.6f}]", lon_lat.x(), lon_lat.y());
  }
  return place;
}

std::string line_name(const std::vector<WorkLine>& lines, std::size_t index) {
  const bool swath = lines[index].kind == PathKind::kSwath;
  return fmt::format("pass {} ({})", index + 1, swath ? "swath" : "headland pass");
}

void refuse_connection(const LineJoining& joining, std::size_t before, std::size_t next) {
  const PathPoint& from = joining.lines[before].points.back();
  const PathPoint& to = joining.lines[next].points.front();
  const Eigen::Vector2d end_W = implement_at(joining, from);
  const std::string what =
      fmt::format("no turn from {} to {} fits at {}", line_name(joining.lines, before),
                  line_name(joining.lines, next), place_name(joining.field, end_W)) +
      (joining.worked != nullptr ? " and keeps off the rows worked (path.keep_off_worked)" : "");
  const EdgeAhead ahead = edge_ahead(joining.space, end_W, from.heading_rad);
  const double there_m = ahead.distance_m * ahead.outward.dot(direction_of(from.heading_rad));
  const double depth_m = least_depth_m(joining.space, pose_of(from), pose_of(to), joining.radius_m,
                                       end_W, ahead.outward) +
                         joining.options.clearance_m;
  std::vector<std::string> remedies;
  if (depth_m > there_m) {
    if (joining.remedies.has_headland) remedies.emplace_back("widen the headland");
    remedies.emplace_back("turn tighter");
  }
  if (joining.worked != nullptr) {
    const std::vector<std::string>& ways = joining.remedies.off_rows;
    remedies.insert(remedies.end(), ways.begin(), ways.end());
    remedies.emplace_back("let wheels run over rows (path.keep_off_worked: false)");
  }
  if (depth_m <= there_m) {
    remedies.emplace_back("move the passes");
    remedies.emplace_back("remove what is in the way");
  }
  const std::string may_help =
      fmt::format("{} or allow overruns (--allow-overrun)", fmt::join(remedies, ", "));
  if (depth_m > there_m) {
    const double would_do_m = std::ceil(depth_m / kWidthStep_m) * kWidthStep_m;
    throw PlanInfeasible(
        fmt::format("{}: it needs a headland of {:.1f} m and there are {:.1f} m; {}", what,
                    would_do_m, there_m, may_help));
  }
  throw PlanInfeasible(
      fmt::format("{}: the way is blocked though the headland of {:.1f} m is deep enough; {}", what,
                  there_m, may_help));
}

}  // namespace headland

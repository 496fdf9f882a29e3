// A path: a plan made drivable for one vehicle.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace headland {

enum class PathKind { kSwath, kHeadlandPass, kTurn, kUTurn, kTransit };
enum class Gear { kForward, kReverse };

// Where B's origin is to be. `heading_rad` is the direction of the body's x axis
// (counter-clockwise from +x of W), in reverse gear the motion is opposite to it.
// `curvature_per_m` is the signed curvature of the curve that the body x axis follows, positive
// to the left: tan(steer) / wheelbase in either gear.
struct PathPoint {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double curvature_per_m = 0.0;
};

// Points of one kind and one gear, at most kPathSpacing apart. The last point of a segment is the
// first of the next one. A turn with cusps is several segments with the same `manoeuvre`.
struct PathSegment {
  PathKind kind = PathKind::kSwath;
  Gear gear = Gear::kForward;
  bool implement_down = false;
  int manoeuvre = 0;  // counts up along the path; one swath, one turn, one transit each
  std::vector<PathPoint> points;
  bool optional = false;  // a pass that may be left out (Pass::optional); not in path files
};

inline constexpr double kPathSpacing_m = 0.25;

// A place where the path leaves the field, enters a hole or meets an obstacle with the hull, or
// is tighter than the vehicle can steer, by how much [m].
struct PathViolation {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  int manoeuvre = 0;
  double overrun_m = 0.0;
  std::string what;
};

// Where the hull keeps least from boundary, holes and obstacles, of the places that keep less than
// the clearance asked for; negative where it protrudes.
struct TightestPlace {
  double clearance_m = std::numeric_limits<double>::infinity();  // none keeps less
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
};

// A pass of the plan that is not driven, and why.
struct LeftOutPass {
  std::size_t pass = 0;                           // index into Plan::passes
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // its middle
  std::string why;
  // That it would work and the path does not; ground that several would work counts for the first
  // of them. 0 where nobody measured it.
  double area_m2 = 0.0;
};

struct Path {
  std::vector<PathSegment> segments;
  std::vector<PathViolation> violations;  // empty unless overruns were allowed
  std::vector<double> cut_back_m;         // of ends of passes shortened for their turn's room
  // In summaries of who made the path, not in path files:
  // Optional passes that no turn leads to or away from, those with the largest area first.
  std::vector<LeftOutPass> left_out;
  TightestPlace tightest;
  // Where continuous turns were asked for: turns whose curvature jumps, as no other ones fit, and
  // ends of all others where it jumps to or from that of a bent pass (kJointJump_per_m).
  int abrupt_turns = 0;
  int abrupt_joints = 0;
};

double length_m(const PathSegment& segment);
double length_m(const Path& path);
double left_out_m2(const Path& path);  // ground that its left-out passes would work

std::string_view path_kind_name(PathKind kind);
std::string_view gear_name(Gear gear);

}  // namespace headland

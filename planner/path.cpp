#include "planner/path.h"

namespace headland {

double length_m(const PathSegment& segment) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < segment.points.size(); ++i) {
    sum_m += (segment.points[i].p_W - segment.points[i - 1].p_W).norm();
  }
  return sum_m;
}

double length_m(const Path& path) {
  double sum_m = 0.0;
  for (const PathSegment& segment : path.segments) sum_m += length_m(segment);
  return sum_m;
}

double left_out_m2(const Path& path) {
  double sum_m2 = 0.0;
  for (const LeftOutPass& pass : path.left_out) sum_m2 += pass.area_m2;
  return sum_m2;
}

std::string_view path_kind_name(PathKind kind) {
  switch (kind) {
    case PathKind::kSwath:
      return "swath";
    case PathKind::kHeadlandPass:
      return "headland pass";
    case PathKind::kTurn:
      return "turn";
    case PathKind::kUTurn:
      return "U-turn";
    case PathKind::kTransit:
      return "transit";
  }
  return "";
}

std::string_view gear_name(Gear gear) { return gear == Gear::kForward ? "forward" : "reverse"; }

}  // namespace headland

#include "planner/track_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/polygon.h"
#include "planner/segment.h"

namespace headland {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

// Corners flatter than this are within any receiver's noise and need no arc to be driven.
constexpr double kFlat_rad = 1e-6;

// Keeps the points of [first, last] that the line needs to stay within the tolerance.
void keep_needed(const Points& points, std::size_t first, std::size_t last, double tolerance_m,
                 std::vector<char>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> stretches = {{first, last}};
  while (!stretches.empty()) {
    const auto [a, b] = stretches.back();
    stretches.pop_back();
    double furthest_m = tolerance_m;
    std::size_t furthest = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double distance_m = distance_to_segment(points[i], points[a], points[b]);
      if (distance_m > furthest_m) {
        furthest_m = distance_m;
        furthest = i;
      }
    }
    if (furthest == a) continue;
    kept[furthest] = 1;
    stretches.emplace_back(a, furthest);
    stretches.emplace_back(furthest, b);
  }
}

// Indices of the points that are kept.
std::vector<std::size_t> simplified(const Points& points, double tolerance_m) {
  std::vector<char> kept(points.size(), 0);
  kept.front() = 1;
  kept.back() = 1;
  keep_needed(points, 0, points.size() - 1, tolerance_m, kept);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i] != 0) result.push_back(i);
  }
  return result;
}

double heading_of(const Vector2d& along) { return std::atan2(along.y(), along.x()); }

struct Corner {
  double angle_rad = 0.0;  // signed, positive to the left
  double half_tan = 0.0;
  double radius_m = 0.0;  // of the arc that rounds it
};

// One entry per point; the first and last are no corners. An edge is shared by the arcs at its
// ends in proportion to what arcs of equal radius would take of it.
std::vector<Corner> corners_along(const Points& line, double deviation_m) {
  std::vector<Corner> corners(line.size());
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    Corner& corner = corners[i];
    corner.angle_rad =
        wrap_angle(heading_of(line[i + 1] - line[i]) - heading_of(line[i] - line[i - 1]));
    corner.half_tan = std::tan(0.5 * std::abs(corner.angle_rad));
  }
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    Corner& corner = corners[i];
    if (std::abs(corner.angle_rad) < kFlat_rad) {
      corner.radius_m = std::numeric_limits<double>::max();
      continue;
    }
    const double before = corner.half_tan + corners[i - 1].half_tan;
    const double after = corner.half_tan + corners[i + 1].half_tan;
    const double by_deviation_m =
        deviation_m / (1.0 / std::cos(0.5 * std::abs(corner.angle_rad)) - 1.0);
    corner.radius_m = std::min({by_deviation_m, (line[i] - line[i - 1]).norm() / before,
                                (line[i + 1] - line[i]).norm() / after});
  }
  return corners;
}

TrackPiece rounded_piece(const Points& line, const std::vector<Corner>& corners) {
  TrackPiece piece;
  piece.start = {line.front(), heading_of(line[1] - line[0])};
  double used_m = 0.0;  // of the edge, by the arc before it
  for (std::size_t i = 1; i < line.size(); ++i) {
    const bool rounded = i + 1 < line.size() && std::abs(corners[i].angle_rad) >= kFlat_rad;
    const double taken_m = rounded ? corners[i].radius_m * corners[i].half_tan : 0.0;
    const double straight_m = (line[i] - line[i - 1]).norm() - used_m - taken_m;
    if (straight_m > 0.0) piece.arcs.push_back({straight_m, 0.0, Gear::kForward});
    if (rounded) {
      const double side = corners[i].angle_rad > 0.0 ? 1.0 : -1.0;
      piece.arcs.push_back({corners[i].radius_m * std::abs(corners[i].angle_rad),
                            side / corners[i].radius_m, Gear::kForward});
    }
    used_m = taken_m;
  }
  return piece;
}

// Draws the line back by a length of its first or last edge, which must be longer.
void draw_back(Vector2d& end, const Vector2d& neighbour, double by_m) {
  end += by_m * (neighbour - end).normalized();
}

// The piece as chords, from one corner to the other: where it was drawn back from a corner the
// turn there is not the piece's deviation.
Points chords_of(const TrackPiece& piece, const Vector2d& begin, const Vector2d& end) {
  Points chords = {begin, piece.start.p_W};
  Pose pose = piece.start;
  for (const Arc& arc : piece.arcs) {
    const double step_m = arc.curvature_per_m == 0.0 ? arc.length_m : kPathSpacing_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(arc.length_m / step_m)));
    for (int i = 1; i <= steps; ++i) {
      chords.push_back(pose_along(pose, arc, arc.length_m * i / steps).p_W);
    }
    pose = pose_along(pose, arc, arc.length_m);
  }
  chords.push_back(end);
  return chords;
}

double greatest_distance_m(const Points& points, std::size_t first, std::size_t last,
                           const Points& chords) {
  double greatest_m = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    double nearest_m = std::numeric_limits<double>::max();
    for (std::size_t k = 1; k < chords.size(); ++k) {
      nearest_m = std::min(nearest_m, distance_to_segment(points[i], chords[k - 1], chords[k]));
    }
    greatest_m = std::max(greatest_m, nearest_m);
  }
  return greatest_m;
}

struct Cutting {
  double tolerance_m = 0.0;
  double radius_m = 0.0;
  double ahead_m = 0.0;
  TrackPieces result;
};

// Between the corners first and last of the stretch, drawn back by so much at both.
void add_piece(Cutting& cutting, const Points& stretch, const std::vector<std::size_t>& kept,
               double on_m, double back_m) {
  Points line;
  for (const std::size_t index : kept) line.push_back(stretch[index]);
  if (line.size() < 2 || length_m(line) - on_m - back_m < kMinPiece_m) {
    cutting.result.dropped_W.push_back(line[line.size() / 2]);
    return;
  }
  const Vector2d begin = line.front();
  const Vector2d end = line.back();
  draw_back(line.front(), line[1], on_m);
  draw_back(line.back(), line[line.size() - 2], back_m);
  TrackPiece piece = rounded_piece(line, corners_along(line, 0.5 * cutting.tolerance_m));
  piece.max_deviation_m =
      greatest_distance_m(stretch, kept.front(), kept.back(), chords_of(piece, begin, end));
  cutting.result.pieces.push_back(std::move(piece));
}

// Cuts the stretch at every corner tighter than the vehicle.
void cut(Cutting& cutting, const Points& stretch) {
  std::vector<std::size_t> kept = simplified(stretch, 0.5 * cutting.tolerance_m);
  double on_m = 0.0;  // the rest is drawn back from its first corner by this
  while (kept.size() > 2) {
    Points line;
    for (const std::size_t index : kept) line.push_back(stretch[index]);
    draw_back(line.front(), line[1], on_m);
    const std::vector<Corner> corners = corners_along(line, 0.5 * cutting.tolerance_m);
    std::size_t at = 1;
    while (at + 1 < line.size() && corners[at].radius_m >= cutting.radius_m) ++at;
    if (at + 1 == line.size()) break;
    ++cutting.result.cut_corners;
    cutting.result.corners_W.push_back(line[at]);
    const double tangent_m = cutting.radius_m * corners[at].half_tan;
    double back_m = std::max(0.0, tangent_m + cutting.ahead_m);
    double next_on_m = std::max(0.0, tangent_m - cutting.ahead_m);
    if (std::abs(corners[at].angle_rad) > kTrimmedAngle_rad ||
        back_m >= (line[at] - line[at - 1]).norm() ||
        next_on_m >= (line[at + 1] - line[at]).norm()) {
      back_m = 0.0;
      next_on_m = 0.0;
    }
    const auto split = kept.begin() + static_cast<std::ptrdiff_t>(at);
    add_piece(cutting, stretch, {kept.begin(), split + 1}, on_m, back_m);
    kept.erase(kept.begin(), split);
    on_m = next_on_m;
  }
  add_piece(cutting, stretch, kept, on_m, 0.0);
}

}  // namespace

TrackPieces track_pieces(const Track& track, double tolerance_m, double radius_m, double ahead_m) {
  Cutting cutting{tolerance_m, radius_m, ahead_m, {}};
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= track.break_before.size(); ++k) {
    const std::size_t end =
        k < track.break_before.size() ? track.break_before[k] : track.points_W.size();
    const Points stretch(track.points_W.begin() + static_cast<std::ptrdiff_t>(begin),
                         track.points_W.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
    if (!stretch.empty()) cut(cutting, stretch);
  }
  return std::move(cutting.result);
}

}  // namespace headland

// Cuts a foreign track into pieces that a vehicle can follow.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/arcs.h"
#include "terrains/track.h"

namespace headland {

// Lines and arcs that follow one stretch of a track, driven forward.
struct TrackPiece {
  Pose start;
  std::vector<Arc> arcs;
  double max_deviation_m = 0.0;  // of the track's points from it
};

struct TrackPieces {
  std::vector<TrackPiece> pieces;  // in the track's order
  int cut_corners = 0;
  std::vector<Eigen::Vector2d> corners_W;  // where they were cut
  std::vector<Eigen::Vector2d> dropped_W;  // middles of pieces that were too short
};

// Stretches between breaks become polylines within half of `tolerance_m` (Douglas and Peucker
// 1973), whose corners are rounded by the largest arcs that stay within the other half and leave
// room for their neighbours'. A corner whose arc would be tighter than `radius_m` cuts the piece;
// up to kTrimmedAngle_rad both ends are drawn back so that one arc of `radius_m` joins them when
// B's origin is `ahead_m` ahead of the track along both. Pieces shorter than kMinPiece_m are
// dropped. A jump of the receiver shows as a pair of such corners.
TrackPieces track_pieces(const Track& track, double tolerance_m, double radius_m, double ahead_m);

inline constexpr double kMinPiece_m = 5.0;
inline constexpr double kTrimmedAngle_rad = 1.745;  // 100 degrees

}  // namespace headland

#include "planner/headland_round.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace headland {
namespace {

constexpr double kFilterSigmaPerRadius = 0.1;
// Points of a ring whose circle tells its radius are this far apart [part of the turning radius].
constexpr double kWindowPerRadius = 0.2;
// Attempts at a round without kinks before its rings that have some are given up.
constexpr int kEvenings = 2;
// Slivers between a rounded ring and an offset of the field are thinner than this [part of the
// working width].
constexpr double kSliverPerWidth = 1.0 / 16.0;

std::vector<HeadlandRing> rings_of(const PolygonSet& ground, int round, double turning_radius_m) {
  const double sigma_m = kFilterSigmaPerRadius * turning_radius_m;
  std::vector<HeadlandRing> rings;
  const auto append = [&](const Ring& ring, bool around_hole) {
    HeadlandRing smooth{round, around_hole, smoothed_ring(ring, sigma_m), {}};
    for (const Eigen::Vector2d& p_W : smooth.line_W) smooth.box_W.extend(p_W);
    rings.push_back(std::move(smooth));
  };
  for (const PolygonPart& part : ground.parts) {
    append(part.outer, false);
    for (const Ring& hole : part.holes) append(hole, true);
  }
  return rings;
}

}  // namespace

bool is_closed(const HeadlandRing& ring) { return ring.line_W.front() == ring.line_W.back(); }

double headland_width_m(int rounds, double first_m, double working_width_m) {
  return rounds == 0 ? 0.0 : first_m + (rounds - 0.5) * working_width_m;
}

HeadlandRound round_along(const PolygonSet& ground, int round, const Rounding& rounding,
                          const PlanRequest& request) {
  const auto fine = [&](const HeadlandRing& ring) {
    return tightest_radius_m(ring.line_W, kWindowPerRadius * request.turning_radius_m) >=
           request.turning_radius_m;
  };
  HeadlandRound made{rounded(ground, rounding, request.cancelled), {}};
  made.rings = rings_of(made.ground, round, request.turning_radius_m);
  for (int step = 0; step < kEvenings && !std::ranges::all_of(made.rings, fine); ++step) {
    stop_if(request.cancelled);
    made.ground =
        step % 2 == 0 ? closed_where_clear(made.ground, rounding) : opened(made.ground, rounding);
    made.rings = rings_of(made.ground, round, request.turning_radius_m);
  }
  std::erase_if(made.rings, std::not_fn(fine));
  return made;
}

PolygonSet worth_working(const PolygonSet& ground, double width_m) {
  const double sliver_m = kSliverPerWidth * width_m;
  const PolygonSet opened =
      buffered(buffered(ground, -sliver_m, Join::kMitre), sliver_m, Join::kMitre);
  PolygonSet kept;
  for (const PolygonPart& part : opened.parts) {
    if (area_m2({{part}}) > width_m * width_m) kept.parts.push_back(part);
  }
  return kept;
}

}  // namespace headland

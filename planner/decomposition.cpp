#include "planner/decomposition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "planner/arcs.h"
#include "planner/indexed.h"
#include "planner/segment.h"

namespace headland {
namespace {

// Angles nearer to straight than this are straight.
constexpr double kStraight_rad = 1e-7;
// Points whose levels differ by less lie on one slice.
constexpr double kOneSlice_m = 1e-5;

struct Side {
  Eigen::Vector2d a_W;
  Eigen::Vector2d b_W;
};

// A corner with the ground to the left of both its edges.
struct Corner {
  Eigen::Vector2d p_W;
  Eigen::Vector2d from_W;  // the corner before
  Eigen::Vector2d to_W;    // the one after
  std::vector<double>
      cut_at_rad;  // cuts that end here, counter-clockwise from the edge that leaves
};

// Ground with the cuts made so far.
struct CutGround {
  std::vector<Corner> corners;
  std::vector<Side> sides;
  std::vector<Polyline> cuts;
};

double turned_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double angle_rad = std::atan2(cross(from, to), from.dot(to));
  return angle_rad < 0.0 ? angle_rad + 2.0 * std::numbers::pi : angle_rad;
}

CutGround uncut(const PolygonPart& ground) {
  CutGround uncut;
  const auto add = [&](const Ring& ring) {
    const int count = static_cast<int>(ring.size());
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d& p_W = at(ring, i);
      const Eigen::Vector2d& next_W = at(ring, (i + 1) % count);
      uncut.corners.push_back({p_W, at(ring, (i + count - 1) % count), next_W, {}});
      uncut.sides.push_back({p_W, next_W});
    }
  };
  add(ground.outer);
  for (const Ring& hole : ground.holes) add(hole);
  return uncut;
}

double inner_angle_rad(const Corner& corner) {
  return turned_rad(corner.to_W - corner.p_W, corner.from_W - corner.p_W);
}

// Whether a direction leads into the ground.
bool leads_inside(const Corner& corner, const Eigen::Vector2d& direction) {
  const double at_rad = turned_rad(corner.to_W - corner.p_W, direction);
  return at_rad > kStraight_rad && at_rad < inner_angle_rad(corner) - kStraight_rad;
}

// Whether an angle above 180 degrees is left between the corner's edges and cuts.
bool is_concave(const Corner& corner) {
  std::vector<double> at_rad = corner.cut_at_rad;
  at_rad.push_back(inner_angle_rad(corner));
  std::ranges::sort(at_rad);
  double before_rad = 0.0;
  for (const double rad : at_rad) {
    if (rad - before_rad > std::numbers::pi + kStraight_rad) return true;
    before_rad = rad;
  }
  return false;
}

// Where a ray first meets a side; sides that begin or end where it does are not met there.
std::optional<Eigen::Vector2d> first_met(const CutGround& ground, const Eigen::Vector2d& p_W,
                                         const Eigen::Vector2d& direction) {
  double nearest_m = std::numeric_limits<double>::infinity();
  Eigen::Vector2d met_W = p_W;
  const auto meet = [&](double along_m, const Eigen::Vector2d& place_W) {
    if (along_m <= kCutSnap_m || along_m >= nearest_m) return;
    nearest_m = along_m;
    met_W = place_W;
  };
  for (const Side& side : ground.sides) {
    const Eigen::Vector2d a = side.a_W - p_W;
    const Eigen::Vector2d b = side.b_W - p_W;
    const double left_a_m = cross(direction, a);
    const double left_b_m = cross(direction, b);
    const bool a_on_ray = std::abs(left_a_m) <= kCutSnap_m;
    const bool b_on_ray = std::abs(left_b_m) <= kCutSnap_m;
    if (a_on_ray) meet(direction.dot(a), side.a_W);
    if (b_on_ray) meet(direction.dot(b), side.b_W);
    if (a_on_ray || b_on_ray || (left_a_m > 0.0) == (left_b_m > 0.0)) continue;
    const double share = left_a_m / (left_a_m - left_b_m);
    const Eigen::Vector2d crossing = a + share * (b - a);
    meet(direction.dot(crossing), p_W + crossing);
  }
  if (std::isinf(nearest_m)) return std::nullopt;
  return met_W;
}

void cut_from(CutGround& ground, const Eigen::Vector2d& p_W, const Eigen::Vector2d& direction) {
  const auto end_W = first_met(ground, p_W, direction.normalized());
  // Rounding alone lets a ray out of the ground.
  if (!end_W) return;
  ground.sides.push_back({p_W, *end_W});
  ground.cuts.push_back({p_W, *end_W});
  for (Corner& corner : ground.corners) {
    const bool begins = corner.p_W == p_W;
    if (!begins && corner.p_W != *end_W) continue;
    const Eigen::Vector2d away = begins ? Eigen::Vector2d(*end_W - p_W) : p_W - *end_W;
    corner.cut_at_rad.push_back(turned_rad(corner.to_W - corner.p_W, away));
  }
}

std::vector<Ring> pieces_of(const PolygonPart& ground, const std::vector<Polyline>& cuts) {
  std::vector<Ring> outlines;
  for (PolygonPart& piece : cut_apart(ground, cuts)) outlines.push_back(std::move(piece.outer));
  return outlines;
}

// Corners one after the other on one slice, at a lowest or highest place of a ring.
struct Plateau {
  Eigen::Vector2d first_W;
  Eigen::Vector2d last_W;
  bool concave = false;
};

std::vector<Plateau> turning_places(const Ring& ring, double slice_rad) {
  const Eigen::Vector2d along = direction_of(slice_rad);
  const Eigen::Vector2d across = left_of(slice_rad);
  const int count = static_cast<int>(ring.size());
  const auto level_m = [&](int i) { return across.dot(at(ring, i % count)); };
  int begin = 0;
  while (begin < count && std::abs(level_m(begin) - level_m(begin + count - 1)) < kOneSlice_m) {
    ++begin;
  }
  std::vector<Plateau> places;
  for (int first = begin; first < begin + count;) {
    int last = first;
    while (last + 1 < begin + count && std::abs(level_m(last + 1) - level_m(first)) < kOneSlice_m) {
      ++last;
    }
    const bool falls_to = level_m(first + count - 1) > level_m(first);
    const bool rises_from = level_m(last + 1) > level_m(last);
    if (falls_to == rises_from) {
      const Eigen::Vector2d& p_W = at(ring, first % count);
      const Eigen::Vector2d& q_W = at(ring, last % count);
      const Eigen::Vector2d arriving = p_W - at(ring, (first + count - 1) % count);
      const Eigen::Vector2d leaving = at(ring, (last + 1) % count) - q_W;
      const double run_m = along.dot(q_W - p_W);
      const bool rightwards =
          first == last ? cross(arriving, leaving) > 0.0 : (run_m > 0.0) == falls_to;
      places.push_back({p_W, q_W, !rightwards});
    }
    first = last + 1;
  }
  return places;
}

}  // namespace

std::vector<Ring> convex_pieces(const PolygonPart& ground) {
  CutGround cut = uncut(ground);
  for (std::size_t i = 0; i < cut.corners.size(); ++i) {
    if (!is_concave(cut.corners[i])) continue;
    const Eigen::Vector2d p_W = cut.corners[i].p_W;
    cut_from(cut, p_W, p_W - cut.corners[i].from_W);
  }
  return pieces_of(ground, cut.cuts);
}

std::vector<Ring> trapezoids(const PolygonPart& ground, double slice_rad) {
  CutGround cut = uncut(ground);
  const Eigen::Vector2d along = direction_of(slice_rad);
  for (std::size_t i = 0; i < cut.corners.size(); ++i) {
    for (const Eigen::Vector2d& direction : {along, Eigen::Vector2d(-along)}) {
      if (leads_inside(cut.corners[i], direction)) cut_from(cut, cut.corners[i].p_W, direction);
    }
  }
  return pieces_of(ground, cut.cuts);
}

std::vector<Ring> boustrophedon_cells(const PolygonPart& ground, double slice_rad) {
  CutGround cut = uncut(ground);
  const Eigen::Vector2d along = direction_of(slice_rad);
  const auto cut_ring = [&](const Ring& ring) {
    for (const Plateau& place : turning_places(ring, slice_rad)) {
      if (!place.concave) continue;
      const bool forwards = along.dot(place.last_W - place.first_W) >= 0.0;
      cut_from(cut, forwards ? place.last_W : place.first_W, along);
      cut_from(cut, forwards ? place.first_W : place.last_W, -along);
    }
  };
  cut_ring(ground.outer);
  for (const Ring& hole : ground.holes) cut_ring(hole);
  return pieces_of(ground, cut.cuts);
}

double least_width_direction_rad(const PolygonPart& ground) {
  const std::vector<Side> sides = uncut(ground).sides;
  double least_m = std::numeric_limits<double>::infinity();
  double best_rad = 0.0;
  for (const Side& side : sides) {
    const Eigen::Vector2d along = (side.b_W - side.a_W).normalized();
    double sum_m = 0.0;
    for (const Side& other : sides) sum_m += std::abs(cross(along, other.b_W - other.a_W)) / 2.0;
    if (sum_m >= least_m) continue;
    least_m = sum_m;
    best_rad = line_direction_rad(along);
  }
  return best_rad;
}

}  // namespace headland

#include "planner/edge_zones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/arcs.h"
#include "planner/segment.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// A point of the ground lies on an edge of the field that it is nearer to than this [m].
constexpr double kOnEdge_m = 1e-3;
// A part of a zone belongs to an edge when it holds ground this far beside the edge's middle [m].
constexpr double kBeside_m = 2e-3;

int rounds_at(const Vector2d& p_W, const EdgeRounds& edges) {
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    const Polyline& line_W = edges.edges[i].line_W;
    for (std::size_t k = 1; k < line_W.size(); ++k) {
      if (distance_to_segment(p_W, line_W[k - 1], line_W[k]) < kOnEdge_m) return edges.rounds[i];
    }
  }
  return edges.others;
}

Vector2d along(const Ring& ring, std::size_t edge) {
  return (ring[(edge + 1) % ring.size()] - ring[edge]).normalized();
}

Vector2d to_left(const Vector2d& v) { return {-v.y(), v.x()}; }

struct ZoneMaking {
  double distance_m = 0.0;
  std::vector<PolygonSet> pieces;
  std::vector<Vector2d> beside_W;  // ground that belongs to an edge
};

// How far a strip runs straight on at a corner of the ground where the neighbour turns by
// `turn_rad` to the left: to where its inner side meets the neighbour.
double run_on_m(double turn_rad, double distance_m) {
  if (turn_rad <= 0.0 || turn_rad >= 0.5 * std::numbers::pi) return 0.0;
  return distance_m * std::min(kMitreLimit, 1.0 / std::tan(turn_rad));
}

void add_ring(const Ring& ring, const std::vector<int>& rounds, const RoundsRange& of,
              ZoneMaking& zone) {
  const std::size_t count = ring.size();
  const auto chosen = [&](std::size_t edge) {
    return rounds[edge] >= of.least && rounds[edge] <= of.most;
  };
  for (std::size_t edge = 0; edge < count; ++edge) {
    if (!chosen(edge)) continue;
    const std::size_t before = (edge + count - 1) % count;
    const std::size_t after = (edge + 1) % count;
    const Vector2d run = along(ring, edge);
    const auto turn_from = [&](const Vector2d& in, const Vector2d& out) {
      return std::atan2(cross(in, out), in.dot(out));
    };
    const double turn_before_rad = turn_from(along(ring, before), run);
    const double turn_after_rad = turn_from(run, along(ring, after));
    const double early_m = chosen(before) ? 0.0 : run_on_m(turn_before_rad, zone.distance_m);
    const double late_m = chosen(after) ? 0.0 : run_on_m(turn_after_rad, zone.distance_m);
    const Vector2d a_W = ring[edge] - early_m * run;
    const Vector2d b_W = ring[after] + late_m * run;
    const Vector2d inwards = zone.distance_m * to_left(run);
    zone.pieces.push_back({{PolygonPart{{a_W, b_W, b_W + inwards, a_W + inwards}, {}}}});
    zone.beside_W.emplace_back(0.5 * (ring[edge] + ring[after]) + kBeside_m * to_left(run));
    // Round about corners that stick into the ground, once for two edges that are both chosen.
    const auto add_pie = [&](const Vector2d& p_W, double from_rad, double turn_rad) {
      if (turn_rad >= 0.0) return;
      const int chords = std::max(
          1, static_cast<int>(std::ceil(-turn_rad / (0.5 * std::numbers::pi) * kQuadrantSegments)));
      Ring pie{p_W};
      for (int i = chords; i >= 0; --i) {
        pie.emplace_back(p_W + zone.distance_m * left_of(from_rad + turn_rad * i / chords));
      }
      zone.pieces.push_back({{PolygonPart{std::move(pie), {}}}});
    };
    const double heading_rad = std::atan2(run.y(), run.x());
    add_pie(ring[after], heading_rad, turn_after_rad);
    if (!chosen(before)) add_pie(ring[edge], heading_rad - turn_before_rad, turn_before_rad);
  }
}

}  // namespace

EdgedGround edged_ground(PolygonSet ground, const EdgeRounds& edges) {
  EdgedGround edged{std::move(ground), {}};
  const auto add = [&](const Ring& ring) {
    std::vector<int> rounds;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      rounds.push_back(rounds_at(0.5 * (ring[i] + ring[(i + 1) % ring.size()]), edges));
    }
    edged.rounds.push_back(std::move(rounds));
  };
  for (const PolygonPart& part : edged.ground.parts) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return edged;
}

PolygonSet zone_beside(const EdgedGround& edged, const RoundsRange& of, double distance_m) {
  ZoneMaking zone{distance_m, {}, {}};
  std::size_t ring = 0;
  for (const PolygonPart& part : edged.ground.parts) {
    add_ring(part.outer, edged.rounds[ring++], of, zone);
    for (const Ring& hole : part.holes) add_ring(hole, edged.rounds[ring++], of, zone);
  }
  if (zone.pieces.empty() || !(distance_m > 0.0)) return {};
  PolygonSet found = intersection(united(zone.pieces), edged.ground);
  std::erase_if(found.parts, [&](const PolygonPart& part) {
    return std::ranges::none_of(zone.beside_W,
                                [&](const Vector2d& p_W) { return holds(part, p_W); });
  });
  return found;
}

}  // namespace headland

// Ground beside the edges of a field that have their own number of headland passes.
#pragma once

#include <limits>
#include <vector>

#include "planner/headland_edges.h"
#include "planner/polygon.h"

namespace headland {

// Ground whose every edge knows its rounds.
struct EdgedGround {
  PolygonSet ground;
  // By ring - of each part the outer one, then its holes - and point: of the edge that begins
  // there.
  std::vector<std::vector<int>> rounds;
};

// `ground` is the field's (from_field); what is none of its outlines, obstacles', has `others`
// rounds.
EdgedGround edged_ground(PolygonSet ground, const EdgeRounds& edges);

// Calls visit(a_W, b_W, rounds) for every edge of an EdgedGround, which may be const.
template <typename Edged, typename Visit>
void for_each_edge(Edged& edged, Visit visit) {
  std::size_t ring = 0;
  const auto look = [&](const Ring& points) {
    auto& of_edges = edged.rounds[ring++];
    for (std::size_t i = 0; i < points.size(); ++i) {
      visit(points[i], points[(i + 1) % points.size()], of_edges[i]);
    }
  };
  for (const PolygonPart& part : edged.ground.parts) {
    look(part.outer);
    for (const Ring& hole : part.holes) look(hole);
  }
}

// Which edges: those with [least, most] rounds.
struct RoundsRange {
  int least = 0;
  int most = std::numeric_limits<int>::max();
};

// Ground within `distance_m` of those edges, on the side of them that is worked, straight on past
// their ends as far as neighbours lean out, and round about corners that stick into the ground.
// What is as near across ground that is not the field's, as behind a hedge, is left out.
PolygonSet zone_beside(const EdgedGround& edged, const RoundsRange& of, double distance_m);

}  // namespace headland

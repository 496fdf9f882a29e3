#include "planner/visit_order.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>

namespace headland {
namespace {

// Fields visited, the last of them and the gate by which it is left. In a given order the set
// follows from the last field and is not kept.
using State = std::tuple<std::uint64_t, std::size_t, std::size_t>;

struct Reached {
  double cost = std::numeric_limits<double>::infinity();
  State before;
  Visit visit;
};
using Layer = std::map<State, Reached>;

void reach(Layer& layer, const State& state, const Reached& reached) {
  if (!std::isfinite(reached.cost)) return;
  const auto [entry, is_new] = layer.try_emplace(state, reached);
  if (!is_new && reached.cost < entry->second.cost) entry->second = reached;
}

}  // namespace

std::optional<std::vector<Visit>> cheapest_visits(const VisitCosts& costs, bool order_given,
                                                  const CancelAsked& cancelled) {
  const std::size_t fields = costs.gates.size();
  assert(order_given || fields <= kMostOrdered);
  const auto bit = [&](std::size_t field) {
    return order_given ? std::uint64_t{0} : std::uint64_t{1} << field;
  };
  std::vector<Layer> layers(fields);
  const auto visit = [&](Layer& layer, std::size_t field, double so_far, std::uint64_t set,
                         const State& before, auto cost_to) {
    for (const std::size_t in : costs.gates[field]) {
      for (const std::size_t out : costs.gates[field]) {
        reach(layer, {set | bit(field), field, out},
              {so_far + cost_to(in) + costs.within[in][out], before, {field, in, out}});
      }
    }
  };
  for (std::size_t field = 0; field < (order_given ? 1 : fields); ++field) {
    visit(layers.front(), field, 0.0, 0, {},
          [&](std::size_t in) { return costs.from_start.empty() ? 0.0 : costs.from_start[in]; });
  }
  for (std::size_t k = 1; k < fields; ++k) {
    stop_if(cancelled);
    for (const auto& [state, reached] : layers[k - 1]) {
      const auto& [set, last, out] = state;
      for (std::size_t field = order_given ? k : 0; field < (order_given ? k + 1 : fields);
           ++field) {
        if (!order_given && (set & bit(field)) != 0) continue;
        const std::vector<double>& onward = costs.between[out];
        visit(layers[k], field, reached.cost, set, state,
              [&onward](std::size_t in) { return onward[in]; });
      }
    }
  }
  double best = std::numeric_limits<double>::infinity();
  State end;
  for (const auto& [state, reached] : layers.back()) {
    const double cost =
        reached.cost + (costs.to_end.empty() ? 0.0 : costs.to_end[std::get<2>(state)]);
    if (cost >= best) continue;
    best = cost;
    end = state;
  }
  if (!std::isfinite(best)) return std::nullopt;
  std::vector<Visit> visits;
  for (std::size_t k = fields; k-- > 0;) {
    const Reached& reached = layers[k].at(end);
    visits.push_back(reached.visit);
    end = reached.before;
  }
  std::ranges::reverse(visits);
  return visits;
}

}  // namespace headland

#include "planner/order_descent.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace headland {
namespace {

constexpr int kLongestSection = 3;   // cells that are moved together
constexpr int kNearStepsLength = 3;  // which cells are near, where length alone counts
constexpr int kNearStepsTurns = 1;
constexpr int kLooksPerCheck = 256;     // between questions whether to go on
constexpr int kLongestChange = 50000;   // places; rearranging them takes as long
constexpr int kLongestDirected = 1000;  // places that are walked the other way to price it

void look_at(Descent& descent, int place) {
  if (place < 0 || place >= static_cast<int>(descent.order.size())) return;
  const int node = at(descent.order, place);
  if (at(descent.waits, node) != 0) return;
  at(descent.waits, node) = 1;
  descent.to_look_at.push_back(node);
}

double cost_change(Descent& descent, const OrderChange& change, double most) {
  ++descent.evaluations;
  if (!change.moves) {
    return change_by_reversal(descent.cost, descent.order, change.i, change.j, most);
  }
  return change_by_move(descent.cost, descent.order, change.i, change.j, change.to,
                        change.turned_round, most);
}

void apply(Descent& descent, const OrderChange& change) {
  if (change.moves) {
    move_section(descent.order, change.i, change.j, change.to, change.turned_round);
  } else {
    std::reverse(descent.order.begin() + change.i, descent.order.begin() + change.j + 1);
  }
  const int first = change.moves ? std::min(change.i, change.to + 1) : change.i;
  const int last = change.moves ? std::max(change.j, change.to) : change.j;
  for (int i = first; i <= last; ++i) at(descent.place, at(descent.order, i)) = i;
}

OrderChange inverse(const OrderChange& change) {
  if (!change.moves) return change;
  const int more = change.j - change.i;
  if (change.to > change.j) {
    return {change.to - more, change.to, change.i - 1, true, change.turned_round};
  }
  return {change.to + 1, change.to + 1 + more, change.j, true, change.turned_round};
}

// Applies a change worth `worth` and remembers it and the places around it.
void make(Descent& descent, const OrderChange& change, double worth) {
  apply(descent, change);
  descent.change += worth;
  descent.done.push_back(change);
  const int low = change.moves ? std::min(change.i, change.to + 1) : change.i;
  const int high = change.moves ? std::max(change.j, change.to) : change.j;
  const int more = change.j - change.i;
  const int inner = change.moves && change.to > change.j ? high - more : low + more;
  for (const int at : {low, high, inner}) {
    for (int around = at - 2; around <= at + 2; ++around) look_at(descent, around);
  }
}

bool is_allowed(const Descent& descent, const OrderChange& change) {
  const FreePlaces& places = descent.places;
  if (change.i < places.first || change.j >= places.end || change.i > change.j) return false;
  const int low = change.moves ? std::min(change.i, change.to) : change.i;
  const int high = change.moves ? std::max(change.j, change.to) : change.j;
  const int longest = descent.cost.directed ? kLongestDirected : kLongestChange;
  if (high - low > longest) return false;
  if (!change.moves) return change.i < change.j;
  const bool apart = change.to < change.i - 1 || change.to > change.j;
  return apart && change.to >= places.first - 1 && change.to < places.end;
}

bool make_if_cheaper(Descent& descent, const OrderChange& change) {
  if (is_spent(descent) || !is_allowed(descent, change)) return false;
  const double worth = cost_change(descent, change, -kNoChange);
  if (worth >= -kNoChange) return false;
  make(descent, change, worth);
  return true;
}

// Tries all that brings the nodes at these places beside each other in the order.
bool improve_pair(Descent& descent, int at, int near) {
  const int low = std::min(at, near);
  const int high = std::max(at, near);
  if (make_if_cheaper(descent, {low + 1, high, 0, false, false}) ||
      make_if_cheaper(descent, {low, high - 1, 0, false, false})) {
    return true;
  }
  for (int more = 0; more < kLongestSection; ++more) {
    // Sections that begin and that end at `at`, put before and after the other.
    if (make_if_cheaper(descent, {at, at + more, near, true, false}) ||
        make_if_cheaper(descent, {at, at + more, near - 1, true, true}) ||
        make_if_cheaper(descent, {at - more, at, near - 1, true, false}) ||
        make_if_cheaper(descent, {at - more, at, near, true, true})) {
      return true;
    }
  }
  return false;
}

// The longest way from the place to those before and after it; where length alone counts, only
// what is nearer than that can shorten the path.
int longest_way(const Descent& descent, int place) {
  const DistanceTable& steps = *descent.cost.table;
  int longest = 0;
  const int last = static_cast<int>(descent.order.size()) - 1;
  if (place > 0) longest = steps(at(descent.order, place - 1), at(descent.order, place));
  if (place < last) {
    longest = std::max(longest, steps(at(descent.order, place), at(descent.order, place + 1)));
  }
  return longest;
}

// Whether there is anything to gain at the place: a way of more than one step, or a turn.
bool costs_extra(const Descent& descent, int place) {
  const CostShares& shares = descent.cost.shares;
  if (descent.cost.slopes) return true;
  const int first = std::max(place - 1, 0);
  const int last = std::min(place + 1, static_cast<int>(descent.order.size()) - 1);
  OrderWalk walk{descent.cost};
  for (int i = first; i <= last; ++i) walk_on(walk, at(descent.order, i));
  return cost_of_walk(walk) > shares.step * (last - first) + kNoChange;
}

bool improve_at(Descent& descent, int node) {
  const int place = at(descent.place, node);
  if (!costs_extra(descent, place)) return false;
  const int longest = longest_way(descent, place);
  for (const int near : at(descent.near, node)) {
    if (descent.cost.lengths_only && (*descent.cost.table)(node, near) >= longest) return false;
    if (improve_pair(descent, place, at(descent.place, near))) return true;
  }
  return false;
}

}  // namespace

Descent descent_for(const OrderTask& task) {
  const GridGraph& graph = task.problem.graph;
  Descent descent{task.cost,
                  free_places(task.problem),
                  nodes_within(graph, task.cost.lengths_only ? kNearStepsLength : kNearStepsTurns),
                  {},
                  std::vector<int>(graph.cells.size()),
                  {},
                  std::vector<char>(graph.cells.size(), 0),
                  {}};
  const std::int64_t limit = task.search.stop.evaluations;
  if (limit > 0) descent.most_evaluations = limit;
  return descent;
}

bool is_spent(const Descent& descent) { return descent.evaluations >= descent.most_evaluations; }

void set_order(Descent& descent, std::vector<int> order) {
  descent.order = std::move(order);
  for (int i = static_cast<int>(descent.order.size()) - 1; i >= 0; --i) {
    at(descent.place, at(descent.order, i)) = i;
    look_at(descent, i);
  }
}

void descend(Descent& descent, PlanSearch& search) {
  const auto ends = [&] {
    if (!is_spent(descent) && ++descent.looked < kLooksPerCheck) return false;
    descent.looked = 0;
    search.evaluations = descent.evaluations;
    return !goes_on(search);
  };
  while (!descent.to_look_at.empty()) {
    if (ends()) return;
    const int node = descent.to_look_at.back();
    descent.to_look_at.pop_back();
    at(descent.waits, node) = 0;
    while (improve_at(descent, node)) {
      if (ends()) return;
    }
  }
}

void kick(Descent& descent, int most_cells, SeededRandom& random) {
  const int count = descent.places.end - descent.places.first;
  const int longest = std::min(most_cells, count / 2);
  const int one = 1 + draw_below(random, longest);
  const int other = 1 + draw_below(random, longest);
  const int i = descent.places.first + draw_below(random, count - one - other + 1);
  const OrderChange change{i, i + one - 1, i + one + other - 1, true, false};
  make(descent, change, cost_change(descent, change, std::numeric_limits<double>::infinity()));
}

void take_back(Descent& descent) {
  for (auto change = descent.done.rbegin(); change != descent.done.rend(); ++change) {
    apply(descent, inverse(*change));
  }
}

}  // namespace headland

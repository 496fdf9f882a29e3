// An order of cells that is improved by small changes until none of them makes it cheaper.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "planner/order_task.h"

namespace headland {

// A change of the order: of order[i] .. order[j], turned round where it is, or moved to `to` as
// change_by_move says.
struct OrderChange {
  int i = 0;
  int j = 0;
  int to = 0;
  bool moves = false;
  bool turned_round = false;
};

// Changes are turning a section round (2-opt) and moving up to three cells elsewhere, turned round
// or not (Or-opt), where either brings a cell beside one of its near ones: where length alone
// counts, cells within three steps and nearer than the present neighbours, else neighbours on the
// map. Cells that are reached and left by single steps straight on are not looked at. No change
// rearranges more than 50 000 places, or 1000 where steps cost more one way than the other.
// Bentley, 'Fast algorithms for geometric traveling salesman problems', 1992.
struct Descent {
  const OrderCost& cost;               // not owned
  FreePlaces places;                   // nothing outside of them is changed
  std::vector<std::vector<int>> near;  // by node, nearest first
  std::vector<int> order;
  std::vector<int> place;         // of each node, its first where a closed tour has two
  std::vector<int> to_look_at;    // nodes whose surroundings changed, last first
  std::vector<char> waits;        // whether a node is in it
  std::vector<OrderChange> done;  // since it was last emptied
  double change = 0.0;            // of the cost by them
  std::int64_t evaluations = 0;
  std::int64_t most_evaluations = std::numeric_limits<std::int64_t>::max();
  int looked = 0;  // since it was last asked whether to go on
};

// Without an order yet; looks at no more changes than the task's limit of evaluations lets it.
Descent descent_for(const OrderTask& task);

// Whether the limit of evaluations is reached.
bool is_spent(const Descent& descent);

// Takes another order, to be looked at everywhere.
void set_order(Descent& descent, std::vector<int> order);

// Until nothing is left to gain or the search is over. Throws Cancelled.
void descend(Descent& descent, PlanSearch& search);

// Two neighbouring sections of at most so many cells change places (a double bridge). Asks for two
// places that may change.
void kick(Descent& descent, int most_cells, SeededRandom& random);

// Undoes what is done.
void take_back(Descent& descent);

}  // namespace headland

#include "planner/visit_order.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace headland {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();

double cost_of(const VisitCosts& costs, const std::vector<Visit>& visits) {
  double sum = costs.from_start.empty() ? 0.0 : costs.from_start[visits.front().in];
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (i > 0) sum += costs.between[visits[i - 1].out][visits[i].in];
    sum += costs.within[visits[i].in][visits[i].out];
  }
  return sum + (costs.to_end.empty() ? 0.0 : costs.to_end[visits.back().out]);
}

// Every choice of gates along one order of the fields.
double cheapest_along(const VisitCosts& costs, const std::vector<std::size_t>& order,
                      std::vector<Visit>& visits) {
  if (visits.size() == order.size()) return cost_of(costs, visits);
  double best = kNoWay;
  const std::size_t field = order[visits.size()];
  for (const std::size_t in : costs.gates[field]) {
    for (const std::size_t out : costs.gates[field]) {
      visits.push_back({field, in, out});
      best = std::min(best, cheapest_along(costs, order, visits));
      visits.pop_back();
    }
  }
  return best;
}

// Up to five fields with up to three gates each; some ways are missing.
VisitCosts any_costs() {
  VisitCosts costs;
  const auto fields = static_cast<std::size_t>(*rc::gen::inRange(1, 6));
  std::size_t gates = 0;
  for (std::size_t i = 0; i < fields; ++i) {
    costs.gates.emplace_back(static_cast<std::size_t>(*rc::gen::inRange(1, 4)));
    std::iota(costs.gates.back().begin(), costs.gates.back().end(), gates);
    gates += costs.gates.back().size();
  }
  const auto any_cost = [] {
    const int cost = *rc::gen::inRange(0, 120);
    return cost > 100 ? kNoWay : static_cast<double>(cost);
  };
  const auto row = [&] {
    std::vector<double> values(gates);
    for (double& value : values) value = any_cost();
    return values;
  };
  for (std::size_t i = 0; i < gates; ++i) {
    costs.within.push_back(row());
    costs.between.push_back(row());
  }
  if (*rc::gen::arbitrary<bool>()) costs.from_start = row();
  if (*rc::gen::arbitrary<bool>()) costs.to_end = row();
  return costs;
}

TEST(VisitOrder, IsTheCheapestOfAll) {
  EXPECT_TRUE(rc::check([] {
    const VisitCosts costs = any_costs();
    std::vector<std::size_t> order(costs.gates.size());
    std::iota(order.begin(), order.end(), 0U);
    const std::vector<std::size_t> given = order;
    double best = kNoWay;
    std::vector<Visit> visits;
    do {
      best = std::min(best, cheapest_along(costs, order, visits));
    } while (std::ranges::next_permutation(order).found);
    const auto found = cheapest_visits(costs, false);
    RC_ASSERT(found.has_value() == (best < kNoWay));
    if (found) RC_ASSERT(std::abs(cost_of(costs, *found) - best) < 1e-9);
    const double best_given = cheapest_along(costs, given, visits);
    const auto as_given = cheapest_visits(costs, true);
    RC_ASSERT(as_given.has_value() == (best_given < kNoWay));
    if (!as_given) return;
    RC_ASSERT(std::abs(cost_of(costs, *as_given) - best_given) < 1e-9);
    for (std::size_t i = 0; i < given.size(); ++i) RC_ASSERT((*as_given)[i].field == i);
  }));
}

// Twelve fields on a line, visited from its begin.
TEST(VisitOrder, OrdersAsManyFieldsAsItSays) {
  VisitCosts costs;
  for (std::size_t i = 0; i < kMostOrdered; ++i) {
    costs.gates.push_back({i});
    costs.within.emplace_back(kMostOrdered, 1.0);
    costs.from_start.push_back(static_cast<double>((7 * i) % kMostOrdered));
  }
  costs.between.resize(kMostOrdered);
  for (std::size_t i = 0; i < kMostOrdered; ++i) {
    for (std::size_t j = 0; j < kMostOrdered; ++j) {
      costs.between[i].push_back(std::abs(costs.from_start[i] - costs.from_start[j]));
    }
  }
  const auto visits = cheapest_visits(costs, false);
  ASSERT_TRUE(visits);
  EXPECT_NEAR(cost_of(costs, *visits), 12.0 + 11.0, 1e-9);
  EXPECT_TRUE(cheapest_visits(costs, false, [] { return false; }));
  EXPECT_THROW(cheapest_visits(costs, false, [] { return true; }), Cancelled);
}

}  // namespace
}  // namespace headland

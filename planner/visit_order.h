// In which order fields are visited, and through which of their gates.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "planner/cancel.h"

namespace headland {

// Costs [m or anything else that adds up]; infinity where there is no way. Gates are counted over
// all fields, field by field.
struct VisitCosts {
  std::vector<std::vector<std::size_t>> gates;  // of each field, at least one
  std::vector<std::vector<double>> within;      // [in][out], both of one field: working it
  std::vector<std::vector<double>> between;     // [out][in]: from gate to gate
  std::vector<double> from_start;               // to each gate; empty: begins anywhere for nothing
  std::vector<double> to_end;                   // likewise from each gate
};

struct Visit {
  std::size_t field = 0;
  std::size_t in = 0;  // gates
  std::size_t out = 0;
};

// The cheapest sequence that visits every field once: exact, by dynamic programming over (set of
// fields visited, last one, its gate; Held and Karp 1962), or in the order given with the cheapest
// gates. None when no sequence has a finite cost. At most kMostOrdered fields are ordered. Throws
// Cancelled.
std::optional<std::vector<Visit>> cheapest_visits(const VisitCosts& costs, bool order_given,
                                                  const CancelAsked& cancelled = {});

inline constexpr std::size_t kMostOrdered = 12;

}  // namespace headland

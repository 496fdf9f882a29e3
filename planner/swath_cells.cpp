#include "planner/swath_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace headland {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Improvements below this are rounding [m].
constexpr double kGain_m = 1e-6;
constexpr std::size_t kCorners = 4;

bool overlap(const Swath& a, const Swath& b) {
  return std::min(a.to_m, b.to_m) > std::max(a.from_m, b.from_m);
}

struct Ends {
  Eigen::Vector2d entry_W;
  Eigen::Vector2d exit_W;
};

// Entry and exit of each cell for each corner it can be begun at; corner ^ opposite is the visit
// driven backwards.
struct CornerTable {
  std::vector<std::array<Ends, kCorners>> ends;
  std::vector<std::size_t> backwards;  // exclusive-or mask
  std::optional<Eigen::Vector2d> start_W;

  double from_start(std::size_t cell, std::size_t corner) const {
    return start_W ? (ends[cell][corner].entry_W - *start_W).norm() : 0.0;
  }
  double between(std::size_t cell_a, std::size_t corner_a, std::size_t cell_b,
                 std::size_t corner_b) const {
    return (ends[cell_b][corner_b].entry_W - ends[cell_a][corner_a].exit_W).norm();
  }
};

CellVisit visit_of(std::size_t cell, std::size_t corner) {
  return {cell, (corner & 1U) != 0, (corner & 2U) != 0};
}

Eigen::Vector2d end_of(const SwathGrid& grid, std::size_t swath, bool far_end) {
  const Swath& s = grid.swaths[swath];
  return point_on_line(grid, s.line, far_end ? s.to_m : s.from_m);
}

CornerTable corner_table(const SwathGrid& grid, const std::vector<SwathCell>& cells,
                         const std::optional<Eigen::Vector2d>& start_W) {
  CornerTable table;
  table.start_W = start_W;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const bool odd = cells[cell].size() % 2 == 1;
    std::array<Ends, kCorners> ends;
    for (std::size_t corner = 0; corner < kCorners; ++corner) {
      const CellVisit visit = visit_of(cell, corner);
      const std::size_t first = visit.from_last_line ? cells[cell].back() : cells[cell].front();
      const std::size_t last = visit.from_last_line ? cells[cell].front() : cells[cell].back();
      ends[corner] = {end_of(grid, first, visit.from_far_end),
                      end_of(grid, last, visit.from_far_end != odd)};
    }
    table.ends.push_back(ends);
    table.backwards.push_back(odd ? 3U : 1U);
  }
  return table;
}

// A cell and the corner it is begun at.
using Stop = std::pair<std::size_t, std::size_t>;

std::vector<Stop> exact_order(const CornerTable& table) {
  const std::size_t count = table.ends.size();
  const std::size_t states = count * kCorners;
  const std::size_t subsets = std::size_t{1} << count;
  std::vector<double> cost(subsets * states, kInfinity);
  std::vector<std::size_t> before(subsets * states, states);
  for (std::size_t state = 0; state < states; ++state) {
    const std::size_t cell = state / kCorners;
    cost[(std::size_t{1} << cell) * states + state] = table.from_start(cell, state % kCorners);
  }
  for (std::size_t subset = 1; subset < subsets; ++subset) {
    for (std::size_t at = 0; at < states; ++at) {
      const double so_far_m = cost[subset * states + at];
      if (so_far_m == kInfinity) continue;
      for (std::size_t to = 0; to < states; ++to) {
        const std::size_t bit = std::size_t{1} << (to / kCorners);
        if ((subset & bit) != 0) continue;
        const double total_m =
            so_far_m + table.between(at / kCorners, at % kCorners, to / kCorners, to % kCorners);
        const std::size_t next = (subset | bit) * states + to;
        if (total_m < cost[next]) {
          cost[next] = total_m;
          before[next] = at;
        }
      }
    }
  }
  std::size_t subset = subsets - 1;
  const auto last = cost.begin() + static_cast<std::ptrdiff_t>(subset * states);
  auto at = static_cast<std::size_t>(
      std::min_element(last, last + static_cast<std::ptrdiff_t>(states)) - last);
  std::vector<Stop> order;
  while (at != states) {
    order.emplace_back(at / kCorners, at % kCorners);
    const std::size_t previous = before[subset * states + at];
    subset &= ~(std::size_t{1} << (at / kCorners));
    at = previous;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<Stop> nearest_neighbour_order(const CornerTable& table) {
  std::vector<Stop> order;
  std::vector<bool> done(table.ends.size(), false);
  while (order.size() < table.ends.size()) {
    Stop nearest;
    double nearest_m = kInfinity;
    for (std::size_t cell = 0; cell < table.ends.size(); ++cell) {
      for (std::size_t corner = 0; !done[cell] && corner < kCorners; ++corner) {
        const double distance_m =
            order.empty() ? table.from_start(cell, corner)
                          : table.between(order.back().first, order.back().second, cell, corner);
        if (distance_m < nearest_m) {
          nearest_m = distance_m;
          nearest = {cell, corner};
        }
      }
    }
    done[nearest.first] = true;
    order.push_back(nearest);
  }
  return order;
}

double link_m(const CornerTable& table, const std::vector<Stop>& order, std::size_t to) {
  if (to >= order.size()) return 0.0;
  if (to == 0) return table.from_start(order[0].first, order[0].second);
  return table.between(order[to - 1].first, order[to - 1].second, order[to].first,
                       order[to].second);
}

void drive_backwards(const CornerTable& table, std::vector<Stop>& order, std::size_t first,
                     std::size_t last) {
  for (std::size_t i = first; i <= last; ++i) order[i].second ^= table.backwards[order[i].first];
  std::reverse(order.begin() + static_cast<std::ptrdiff_t>(first),
               order.begin() + static_cast<std::ptrdiff_t>(last) + 1);
}

// The two links of a stretch if it were driven backwards.
double links_backwards_m(const CornerTable& table, const std::vector<Stop>& order,
                         std::size_t first, std::size_t last) {
  const auto turned = [&](const Stop& stop) {
    return Stop{stop.first, stop.second ^ table.backwards[stop.first]};
  };
  const Stop begin = turned(order[last]);
  const Stop end = turned(order[first]);
  double sum_m = first == 0 ? table.from_start(begin.first, begin.second)
                            : table.between(order[first - 1].first, order[first - 1].second,
                                            begin.first, begin.second);
  if (last + 1 < order.size()) {
    sum_m += table.between(end.first, end.second, order[last + 1].first, order[last + 1].second);
  }
  return sum_m;
}

// Drives a stretch backwards where that shortens its two links; inside it the links stay.
bool improve_by_reversal(const CornerTable& table, std::vector<Stop>& order) {
  bool improved = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i; j < order.size(); ++j) {
      const double before_m = link_m(table, order, i) + link_m(table, order, j + 1);
      if (links_backwards_m(table, order, i, j) >= before_m - kGain_m) continue;
      drive_backwards(table, order, i, j);
      improved = true;
    }
  }
  return improved;
}

// Takes one cell out and puts it where, begun at its best corner, it adds least.
bool improve_by_moving(const CornerTable& table, std::vector<Stop>& order) {
  bool improved = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<Stop> rest = order;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    const double with_m = link_m(table, order, i) + link_m(table, order, i + 1);
    double best_m = with_m - link_m(table, rest, i) - kGain_m;
    std::size_t best_at = order.size();
    Stop best_stop = order[i];
    for (std::size_t at = 0; at <= rest.size(); ++at) {
      for (std::size_t corner = 0; corner < kCorners; ++corner) {
        const Stop stop{order[i].first, corner};
        double added_m =
            at == 0 ? table.from_start(stop.first, corner)
                    : table.between(rest[at - 1].first, rest[at - 1].second, stop.first, corner);
        if (at < rest.size()) {
          added_m += table.between(stop.first, corner, rest[at].first, rest[at].second) -
                     link_m(table, rest, at);
        }
        if (added_m < best_m) {
          best_m = added_m;
          best_at = at;
          best_stop = stop;
        }
      }
    }
    if (best_at < order.size()) {
      rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(best_at), best_stop);
      order = std::move(rest);
      improved = true;
    }
  }
  return improved;
}

}  // namespace

std::vector<SwathCell> cells_of(const SwathGrid& grid) {
  const std::size_t count = grid.swaths.size();
  std::vector<std::vector<std::size_t>> after(count);
  std::vector<std::size_t> before(count, 0);
  for (std::size_t a = 0, line_begin = 0; a < count; ++a) {
    while (grid.swaths[line_begin].line <= grid.swaths[a].line && line_begin + 1 < count) {
      ++line_begin;
    }
    for (std::size_t b = line_begin; b < count && grid.swaths[b].line <= grid.swaths[a].line + 1;
         ++b) {
      if (grid.swaths[b].line == grid.swaths[a].line + 1 &&
          overlap(grid.swaths[a], grid.swaths[b])) {
        after[a].push_back(b);
        ++before[b];
      }
    }
  }
  std::vector<SwathCell> cells;
  std::vector<bool> taken(count, false);
  for (std::size_t first = 0; first < count; ++first) {
    if (taken[first]) continue;
    SwathCell cell{first};
    taken[first] = true;
    while (after[cell.back()].size() == 1 && before[after[cell.back()].front()] == 1) {
      cell.push_back(after[cell.back()].front());
      taken[cell.back()] = true;
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::vector<CellVisit> order_cells(const SwathGrid& grid, const std::vector<SwathCell>& cells,
                                   const std::optional<Eigen::Vector2d>& start_W,
                                   const CancelAsked& cancelled) {
  const CornerTable table = corner_table(grid, cells, start_W);
  std::vector<Stop> order;
  if (cells.size() <= kExactCells) {
    if (!cells.empty()) order = exact_order(table);
  } else {
    order = nearest_neighbour_order(table);
    bool improved = true;
    while (improved) {
      stop_if(cancelled);
      const bool reversed = improve_by_reversal(table, order);
      improved = improve_by_moving(table, order) || reversed;
    }
  }
  std::vector<CellVisit> visits;
  visits.reserve(order.size());
  for (const auto& [cell, corner] : order) visits.push_back(visit_of(cell, corner));
  return visits;
}

std::vector<Pass> passes_of(const SwathGrid& grid, const SwathCell& cell, const CellVisit& visit) {
  std::vector<Pass> passes;
  bool backwards = visit.from_far_end;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::size_t swath = visit.from_last_line ? cell[cell.size() - 1 - i] : cell[i];
    passes.push_back(
        {PassKind::kSwath, {end_of(grid, swath, backwards), end_of(grid, swath, !backwards)}});
    backwards = !backwards;
  }
  return passes;
}

}  // namespace headland

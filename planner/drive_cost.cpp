#include "planner/drive_cost.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

namespace headland {
namespace {

// The turn of one kind at this spacing.
std::optional<RowTurnCost> row_turn(const DriveCost& cost, RowTurn kind, double row_spacing_m) {
  const RowTurnCost* below = nullptr;
  const RowTurnCost* above = nullptr;
  for (const RowTurnCost& turn : cost.row_turns) {
    if (turn.kind != kind) continue;
    if (turn.row_spacing_m <= row_spacing_m &&
        (below == nullptr || turn.row_spacing_m > below->row_spacing_m)) {
      below = &turn;
    }
    if (turn.row_spacing_m >= row_spacing_m &&
        (above == nullptr || turn.row_spacing_m < above->row_spacing_m)) {
      above = &turn;
    }
  }
  if (below == nullptr && above == nullptr) return std::nullopt;
  if (below == nullptr) return *above;
  if (above == nullptr || above == below) return *below;
  const double share =
      (row_spacing_m - below->row_spacing_m) / (above->row_spacing_m - below->row_spacing_m);
  RowTurnCost between = *below;
  between.row_spacing_m = row_spacing_m;
  between.length_m += share * (above->length_m - below->length_m);
  between.extra_wh += share * (above->extra_wh - below->extra_wh);
  return between;
}

}  // namespace

double wh_per_m(const SlopeCost& cost, double slope_along, double slope_across) {
  assert(!cost.slope.empty() && cost.slope.size() == cost.wh_per_m.size());
  const double across = std::clamp(slope_across, -kSteepest, kSteepest);
  const double side = cost.across_wh_per_m * across * across;
  if (cost.slope.size() == 1) return cost.wh_per_m.front() + side;
  const double along = std::clamp(slope_along, -kSteepest, kSteepest);
  const auto above = std::upper_bound(cost.slope.begin() + 1, cost.slope.end() - 1, along);
  const auto i = static_cast<std::size_t>(above - cost.slope.begin());
  const double share = (along - cost.slope[i - 1]) / (cost.slope[i] - cost.slope[i - 1]);
  const double straight = cost.wh_per_m[i - 1] + share * (cost.wh_per_m[i] - cost.wh_per_m[i - 1]);
  return std::max(straight, 0.0) + side;
}

double energy_wh(const DriveCost& cost, const RowTurnCost& turn) {
  return turn.length_m * wh_per_m(cost.raised, 0.0) + turn.extra_wh;
}

RowTurnCost cheapest_row_turn(const DriveCost& cost, double row_spacing_m) {
  std::optional<RowTurnCost> best;
  for (const RowTurn kind : {RowTurn::kU, RowTurn::kOmega, RowTurn::kThreePoint, RowTurn::kPivot}) {
    // The vehicle has no U turn between rows nearer than twice its radius.
    if (kind == RowTurn::kU && row_spacing_m < 2.0 * cost.turning_radius_m) continue;
    const bool too_far = (kind == RowTurn::kOmega || kind == RowTurn::kThreePoint) &&
                         row_spacing_m > 2.0 * cost.turning_radius_m;
    if (too_far) continue;
    const auto turn = row_turn(cost, kind, row_spacing_m);
    if (turn && (!best || energy_wh(cost, *turn) < energy_wh(cost, *best))) best = turn;
  }
  assert(best.has_value());
  return *best;
}

}  // namespace headland

#include "planner/pass_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "planner/turns.h"
#include "planner/way_lengths.h"

namespace headland {
namespace {

using Eigen::Vector2d;

constexpr double kSaving_m = 1e-3;
constexpr std::size_t kLongestMoved = 3;

// From each pass's end to each pass's begin; row 0 is from the start.
struct Links {
  std::size_t count = 0;
  std::vector<double> cost_m;

  double operator()(std::size_t from, std::size_t to) const { return cost_m[from * count + to]; }
};

Links links_of(const std::vector<Pass>& passes, const std::optional<Vector2d>& from_W,
               const FreeSpace& space, double radius_m, const CancelAsked& cancelled) {
  const std::size_t count = passes.size();
  std::vector<Vector2d> ends_W{from_W.value_or(passes.front().points_W.front())};
  std::vector<Vector2d> begins_W;
  for (const Pass& pass : passes) {
    ends_W.push_back(pass.points_W.back());
    begins_W.push_back(pass.points_W.front());
  }
  const WayLengths ways(space, ends_W, begins_W);
  Links links{count, std::vector<double>((count + 1) * count, 0.0)};
  for (std::size_t from = 0; from <= count; ++from) {
    stop_if(cancelled);
    for (std::size_t to = 0; to < count; ++to) {
      double& cost_m = links.cost_m[from * count + to];
      cost_m = ways.between_m(from, to);
      if (from == 0) continue;
      // Far apart the curve is hardly longer than the way.
      constexpr double kNear = 10.0;
      if (cost_m > kNear * radius_m) continue;
      cost_m = std::max(cost_m, reeds_shepp_length_m(end_pose(passes[from - 1].points_W),
                                                     begin_pose(passes[to].points_W), radius_m));
    }
  }
  return links;
}

// Nodes of the order are counted from 1, as rows of the links; 0 is the start.
double link_m(const Links& links, const std::vector<std::size_t>& order, std::size_t at) {
  if (at >= order.size()) return 0.0;
  return links(at == 0 ? 0 : order[at - 1], order[at] - 1);
}

// Moves one stretch to where it adds least; whether that saved something.
bool improve(const Links& links, std::vector<std::size_t>& order) {
  bool improved = false;
  for (std::size_t length = 1; length <= kLongestMoved; ++length) {
    for (std::size_t i = 0; i + length <= order.size(); ++i) {
      const double before_m = link_m(links, order, i) + link_m(links, order, i + length);
      std::vector<std::size_t> rest = order;
      const auto first = rest.begin() + static_cast<std::ptrdiff_t>(i);
      rest.erase(first, first + static_cast<std::ptrdiff_t>(length));
      const double saved_m = before_m - link_m(links, rest, i);
      const std::size_t head = order[i];
      const std::size_t tail = order[i + length - 1];
      double least_m = saved_m - kSaving_m;
      std::size_t best = order.size();
      for (std::size_t at = 0; at <= rest.size(); ++at) {
        double added_m = links(at == 0 ? 0 : rest[at - 1], head - 1) - link_m(links, rest, at);
        if (at < rest.size()) added_m += links(tail, rest[at] - 1);
        if (added_m >= least_m) continue;
        least_m = added_m;
        best = at;
      }
      if (best == order.size()) continue;
      rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(best),
                  order.begin() + static_cast<std::ptrdiff_t>(i),
                  order.begin() + static_cast<std::ptrdiff_t>(i + length));
      order = std::move(rest);
      improved = true;
    }
  }
  return improved;
}

}  // namespace

std::vector<Pass> ordered(std::vector<Pass> passes, const std::optional<Vector2d>& from_W,
                          const FreeSpace& space, double turning_radius_m,
                          const CancelAsked& cancelled) {
  if (passes.size() < 2) return passes;
  const Links links = links_of(passes, from_W, space, turning_radius_m, cancelled);
  std::vector<std::size_t> order;
  std::vector<std::size_t> left(passes.size());
  std::iota(left.begin(), left.end(), 1);
  while (!left.empty()) {
    const std::size_t from = order.empty() ? 0 : order.back();
    const auto nearest =
        std::ranges::min_element(left, {}, [&](std::size_t pass) { return links(from, pass - 1); });
    order.push_back(*nearest);
    left.erase(nearest);
  }
  while (improve(links, order)) stop_if(cancelled);
  std::vector<Pass> result;
  result.reserve(order.size());
  for (const std::size_t pass : order) result.push_back(std::move(passes[pass - 1]));
  return result;
}

}  // namespace headland

#include "planner/swath_order.h"

#include <algorithm>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "planner/drive_cost.h"
#include "planner/line_energy.h"
#include "planner/turns.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// Savings below this are rounding, of metres and of W h.
constexpr double kLeastSaving = 1e-6;
constexpr std::size_t kLongestStretch = 3;

// Ends are counted 2 i (front) and 2 i + 1 (back of swath i); a swath driven from its end e is the
// stop e, and is left by e ^ 1.
using SwathStop = std::size_t;

Pose pose_into(const Vector2d& at_W, const Vector2d& to_W) {
  const Vector2d along = to_W - at_W;
  return {at_W, std::atan2(along.y(), along.x())};
}

// The implement works where swaths end, the axle goes on.
Pose axle_at(const Pose& pose, const DriveCost& cost) {
  return {pose.p_W - cost.implement_x_m * direction_of(pose.heading_rad), pose.heading_rad};
}

double measured_turn_wh(const Pose& from, const Pose& to, const TurnCosts& costs) {
  const DriveCost& cost = *costs.measured;
  const Pose out = axle_at(from, cost);
  const Pose in = axle_at(to, cost);
  const double half_circle_m = std::numbers::pi * cost.turning_radius_m;
  const double crow_wh = line_wh(cost.raised, costs.terrain, out.p_W, in.p_W) +
                         turn_wh(cost, {{half_circle_m, 1.0 / cost.turning_radius_m}});
  if ((in.p_W - out.p_W).norm() > kNearTurns * cost.turning_radius_m) return crow_wh;
  const double least_wh = least_turn_wh(cost, costs.terrain, out, in);
  return std::isfinite(least_wh) ? least_wh : 2.0 * crow_wh;
}

double turn_cost(const Pose& from, const Pose& to, const TurnCosts& costs) {
  if (costs.measured != nullptr) return measured_turn_wh(from, to, costs);
  const double away_m = (to.p_W - from.p_W).norm();
  const double half_circle_m = std::numbers::pi * costs.turning_radius_m;
  if (away_m > kNearTurns * costs.turning_radius_m) return away_m + half_circle_m;
  const auto found = turns(from, to, costs.turning_radius_m, costs.gears);
  return found.empty() ? away_m + 2.0 * half_circle_m : found.front().cost_m;
}

class SwathLinks {
 public:
  SwathLinks(const std::vector<Pass>& swaths, const std::optional<Vector2d>& from_W,
             const TurnCosts& costs)
      : from_W_(from_W), costs_(costs) {
    for (const Pass& swath : swaths) {
      ends_W_.push_back(swath.points_W.front());
      ends_W_.push_back(swath.points_W.back());
    }
  }
  const std::vector<Vector2d>& ends_W() const { return ends_W_; }

  // By measured costs it matters which way a stretch is driven, as it does on slopes.
  bool directed() const { return costs_.measured != nullptr; }

  double from_start(SwathStop to) const {
    if (!from_W_) return 0.0;
    if (!directed()) return (ends_W_[to] - *from_W_).norm();
    return line_wh(costs_.measured->transit, costs_.terrain, *from_W_, ends_W_[to]);
  }
  // Along a swath; 0 in metres, which are the same in any order.
  double along(SwathStop stop) {
    if (!directed()) return 0.0;
    if (along_.empty()) along_.assign(ends_W_.size(), -1.0);
    if (along_[stop] < 0.0) {
      along_[stop] =
          line_wh(costs_.measured->working, costs_.terrain, ends_W_[stop], ends_W_[stop ^ 1U]);
    }
    return along_[stop];
  }
  // Driving one and then the other; in metres the same backwards, as curves and their costs are.
  double between(SwathStop from, SwathStop to) {
    std::uint64_t left = from ^ 1U;
    std::uint64_t right = to;
    if (!directed() && right < left) std::swap(left, right);
    const std::uint64_t key = left * ends_W_.size() + right;
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    const double cost =
        turn_cost(pose_out_of(from), pose_into(ends_W_[to], ends_W_[to ^ 1U]), costs_);
    known_.emplace(key, cost);
    return cost;
  }

 private:
  Pose pose_out_of(SwathStop stop) const {
    const Pose in = pose_into(ends_W_[stop], ends_W_[stop ^ 1U]);
    return {ends_W_[stop ^ 1U], in.heading_rad};
  }

  std::vector<Vector2d> ends_W_;
  std::optional<Vector2d> from_W_;
  TurnCosts costs_;
  std::unordered_map<std::uint64_t, double> known_;
  std::vector<double> along_;  // of each stop; below 0: not known
};

// Of each end the nearest ends of other swaths, nearest first.
std::vector<std::vector<std::size_t>> neighbours_of(const std::vector<Vector2d>& ends_W,
                                                    const CancelAsked& cancelled) {
  namespace bg = boost::geometry;
  using Point = bg::model::point<double, 2, bg::cs::cartesian>;
  using End = std::pair<Point, std::size_t>;
  std::vector<End> ends;
  ends.reserve(ends_W.size());
  for (const Vector2d& p_W : ends_W) ends.emplace_back(Point(p_W.x(), p_W.y()), ends.size());
  const bg::index::rtree<End, bg::index::rstar<16>> tree(ends);
  std::vector<std::vector<std::size_t>> neighbours(ends_W.size());
  std::vector<std::pair<double, std::size_t>> others;
  for (const auto& [at, end] : ends) {
    stop_if(cancelled);
    others.clear();
    // The swath's own two ends come with them.
    for (auto near = tree.qbegin(bg::index::nearest(at, unsigned{kNeighbours} + 2));
         near != tree.qend(); ++near) {
      const std::size_t other = near->second;
      if (other / 2 == end / 2) continue;
      others.emplace_back((ends_W[other] - ends_W[end]).squaredNorm(), other);
    }
    std::ranges::sort(others);
    others.resize(std::min(kNeighbours, others.size()));
    for (const auto& [away_m2, other] : others) neighbours[end].push_back(other);
  }
  return neighbours;
}

struct SwathTour {
  SwathLinks& links;
  std::vector<SwathStop> stops;
  std::vector<std::size_t> place{};  // of each swath among the stops
  // What the stops before each take more driven backwards than as they are, and likewise the links
  // that lead to stops up to it. Of directed links alone.
  std::vector<double> stops_back{};
  std::vector<double> links_back{};

  // From the stop before `at` to it.
  double link(std::size_t at) const {
    if (at == stops.size()) return 0.0;
    return at == 0 ? links.from_start(stops[0]) : links.between(stops[at - 1], stops[at]);
  }
  // The same if other stops were driven there; none after the last.
  double before(std::size_t at, SwathStop stop) const {
    return at == 0 ? links.from_start(stop) : links.between(stops[at - 1], stop);
  }
  double after(SwathStop stop, std::size_t at) const {
    return at == stops.size() ? 0.0 : links.between(stop, stops[at]);
  }
  // What the stretch [first, end) takes more driven backwards, but for the links to it and from it.
  double turned(std::size_t first, std::size_t end) const {
    if (!links.directed()) return 0.0;
    return stops_back[end] - stops_back[first] + links_back[end - 1] - links_back[first];
  }
  void number(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) place[stops[i] / 2] = i;
    if (!links.directed()) return;
    stops_back.resize(stops.size() + 1, 0.0);
    links_back.resize(stops.size(), 0.0);
    for (std::size_t i = first; i < stops.size(); ++i) {
      const SwathStop stop = stops[i];
      stops_back[i + 1] = stops_back[i] + links.along(stop ^ 1U) - links.along(stop);
      if (i == 0) continue;
      const SwathStop before_it = stops[i - 1];
      links_back[i] = links_back[i - 1] + links.between(stop ^ 1U, before_it ^ 1U) -
                      links.between(before_it, stop);
    }
  }
  void reverse(std::size_t first, std::size_t end) {
    const auto begin = stops.begin();
    std::reverse(begin + static_cast<std::ptrdiff_t>(first),
                 begin + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = first; i < end; ++i) stops[i] ^= 1U;
    number(first, end);
  }
};

// Drives the stretch [first, end) backwards if that saves something.
bool try_reversal(SwathTour& tour, std::size_t first, std::size_t end) {
  if (first >= end) return false;
  const double now = tour.link(first) + tour.link(end);
  const double then = tour.before(first, tour.stops[end - 1] ^ 1U) +
                      tour.after(tour.stops[first] ^ 1U, end) + tour.turned(first, end);
  if (then > now - kLeastSaving) return false;
  tour.reverse(first, end);
  return true;
}

// Moves the stretch [first, end) to before the stop `to`, the other way round if asked, if that
// saves something.
bool try_move(SwathTour& tour, std::size_t first, std::size_t end, std::size_t to, bool reversed) {
  if (to >= first && to <= end) return false;
  const SwathStop head = reversed ? tour.stops[end - 1] ^ 1U : tour.stops[first];
  const SwathStop tail = reversed ? tour.stops[first] ^ 1U : tour.stops[end - 1];
  double saved = tour.link(first) + tour.link(end);
  if (end < tour.stops.size()) saved -= tour.before(first, tour.stops[end]);
  double added = tour.before(to, head) + tour.after(tail, to) - tour.link(to);
  if (reversed) added += tour.turned(first, end);
  if (added > saved - kLeastSaving) return false;
  if (reversed) tour.reverse(first, end);
  const auto at = [&](std::size_t i) {
    return tour.stops.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (to < first) {
    std::rotate(at(to), at(first), at(end));
    tour.number(to, end);
  } else {
    std::rotate(at(first), at(end), at(to));
    tour.number(first, to);
  }
  return true;
}

// SwathLinks from what is left at `at` to a near end, and from a near end to what is begun there.
bool improve_by_reversal(SwathTour& tour, const std::vector<std::vector<std::size_t>>& neighbours,
                         std::size_t at) {
  for (const std::size_t near : neighbours[tour.stops[at] ^ 1U]) {
    const std::size_t other = tour.place[near / 2];
    if (other > at && (tour.stops[other] ^ 1U) == near && try_reversal(tour, at + 1, other + 1)) {
      return true;
    }
  }
  for (const std::size_t near : neighbours[tour.stops[at]]) {
    const std::size_t other = tour.place[near / 2];
    if (other < at && tour.stops[other] == near && try_reversal(tour, other, at)) return true;
  }
  return false;
}

bool improve_by_moving(SwathTour& tour, const std::vector<std::vector<std::size_t>>& neighbours,
                       std::size_t at) {
  for (std::size_t end = at + 1; end <= std::min(at + kLongestStretch, tour.stops.size()); ++end) {
    for (const std::size_t near : neighbours[tour.stops[at]]) {
      const std::size_t other = tour.place[near / 2];
      const bool is_begin = tour.stops[other] == near;
      if (try_move(tour, at, end, is_begin ? other : other + 1, is_begin)) return true;
    }
    for (const std::size_t near : neighbours[tour.stops[end - 1] ^ 1U]) {
      const std::size_t other = tour.place[near / 2];
      const bool is_begin = tour.stops[other] == near;
      if (try_move(tour, at, end, is_begin ? other : other + 1, !is_begin)) return true;
    }
  }
  return false;
}

}  // namespace

double link_cost(const Pass& from, const Pass& to, const TurnCosts& costs) {
  return turn_cost(end_pose(from.points_W), begin_pose(to.points_W), costs);
}

double order_cost(const std::vector<Pass>& swaths, const std::optional<Vector2d>& from_W,
                  const TurnCosts& costs) {
  if (swaths.empty()) return 0.0;
  SwathLinks links(swaths, from_W, costs);
  double sum = links.from_start(0);
  for (std::size_t i = 0; i < swaths.size(); ++i) {
    sum += links.along(2 * i);
    if (i > 0) sum += links.between(2 * i - 2, 2 * i);
  }
  return sum;
}

std::vector<Pass> optimised_order(std::vector<Pass> swaths, const std::optional<Vector2d>& from_W,
                                  const TurnCosts& costs, const CancelAsked& cancelled) {
  if (swaths.size() < 2) return swaths;
  SwathLinks links(swaths, from_W, costs);
  const auto neighbours = neighbours_of(links.ends_W(), cancelled);
  SwathTour tour{links, {}};
  tour.place.resize(swaths.size());
  for (std::size_t i = 0; i < swaths.size(); ++i) tour.stops.push_back(2 * i);
  tour.number(0, swaths.size());
  try_reversal(tour, 0, swaths.size());
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t at = 0; at < tour.stops.size(); ++at) {
      stop_if(cancelled);
      while (improve_by_reversal(tour, neighbours, at) || improve_by_moving(tour, neighbours, at)) {
        improved = true;
      }
    }
  }
  std::vector<Pass> ordered;
  for (const SwathStop stop : tour.stops) {
    Pass pass = std::move(swaths[stop / 2]);
    if (stop % 2 == 1) std::ranges::reverse(pass.points_W);
    ordered.push_back(std::move(pass));
  }
  return ordered;
}

}  // namespace headland

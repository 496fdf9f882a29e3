#include "planner/algorithms/region_local_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "planner/indexed.h"

namespace headland {
namespace {

constexpr int kRuins = 100;             // an iteration, and one more a part
constexpr std::size_t kNearParts = 30;  // beside which a part is put back
constexpr int kReach = 2;  // places before and after a part put back whose variants are chosen anew
constexpr int kRuinsPerCheck = 16;  // between questions whether to go on

// Temperature of the annealing, as shares of the mean way between two parts.
constexpr double kFirstTemperature = 0.1;
constexpr double kLastTemperature = 1e-3;

struct Ruin {
  const RegionProblem& problem;
  SeededRandom& random;
  std::vector<std::vector<int>> nearest;  // of each part those near it, itself first
  int most_removed = 1;
  double blink = 0.0;
  std::vector<int> place_of;  // of each part in the plan that is changed; -1: taken out
};

// By the middles of their entries and exits, the nearest first.
std::vector<std::vector<int>> near_parts(const RegionProblem& problem) {
  std::vector<Eigen::Vector2d> middles;
  for (const auto& variants : problem.parts) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const RegionVariant& variant : variants) sum += variant.entry_W + variant.exit_W;
    middles.emplace_back(sum / (2.0 * static_cast<double>(variants.size())));
  }
  const std::size_t count = std::min(middles.size(), kNearParts);
  std::vector<std::vector<int>> nearest;
  for (const Eigen::Vector2d& middle : middles) {
    std::vector<int> parts(middles.size());
    std::iota(parts.begin(), parts.end(), 0);
    std::ranges::stable_sort(parts, {},
                             [&](int part) { return (at(middles, part) - middle).squaredNorm(); });
    parts.resize(count);
    nearest.push_back(std::move(parts));
  }
  return nearest;
}

void note_places(Ruin& ruin, const std::vector<RegionVisit>& visits, int from) {
  for (int place = from; place < static_cast<int>(visits.size()); ++place) {
    at(ruin.place_of, at(visits, place).part) = place;
  }
}

// Takes parts out of the plan: neighbours in it or on the ground.
std::vector<int> removed_parts(Ruin& ruin, std::vector<RegionVisit>& visits) {
  const int count = static_cast<int>(visits.size());
  const int wanted = 1 + draw_below(ruin.random, std::min(count, ruin.most_removed));
  const int place = draw_below(ruin.random, count);
  std::vector<int> removed;
  if (draw_below(ruin.random, 2) == 0) {
    const int first = std::clamp(place - draw_below(ruin.random, wanted), 0, count - wanted);
    for (int i = first; i < first + wanted; ++i) removed.push_back(at(visits, i).part);
  } else {
    const std::vector<int>& nearest = at(ruin.nearest, at(visits, place).part);
    removed.assign(nearest.begin(),
                   nearest.begin() + std::min(wanted, static_cast<int>(nearest.size())));
  }
  for (const int part : removed) at(ruin.place_of, part) = -1;
  std::erase_if(visits, [&](RegionVisit visit) { return at(ruin.place_of, visit.part) < 0; });
  note_places(ruin, visits, 0);
  shuffle(ruin.random, removed, 0, static_cast<int>(removed.size()));
  return removed;
}

// A place of a plan: its part would come before visits[place].
struct Insertion {
  double added = std::numeric_limits<double>::infinity();
  int place = 0;
  int variant = 0;
};

// The variant of a part that makes the plan longer by least at a place.
Insertion best_insertion(const RegionProblem& problem, const std::vector<RegionVisit>& visits,
                         int part, int place) {
  const bool first = place == 0;
  const bool last = place == static_cast<int>(visits.size());
  const RegionVariant* from = first ? nullptr : &variant_of(problem, at(visits, place - 1));
  const RegionVariant* after = last ? nullptr : &variant_of(problem, at(visits, place));
  double saved = 0.0;  // the link that is cut
  if (!first && !last) saved = link_cost(problem, *from, *after);
  if (first && !last) saved = start_cost(problem, *after);
  if (!first && last) saved = end_cost(problem, *from);
  Insertion best;
  const std::vector<RegionVariant>& variants = at(problem.parts, part);
  for (int variant = 0; variant < static_cast<int>(variants.size()); ++variant) {
    const RegionVariant& now = at(variants, variant);
    const double added = (first ? start_cost(problem, now) : link_cost(problem, *from, now)) +
                         now.cost +
                         (last ? end_cost(problem, now) : link_cost(problem, now, *after)) - saved;
    if (added < best.added) best = {added, place, variant};
  }
  return best;
}

// Puts a part where and in the variant it makes the plan longer by least: at either end, or beside
// one of the parts near it.
void insert_part(Ruin& ruin, int part, std::vector<RegionVisit>& visits) {
  const int last = static_cast<int>(visits.size());
  Insertion best = best_insertion(ruin.problem, visits, part, 0);
  const auto look_at = [&](int place) {
    if (draw_unit(ruin.random) < ruin.blink) return;
    const Insertion found = best_insertion(ruin.problem, visits, part, place);
    if (found.added < best.added) best = found;
  };
  look_at(last);
  for (const int near : at(ruin.nearest, part)) {
    const int place = at(ruin.place_of, near);
    if (place < 0) continue;
    look_at(place);
    look_at(place + 1);
  }
  visits.insert(visits.begin() + best.place, {part, best.variant});
  note_places(ruin, visits, best.place);
  choose_variants(ruin.problem, visits, std::max(0, best.place - kReach),
                  std::min(last, best.place + kReach));
}

double mean_link(const RegionProblem& problem, const std::vector<RegionVisit>& visits) {
  double sum = plan_cost(problem, visits);
  for (const RegionVisit visit : visits) sum -= variant_of(problem, visit).cost;
  return std::max(0.0, sum) / static_cast<double>(visits.size());
}

}  // namespace

void choose_variants(const RegionProblem& problem, std::vector<RegionVisit>& visits, int first,
                     int last) {
  // By place and variant: the shortest way from there to what follows the last place, and by which
  // variant it goes on.
  struct Onward {
    double cost = 0.0;
    int next = 0;
  };
  const auto variants_at = [&](int place) -> const std::vector<RegionVariant>& {
    return at(problem.parts, at(visits, place).part);
  };
  const int end = static_cast<int>(visits.size());
  const auto most = static_cast<std::size_t>(most_variants(problem));
  std::vector<Onward> onward(static_cast<std::size_t>(last - first + 1) * most);
  const auto row = [&](int place) {
    return onward.data() + static_cast<std::size_t>(place - first) * most;
  };
  for (int place = last; place >= first; --place) {
    Onward* here = row(place);
    for (const RegionVariant& now : variants_at(place)) {
      Onward best{std::numeric_limits<double>::infinity(), 0};
      if (place == last) {
        best.cost = last + 1 < end
                        ? link_cost(problem, now, variant_of(problem, at(visits, last + 1)))
                        : end_cost(problem, now);
      } else {
        const Onward* there = row(place + 1);
        const std::vector<RegionVariant>& variants = variants_at(place + 1);
        for (std::size_t next = 0; next < variants.size(); ++next) {
          const double own = link_cost(problem, now, variants[next]) + there[next].cost;
          if (own < best.cost) best = {own, static_cast<int>(next)};
        }
      }
      *here++ = {best.cost + now.cost, best.next};
    }
  }
  int variant = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int one = 0; one < static_cast<int>(variants_at(first).size()); ++one) {
    const RegionVariant& now = at(variants_at(first), one);
    const double to_it = first > 0
                             ? link_cost(problem, variant_of(problem, at(visits, first - 1)), now)
                             : start_cost(problem, now);
    if (to_it + row(first)[one].cost >= least) continue;
    least = to_it + row(first)[one].cost;
    variant = one;
  }
  for (int place = first; place <= last; ++place) {
    at(visits, place).variant = variant;
    variant = row(place)[variant].next;
  }
}

std::span<const ParameterSpec> region_local_search_parameters() {
  static const std::array kSpecs{
      ParameterSpec{"most_removed", 12.0, 1.0, 1000.0, {}, "parts taken out at once", true},
      ParameterSpec{"blink", 0.01, 0.0, 0.9, {}, "probability that a place is overlooked"}};
  return kSpecs;
}

RegionPlan plan_region_local_search(const RegionRequest& request) {
  PlanSearch search = begun_search(request);
  SeededRandom random(request.seed);
  const RegionProblem& problem = request.problem;
  Ruin ruin{problem,
            random,
            near_parts(problem),
            static_cast<int>(number(request.parameters, "most_removed")),
            number(request.parameters, "blink"),
            std::vector<int>(problem.parts.size(), -1)};
  std::vector<int> parts(problem.parts.size());
  std::iota(parts.begin(), parts.end(), 0);
  shuffle(random, parts, 0, problem.size());
  std::vector<RegionVisit> now;
  for (const int part : parts) insert_part(ruin, part, now);
  choose_variants(problem, now, 0, problem.size() - 1);
  double now_cost = plan_cost(problem, now);
  std::vector<RegionVisit> best = now;
  ++search.evaluations;
  note_cost(search, now_cost);
  const double scale = mean_link(problem, now);
  while (next_iteration(search)) {
    const double share = share_over(search);
    const double temperature =
        scale * kFirstTemperature * std::pow(kLastTemperature / kFirstTemperature, share);
    for (int i = 0; i < kRuins + problem.size(); ++i) {
      if (i % kRuinsPerCheck == 0 && !goes_on(search)) break;
      std::vector<RegionVisit> changed = now;
      for (const int part : removed_parts(ruin, changed)) insert_part(ruin, part, changed);
      const double changed_cost = plan_cost(problem, changed);
      ++search.evaluations;
      const double dearer = -temperature * std::log(1.0 - draw_unit(random));
      if (changed_cost > now_cost + std::max(dearer, kNoChange)) continue;
      now = std::move(changed);
      now_cost = changed_cost;
      if (note_cost(search, now_cost)) best = now;
    }
  }
  return finished_plan(request, "region_local_search", std::move(best), search);
}

}  // namespace headland

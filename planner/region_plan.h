// In which order the parts of a region are worked, and each in which way: the problem and a plan.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/plan_search.h"
#include "planner/seeded_random.h"
#include "terrains/parameter.h"

namespace headland {

// One way to work a part.
struct RegionVariant {
  Eigen::Vector2d entry_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d exit_W = Eigen::Vector2d::Zero();
  double cost = 0.0;       // from entry to exit: its length [m], or W h by measured costs
  std::size_t number = 0;  // of all variants, for the table of links
};

// What links take by measured costs [W h], in place of their length: from every variant's exit to
// every one's entry, from the start and to the end. Made by price_links (region_energy.h).
struct RegionLinks {
  std::vector<double> between_wh;  // [number of one * size of from_start_wh + number of the next]
  std::vector<double> from_start_wh;  // by number
  std::vector<double> to_end_wh;
};

// IGA-CPP's three scenes are a fixed start, both fixed, and both free.
struct RegionProblem {
  std::vector<std::vector<RegionVariant>> parts;  // at least one, each with at least one variant
  std::optional<Eigen::Vector2d> start_W;
  std::optional<Eigen::Vector2d> end_W;
  std::optional<RegionLinks> links;  // none: links count by their length
  int size() const { return static_cast<int>(parts.size()); }
};

struct RegionVisit {
  int part = 0;
  int variant = 0;
  bool operator==(const RegionVisit&) const = default;
};

struct RegionRequest {
  RegionProblem problem;
  SearchStop stop{150, 0, 0.0, 0};  // the paper's iterations
  Parameters parameters;            // resolved against the planner's specs
  std::uint64_t seed = 1;
  CancelAsked cancelled;  // ends planning with Cancelled
};

struct RegionPlan {
  std::string planner;
  std::vector<RegionVisit> visits;  // every part once
  double cost = 0.0;                // plan_cost
  bool proven = false;              // no plan costs less
  std::vector<ConvergencePoint> convergence;
  int iterations = 0;
  std::int64_t evaluations = 0;
  StopReason stopped_by = StopReason::kIterations;
};

// Eq (5) of the paper: from the start to the first entry, between exits and entries as the crow
// flies, from the last exit to the end, and the ways in the parts. An end that is free adds
// nothing. Metres, or W h of a problem with measured costs.
double plan_cost(const RegionProblem& problem, std::span<const RegionVisit> visits);

inline const RegionVariant& variant_of(const RegionProblem& problem, RegionVisit visit) {
  return problem
      .parts[static_cast<std::size_t>(visit.part)][static_cast<std::size_t>(visit.variant)];
}
// From the start to a visit, from one to the next, and from a visit to the end.
double start_cost(const RegionProblem& problem, const RegionVariant& first);
inline double link_cost(const RegionProblem& problem, const RegionVariant& one,
                        const RegionVariant& next) {
  if (!problem.links) return (next.entry_W - one.exit_W).norm();
  const RegionLinks& links = *problem.links;
  return links.between_wh[one.number * links.from_start_wh.size() + next.number];
}
double end_cost(const RegionProblem& problem, const RegionVariant& last);

int most_variants(const RegionProblem& problem);  // of any part

// What messages about a request name as its source.
inline const std::string kRegionPlanSource = "region plan";

// A search that runs by the request's limits. Throws InputError as check_stop, for a problem
// without parts or a part without variants, and for numbers that are not finite.
PlanSearch begun_search(const RegionRequest& request);

// The plan; its cost is counted anew.
RegionPlan finished_plan(const RegionRequest& request, const std::string& planner,
                         std::vector<RegionVisit> visits, const PlanSearch& search);

}  // namespace headland

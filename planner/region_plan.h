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
  double length_m = 0.0;  // from entry to exit
};

// IGA-CPP's three scenes are a fixed start, both fixed, and both free.
struct RegionProblem {
  std::vector<std::vector<RegionVariant>> parts;  // at least one, each with at least one variant
  std::optional<Eigen::Vector2d> start_W;
  std::optional<Eigen::Vector2d> end_W;
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
  double length_m = 0.0;
  bool proven = false;  // no plan is shorter
  std::vector<ConvergencePoint> convergence;
  int iterations = 0;
  std::int64_t evaluations = 0;
  StopReason stopped_by = StopReason::kIterations;
};

// Eq (5) of the paper: from the start to the first entry, between exits and entries as the crow
// flies, from the last exit to the end, and the ways in the parts. An end that is free adds
// nothing.
double length_m(const RegionProblem& problem, std::span<const RegionVisit> visits);

inline const RegionVariant& variant_of(const RegionProblem& problem, RegionVisit visit) {
  return problem
      .parts[static_cast<std::size_t>(visit.part)][static_cast<std::size_t>(visit.variant)];
}
// From the start to a visit, from one to the next, and from a visit to the end [m].
double start_link_m(const RegionProblem& problem, const RegionVariant& first);
inline double link_m(const RegionVariant& one, const RegionVariant& next) {
  return (next.entry_W - one.exit_W).norm();
}
double end_link_m(const RegionProblem& problem, const RegionVariant& last);

int most_variants(const RegionProblem& problem);  // of any part

// What messages about a request name as its source.
inline const std::string kRegionPlanSource = "region plan";

// A search that runs by the request's limits. Throws InputError as check_stop, for a problem
// without parts or a part without variants, and for numbers that are not finite.
PlanSearch begun_search(const RegionRequest& request);

// The plan; its length is counted anew.
RegionPlan finished_plan(const RegionRequest& request, const std::string& planner,
                         std::vector<RegionVisit> visits, const PlanSearch& search);

}  // namespace headland

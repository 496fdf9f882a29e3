// The order in which headland passes are driven, and where rounds are begun.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/edge_passes.h"
#include "planner/headland_rings.h"
#include "planner/plan.h"

namespace headland {

// `headland_passes` and `headland_order`, for tables of planners.
std::span<const ParameterSpec> headland_parameters();

// `headland_passes`; auto: as many as turning needs (rounds_for_turning).
int asked_rounds(const PlanRequest& request);

// Parameters that may help where wheels cannot keep off rows, of those not chosen yet.
std::vector<std::string> ways_off_rows(const PlanRequest& request);

// Where the vehicle is after these passes; before any, at the entry.
std::optional<Eigen::Vector2d> end_of(const std::vector<Pass>& passes,
                                      const std::optional<Eigen::Vector2d>& entry_W);

// Rounds `inwards`, from the outermost on, as before the swaths: those of the boundary first, then
// those around holes by nearness; outwards the other way round, so that the field is left from its
// edge. Each begins at its point, and runs in the direction, with the shortest forward curve from
// where the vehicle comes from. Throw Cancelled.
void append_rings(const std::vector<HeadlandRing>& rings, bool inwards, const PlanRequest& request,
                  std::vector<Pass>& passes);

// Those that `headland_order` has before the swaths, and those that it has after them.
void append_rings_before(const Headland& headland, const PlanRequest& request,
                         std::vector<Pass>& passes);
void append_rings_after(const Headland& headland, const PlanRequest& request,
                        std::vector<Pass>& passes);

// Likewise with passes into corners: those of one ring follow each other around it, from the one
// that begins nearest on. They are `optional`.
void append_edge_passes(const std::vector<EdgePass>& edges, bool inwards,
                        const PlanRequest& request, std::vector<Pass>& passes);
void append_edge_passes_before(const std::vector<EdgePass>& edges, const PlanRequest& request,
                               std::vector<Pass>& passes);
void append_edge_passes_after(const std::vector<EdgePass>& edges, const PlanRequest& request,
                              std::vector<Pass>& passes);

}  // namespace headland

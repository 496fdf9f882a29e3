// What is wrong with a ring, and where: planar topology by GEOS.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "terrains/field.h"

namespace headland {

struct RingFault {
  std::string reason;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
};

// Why a ring of at least three finite points does not bound an area: it crosses, touches or
// retraces itself.
std::optional<RingFault> ring_fault(const Ring& ring);

// A place [m] where the edges of two rings come within `nearest_m` of each other.
std::optional<Eigen::Vector2d> meeting_place(const Ring& a, const Ring& b, double nearest_m);

}  // namespace headland

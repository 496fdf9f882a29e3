// How far it is from place to place inside a field, around holes and bays.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "planner/free_space.h"

namespace headland {

// Shortest ways [m] from places to others over square cells that a disc of the hull's
// half width fits in (Dijkstra; at most 8 % longer than in the plane), straight where nothing is in
// between. A place in no such cell counts to the nearest; what is not connected is kNoWay_m apart.
class WayLengths {
 public:
  WayLengths(const FreeSpace& space, const std::vector<Eigen::Vector2d>& from_W,
             const std::vector<Eigen::Vector2d>& to_W);
  // From the place `from` of the first to `to` of the second.
  double between_m(std::size_t from, std::size_t to) const {
    return length_m_[from * to_count_ + to];
  }

 private:
  std::size_t to_count_;
  std::vector<float> length_m_;
};

inline constexpr double kNoWay_m = 1e6;
// Cells along the longer side of the field.
inline constexpr double kWayCells = 96.0;

}  // namespace headland

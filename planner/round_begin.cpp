#include "planner/round_begin.h"

#include <algorithm>

namespace headland {

std::vector<RoundBegin> round_begins(const Polyline& round, const Eigen::Vector2d& from_W) {
  const std::size_t count = round.size() - 1;
  const double per_point_m = length_m(round) / static_cast<double>(count);
  const auto step =
      std::max<std::size_t>(1, static_cast<std::size_t>(kBeginSpacing_m / per_point_m));
  std::vector<RoundBegin> begins;
  for (std::size_t point = 0; point < count; point += step) {
    begins.push_back({point, false});
    begins.push_back({point, true});
  }
  std::ranges::stable_sort(
      begins, {}, [&](const RoundBegin& b) { return (round[b.point] - from_W).squaredNorm(); });
  return begins;
}

Polyline begun_at(const Polyline& round, const RoundBegin& begin) {
  const auto first = round.begin() + static_cast<std::ptrdiff_t>(begin.point);
  Polyline line(first, round.end() - 1);
  line.insert(line.end(), round.begin(), first);
  line.push_back(line.front());
  if (begin.reversed) std::ranges::reverse(line);
  return line;
}

}  // namespace headland

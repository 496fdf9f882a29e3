#include "planner/swath_pattern.h"

#include <algorithm>
#include <cmath>

namespace headland {
namespace {

// The two halves of count lines from `first` in turn, that from `low` or that from `high` first.
void append_halves(std::size_t first, std::size_t low, std::size_t high, std::size_t count,
                   std::vector<std::size_t>& sequence) {
  for (std::size_t i = 0; i < count; ++i) {
    sequence.push_back(first + (i % 2 == 0 ? low : high) + i / 2);
  }
}

// Whether the order so far ends on its furthest line: the next land then begins in its middle.
bool ends_on_last(const std::vector<std::size_t>& sequence) {
  return !sequence.empty() && sequence.back() + 1 == sequence.size();
}

std::vector<std::size_t> skipping(std::size_t count, std::size_t skip) {
  const std::size_t least_land = 2 * skip + 3;
  const std::size_t lands = std::max<std::size_t>(1, count / least_land);
  std::vector<std::size_t> sequence;
  for (std::size_t land = 0; land < lands; ++land) {
    const std::size_t first = count * land / lands;
    const std::size_t size = count * (land + 1) / lands - first;
    // Halves are nearer to each other by one when the lower one begins.
    const bool small = count < least_land && size % 2 == 0;
    if (ends_on_last(sequence) || small) {
      append_halves(first, size / 2, 0, size, sequence);
    } else {
      append_halves(first, 0, (size + 1) / 2, size, sequence);
    }
  }
  return sequence;
}

}  // namespace

std::vector<std::size_t> swath_sequence(std::size_t count, SwathPattern pattern, std::size_t skip) {
  if (pattern == SwathPattern::kSkip) return skipping(count, skip);
  std::vector<std::size_t> sequence(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool from_far_side = pattern == SwathPattern::kSpiral && i % 2 == 1;
    if (pattern == SwathPattern::kNext) {
      sequence[i] = i;
    } else {
      sequence[i] = from_far_side ? count - 1 - i / 2 : i / 2;
    }
  }
  return sequence;
}

std::size_t skip_for_u_turns(double spacing_m, double turning_radius_m) {
  constexpr double kRounding = 1e-9;
  const double apart = std::ceil(2.0 * turning_radius_m / spacing_m - kRounding);
  return static_cast<std::size_t>(std::max(0.0, apart - 1.0));
}

}  // namespace headland

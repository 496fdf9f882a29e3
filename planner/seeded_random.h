// Random draws of searches, the same with every standard library.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "planner/indexed.h"

namespace headland {

// std::mt19937_64 is fixed by the standard to the bit; its distributions are not.
struct SeededRandom {
  explicit SeededRandom(std::uint64_t seed) : engine(seed) {}
  std::mt19937_64 engine;
};

// In [0, 1), on multiples of 2^-53.
inline double draw_unit(SeededRandom& random) {
  return static_cast<double>(random.engine() >> 11) * 0x1.0p-53;
}

// One of 0 .. count - 1, each as likely to within 2^-32; count is positive.
inline int draw_below(SeededRandom& random, int count) {
  return static_cast<int>(((random.engine() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
}

// An entry with probability in proportion to its share; `sums` are those of the shares up to and
// with each entry, the last of them positive.
inline int draw_by_sums(SeededRandom& random, const std::vector<double>& sums) {
  const auto drawn = std::ranges::upper_bound(sums, draw_unit(random) * sums.back());
  return static_cast<int>(std::min(drawn - sums.begin(), std::ssize(sums) - 1));
}

// All orders of entries from `first` up to but without `end` are equally likely (Fisher and Yates).
template <typename Entry>
void shuffle(SeededRandom& random, std::vector<Entry>& entries, int first, int end) {
  for (int i = end - 1; i > first; --i) {
    std::swap(at(entries, i), at(entries, first + draw_below(random, i - first + 1)));
  }
}

}  // namespace headland

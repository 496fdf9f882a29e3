// Random draws of searches, the same with every standard library.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "planner/indexed.h"

namespace headland {

// xoshiro256++ 1.0, Blackman and Vigna, 'Scrambled linear pseudorandom number generators', ACM
// Trans. Math. Softw. 47(4), 2021, seeded by SplitMix64 as they advise. Searches draw at every step
// they look at; the standard's generators take several times as long.
struct SeededRandom {
  explicit SeededRandom(std::uint64_t seed) {
    for (std::uint64_t& word : state) {
      seed += 0x9e3779b97f4a7c15U;
      word = (seed ^ (seed >> 30U)) * 0xbf58476d1ce4e5b9U;
      word = (word ^ (word >> 27U)) * 0x94d049bb133111ebU;
      word ^= word >> 31U;
    }
  }
  std::array<std::uint64_t, 4> state{};
};

// 64 bits.
inline std::uint64_t draw_bits(SeededRandom& random) {
  auto& [a, b, c, d] = random.state;
  const std::uint64_t drawn = std::rotl(a + d, 23) + a;
  const std::uint64_t shifted = b << 17U;
  c ^= a;
  d ^= b;
  b ^= c;
  a ^= d;
  c ^= shifted;
  d = std::rotl(d, 45);
  return drawn;
}

// In [0, 1), on multiples of 2^-53.
inline double draw_unit(SeededRandom& random) {
  return static_cast<double>(draw_bits(random) >> 11U) * 0x1.0p-53;
}

// One of 0 .. count - 1, each as likely to within 2^-32; count is positive.
inline int draw_below(SeededRandom& random, int count) {
  return static_cast<int>(((draw_bits(random) >> 32U) * static_cast<std::uint64_t>(count)) >> 32U);
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

// Random numbers that depend on the seed alone, the same with every standard library.
#pragma once

#include <cstdint>
#include <vector>

namespace headland {

// The draw-th number of a seed, uniform in [0, 1): a counter run through the SplitMix64 mixer
// (Steele, Lea, Flood 2014), so that any draw is had without those before it.
double seeded_uniform(std::uint64_t seed, std::uint64_t draw);

// `count` numbers of a standard normal distribution (Box-Muller on std::mt19937_64).
std::vector<double> seeded_normals(std::uint64_t seed, std::size_t count);

}  // namespace headland

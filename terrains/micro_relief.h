// Roughness on top of a terrain's shape.
#pragma once

#include <cstdint>

#include "terrains/heightfield.h"
#include "terrains/terrain_source.h"

namespace headland {

// Adds a homogeneous Gaussian random surface: rms height rms_m, autocorrelation
// exp(-(r / correlation_m)^2). White noise of the seed convolved with the kernel
// exp(-2 (r / correlation_m)^2), normalised on the grid, so the rms is exact in expectation.
// Asserts correlation_m >= kCellsPerCorrelation cells, below which the grid cannot carry the
// correlation.
void add_micro_relief(const MicroRelief& relief, std::uint64_t seed, Heightfield& terrain);

inline constexpr double kCellsPerCorrelation = 2.0;

}  // namespace headland

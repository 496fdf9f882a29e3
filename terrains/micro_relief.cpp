#include "terrains/micro_relief.h"

#include <cassert>
#include <cmath>

#include "terrains/seeded_noise.h"

namespace headland {
namespace {

// exp(-2 * 3^2) is 1.5e-8 of the kernel's peak.
constexpr double kKernelReach = 3.0;  // correlation lengths

// One side of the separable kernel, from its middle outwards; the squares of all taps sum to one.
std::vector<double> half_kernel(double correlation_cells) {
  std::vector<double> taps(static_cast<std::size_t>(std::ceil(kKernelReach * correlation_cells)) +
                           1);
  double squares = 0.0;
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const double r = static_cast<double>(i) / correlation_cells;
    taps[i] = std::exp(-2.0 * r * r);
    squares += (i == 0 ? 1.0 : 2.0) * taps[i] * taps[i];
  }
  for (double& tap : taps) tap /= std::sqrt(squares);
  return taps;
}

}  // namespace

void add_micro_relief(const MicroRelief& relief, std::uint64_t seed, Heightfield& terrain) {
  if (relief.rms_m == 0.0) return;
  const double correlation_cells = relief.correlation_m / terrain.cell_m;
  // A hair of slack for cells derived from the correlation length.
  assert(correlation_cells >= kCellsPerCorrelation * (1.0 - 1e-9));
  const std::vector<double> taps = half_kernel(correlation_cells);
  const std::size_t reach = taps.size() - 1;
  const auto columns = static_cast<std::size_t>(terrain.columns);
  const auto rows = static_cast<std::size_t>(terrain.rows);
  const std::size_t wide = columns + 2 * reach;
  const std::size_t tall = rows + 2 * reach;
  const std::vector<double> white = seeded_normals(seed, wide * tall);

  std::vector<double> smooth_in_x(columns * tall);
  for (std::size_t j = 0; j < tall; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double* middle = &white[j * wide + i + reach];
      double sum = taps[0] * *middle;
      for (std::size_t k = 1; k <= reach; ++k) {
        sum += taps[k] * (*(middle - k) + *(middle + k));
      }
      smooth_in_x[j * columns + i] = sum;
    }
  }
  std::vector<double> row(columns);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i)
      row[i] = taps[0] * smooth_in_x[(j + reach) * columns + i];
    for (std::size_t k = 1; k <= reach; ++k) {
      const double* below = &smooth_in_x[(j + reach - k) * columns];
      const double* above = &smooth_in_x[(j + reach + k) * columns];
      for (std::size_t i = 0; i < columns; ++i) row[i] += taps[k] * (below[i] + above[i]);
    }
    for (std::size_t i = 0; i < columns; ++i) {
      terrain.height_m[j * columns + i] += relief.rms_m * row[i];
    }
  }
}

}  // namespace headland

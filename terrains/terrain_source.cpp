#include "terrains/terrain_source.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "terrains/input_error.h"
#include "terrains/micro_relief.h"
#include "terrains/raster.h"

namespace headland {
namespace {

constexpr double kDefaultCell_m = 1.0;
// Heights, the warp's two rasters and what finds the nodes without data, at their worst.
constexpr double kBytesPerNode = 80.0;

void require_in_range(const std::string& source, const std::string& key, double value, double min,
                      double max, const std::string& unit) {
  if (value >= min && value <= max) return;
  throw InputError(source, key, fmt::format("{}", value),
                   fmt::format("a number from {} to {} {}", min, max, unit));
}

void require_numbers(const TerrainSource& terrain, const std::string& source) {
  if (terrain.cell_m != 0.0) {
    require_in_range(source, "terrain.cell_m", terrain.cell_m, kMinCell_m, kMaxCell_m, "m");
  }
  require_in_range(source, "terrain.margin_m", terrain.margin_m, kMinMargin_m, kMaxMargin_m, "m");
  const MicroRelief& relief = terrain.micro_relief;
  require_in_range(source, "terrain.micro_relief.rms_m", relief.rms_m, 0.0, kMaxRoughness_m, "m");
  if (relief.rms_m == 0.0) return;
  require_in_range(source, "terrain.micro_relief.correlation_m", relief.correlation_m,
                   kMinCorrelation_m, kMaxCorrelation_m, "m");
  const double finest_m = relief.correlation_m / kCellsPerCorrelation;
  if (terrain.cell_m > finest_m) {
    throw InputError(source, "terrain.cell_m", fmt::format("{}", terrain.cell_m),
                     fmt::format("at most {} m, half of micro_relief.correlation_m", finest_m));
  }
}

double chosen_cell_m(const TerrainSource& terrain, const Field& field) {
  if (terrain.cell_m != 0.0) return terrain.cell_m;
  double cell_m = kDefaultCell_m;
  if (!terrain.file.empty()) {
    cell_m = std::min(cell_m, native_cell_m(terrain.file, terrain.crs, field));
  }
  if (terrain.micro_relief.rms_m > 0.0) {
    cell_m = std::min(cell_m, terrain.micro_relief.correlation_m / kCellsPerCorrelation);
  }
  return std::max(cell_m, kMinCell_m);
}

// Nodes at whole multiples of the cell, at least the margin beyond the box on every side.
Heightfield grid_over(const Eigen::AlignedBox2d& box_W, double margin_m, double cell_m,
                      const std::string& source) {
  const Eigen::Array2d first = ((box_W.min().array() - margin_m) / cell_m).floor();
  const Eigen::Array2d last = ((box_W.max().array() + margin_m) / cell_m).ceil();
  const Eigen::Array2d nodes = (last - first).max(1.0) + 1.0;
  const double bytes = nodes.prod() * kBytesPerNode;
  if (bytes > kMaxTerrainBytes) {
    const double coarsest_m = cell_m * std::sqrt(bytes / kMaxTerrainBytes);
    throw InputError(
        source, "terrain.cell_m", fmt::format("{}", cell_m),
        fmt::format("{:.0f} x {:.0f} nodes need {:.1f} GB, {:.1f} GB are allowed: give at least "
                    "{:.2g} m",
                    nodes.x(), nodes.y(), bytes * 1e-9, kMaxTerrainBytes * 1e-9,
                    // Rounded up to the two digits printed.
                    coarsest_m * 1.05));
  }
  Heightfield terrain;
  terrain.columns = static_cast<int>(nodes.x());
  terrain.rows = static_cast<int>(nodes.y());
  terrain.cell_m = cell_m;
  terrain.origin_W = (first * cell_m).matrix();
  return terrain;
}

void generate(const GeneratorEntry& generator, const Parameters& parameters, std::uint64_t seed,
              const Eigen::Vector2d& middle_W, Heightfield& terrain) {
  terrain.height_m.reserve(static_cast<std::size_t>(terrain.columns) *
                           static_cast<std::size_t>(terrain.rows));
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p =
          terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j) - middle_W;
      terrain.height_m.push_back(generator.height_m(p.x(), p.y(), parameters, seed));
    }
  }
}

const GeneratorEntry& generator_named(const std::string& name, const std::string& source) {
  const auto found = std::ranges::find(generators(), name, &GeneratorEntry::name);
  if (found != generators().end()) return *found;
  std::vector<std::string> names;
  for (const GeneratorEntry& entry : generators()) names.emplace_back(entry.name);
  throw InputError(source, "terrain.generator", name,
                   "unknown generator; the nearest is " + nearest_name(name, names));
}

}  // namespace

Heightfield read_terrain(const TerrainSource& source_terrain, const Field& field,
                         const std::string& source) {
  require_numbers(source_terrain, source);
  Eigen::AlignedBox2d box_W;
  for (const Eigen::Vector2d& p_W : field.boundary) box_W.extend(p_W);
  Heightfield terrain =
      grid_over(box_W, source_terrain.margin_m, chosen_cell_m(source_terrain, field), source);
  if (!source_terrain.file.empty()) {
    read_raster(source_terrain.file, source_terrain.crs, field, terrain);
  } else {
    const GeneratorEntry& generator = generator_named(source_terrain.generator, source);
    const Parameters parameters =
        resolve_parameters(generator.parameters, source_terrain.parameters, source, "terrain");
    generate(generator, parameters, source_terrain.seed, box_W.center(), terrain);
  }
  add_micro_relief(source_terrain.micro_relief, source_terrain.seed, terrain);
  return terrain;
}

}  // namespace headland

#include "terrains/grid_map_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "terrains/input_error.h"
#include "terrains/seeded_noise.h"

namespace headland {
namespace {

constexpr int kWholeTries = 50;      // maps begun anew
constexpr int kTriesPerBlock = 400;  // places tried for one obstacle
constexpr double kMaxAspect = 3.0;

struct Draws {
  std::uint64_t seed = 1;
  std::uint64_t drawn = 0;

  double unit() { return seeded_uniform(seed, drawn++); }
  int below(int count) { return static_cast<int>(unit() * count); }
};

// A rectangle whose northernmost row has only its first `last_row` cells.
struct Block {
  int width = 1;
  int height = 1;
  int last_row = 1;
};

// Random parts, each at least 1, that sum to `total`; none is far above the others.
std::vector<int> split(int total, int parts, Draws& draws) {
  std::vector<double> weights(static_cast<std::size_t>(parts));
  for (double& weight : weights) weight = 0.3 + draws.unit();
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<int> sizes;
  int rest = total - parts;
  for (const double weight : weights) {
    const int more = std::min(rest, static_cast<int>((total - parts) * weight / sum));
    sizes.push_back(1 + more);
    rest -= more;
  }
  for (; rest > 0; --rest) ++sizes[static_cast<std::size_t>(draws.below(parts))];
  return sizes;
}

Block block_of(int cells, Draws& draws) {
  const double aspect = std::pow(kMaxAspect, 2.0 * draws.unit() - 1.0);
  const int width = std::clamp(static_cast<int>(std::lround(std::sqrt(cells * aspect))), 1, cells);
  const int height = (cells + width - 1) / width;
  return {width, height, cells - width * (height - 1)};
}

// Whether the block and a rim of one cell around it are free, and no corner of the map is taken.
bool has_room(const GridMap& map, const Block& block, GridCell at) {
  for (int row = at.row - 1; row <= at.row + block.height; ++row) {
    for (int column = at.column - 1; column <= at.column + block.width; ++column) {
      const GridCell cell{column, row};
      if (on_map(map, cell) && !is_free(map, cell)) return false;
    }
  }
  const bool at_side = at.column == 0 || at.column + block.width == map.columns;
  const bool at_end = at.row == 0 || at.row + block.height == map.rows;
  return !(at_side && at_end);
}

bool throw_block(GridMap& map, const Block& block, Draws& draws) {
  if (block.width >= map.columns || block.height >= map.rows) return false;
  for (int i = 0; i < kTriesPerBlock; ++i) {
    const GridCell at{draws.below(map.columns - block.width + 1),
                      draws.below(map.rows - block.height + 1)};
    if (!has_room(map, block, at)) continue;
    for (int row = 0; row < block.height; ++row) {
      const int width = row + 1 == block.height ? block.last_row : block.width;
      for (int column = 0; column < width; ++column) {
        map.blocked[index_of(map, {at.column + column, at.row + row})] = 1;
      }
    }
    return true;
  }
  return false;
}

std::optional<GridMap> thrown_map(const GridMapRecipe& recipe, int blocked, Draws& draws) {
  GridMap map = free_grid_map(recipe.columns, recipe.rows);
  std::vector<int> sizes = split(blocked, recipe.obstacles, draws);
  std::ranges::sort(sizes, std::ranges::greater{});
  for (const int cells : sizes) {
    if (!throw_block(map, block_of(cells, draws), draws)) return std::nullopt;
  }
  return map;
}

}  // namespace

GridMap made_up_grid_map(const GridMapRecipe& recipe, const std::string& source) {
  const GridMap size = free_grid_map(std::clamp(recipe.columns, 0, kMaxGridSide + 1),
                                     std::clamp(recipe.rows, 0, kMaxGridSide + 1));
  check_grid_map(size, source);
  if (!(recipe.blocked_share >= 0.0 && recipe.blocked_share <= kMaxBlockedShare)) {
    throw InputError(source, "blocked_share", fmt::format("{}", recipe.blocked_share),
                     fmt::format("a number from 0 to {}", kMaxBlockedShare));
  }
  const double cells = static_cast<double>(recipe.columns) * recipe.rows;
  const int blocked = static_cast<int>(std::lround(cells * recipe.blocked_share));
  if (recipe.obstacles < 0 || recipe.obstacles > blocked ||
      (recipe.obstacles == 0 && blocked > 0)) {
    throw InputError(source, "obstacles", fmt::format("{}", recipe.obstacles),
                     fmt::format("a number from {} to {}, the number of blocked cells",
                                 std::min(blocked, 1), blocked));
  }
  if (blocked == 0) return size;
  Draws draws{recipe.seed};
  for (int i = 0; i < kWholeTries; ++i) {
    const std::optional<GridMap> map = thrown_map(recipe, blocked, draws);
    if (map && areas_of(*map).areas.size() == 1) return *map;
  }
  throw InputError(source, "obstacles",
                   fmt::format("{} of {} cells in all on {} x {}", recipe.obstacles, blocked,
                               recipe.columns, recipe.rows),
                   "found no place for them; fewer obstacles or a smaller blocked_share");
}

}  // namespace headland

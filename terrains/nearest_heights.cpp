#include "terrains/nearest_heights.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace headland {
namespace {

struct Node {
  std::int32_t column = -1;  // below 0: nothing known yet
  std::int32_t row = -1;
};

std::int64_t squared_cells(const Node& node, int column, int row) {
  const std::int64_t dx = node.column - column;
  const std::int64_t dy = node.row - row;
  return dx * dx + dy * dy;
}

}  // namespace

void carry_heights_outwards(const std::vector<unsigned char>& known, Heightfield& terrain) {
  assert(std::ranges::find(known, 1) != known.end());
  const int columns = terrain.columns;
  const int rows = terrain.rows;
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  };
  std::vector<Node> nearest(known.size());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (known[index(i, j)] != 0) nearest[index(i, j)] = {i, j};
    }
  }
  const auto learn_from = [&](int i, int j, int from_i, int from_j) {
    if (from_i < 0 || from_j < 0 || from_i >= columns || from_j >= rows) return;
    const Node& heard = nearest[index(from_i, from_j)];
    Node& own = nearest[index(i, j)];
    if (heard.column < 0) return;
    if (own.column < 0 || squared_cells(heard, i, j) < squared_cells(own, i, j)) own = heard;
  };
  const auto sweep_row = [&](int j, int from_j) {
    for (int i = 0; i < columns; ++i) {
      for (int step = -1; step <= 1; ++step) learn_from(i, j, i + step, from_j);
      learn_from(i, j, i - 1, j);
    }
    for (int i = columns - 1; i >= 0; --i) learn_from(i, j, i + 1, j);
  };
  for (int j = 0; j < rows; ++j) sweep_row(j, j - 1);
  for (int j = rows - 1; j >= 0; --j) sweep_row(j, j + 1);
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    if (known[k] == 0) terrain.height_m[k] = terrain.at(nearest[k].column, nearest[k].row);
  }
}

}  // namespace headland

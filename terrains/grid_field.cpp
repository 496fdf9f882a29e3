#include "terrains/grid_field.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

using Eigen::Vector2d;

// The map with a frame of cells around it, which are the margin. Cell (i, j) of the map is
// (i + 1, j + 1) here.
struct Framed {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> ground;  // 1: of the region that is outlined
  const GridMap* map = nullptr;
  double margin_m = 0.0;

  bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows && ground[at(column, row)] > 0;
  }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

Framed framed(const GridMap& map, double margin_m) {
  Framed frame{map.columns + 2, map.rows + 2, {}, &map, margin_m};
  frame.ground.assign(frame.at(0, frame.rows), margin_m > 0.0 ? 1 : 0);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      frame.ground[frame.at(column + 1, row + 1)] = is_free(map, {column, row}) ? 1 : 0;
    }
  }
  return frame;
}

constexpr std::array<std::pair<int, int>, 4> kAlong = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

// Leaves the ground that can be reached from the map's first free cell.
void keep_reachable(Framed& frame) {
  std::vector<std::pair<int, int>> reached;
  std::vector<std::uint8_t> kept(frame.ground.size(), 0);
  for (int row = 1; row < frame.rows - 1 && reached.empty(); ++row) {
    for (int column = 1; column < frame.columns - 1 && reached.empty(); ++column) {
      if (frame.has(column, row)) reached.emplace_back(column, row);
    }
  }
  if (!reached.empty()) kept[frame.at(reached[0].first, reached[0].second)] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const auto& [right, up] : kAlong) {
      const int column = reached[i].first + right;
      const int row = reached[i].second + up;
      if (!frame.has(column, row) || kept[frame.at(column, row)] > 0) continue;
      kept[frame.at(column, row)] = 1;
      reached.emplace_back(column, row);
    }
  }
  frame.ground = std::move(kept);
}

// Of a corner of cells in W: corner (i, j) is the south-west one of cell (i, j) of the frame.
Vector2d corner_W(const Framed& frame, int i, int j, const Vector2d& moved) {
  const GridMap& map = *frame.map;
  const auto along = [&](int corner, int cells) {
    if (corner == 0) return -frame.margin_m;
    if (corner == cells + 2) return cells * map.cell_m + frame.margin_m;
    return (corner - 1) * map.cell_m;
  };
  const Vector2d on_map = Vector2d(along(i, map.columns), along(j, map.rows)) + moved;
  return map.origin_W + Eigen::Rotation2Dd(map.direction_rad) * on_map;
}

// Edges run with the ground on their left: the one in direction d (kAlong) from a corner has it
// there.
bool has_edge(const Framed& frame, int i, int j, int direction) {
  constexpr std::array<std::pair<int, int>, 4> kLeft = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  constexpr std::array<std::pair<int, int>, 4> kRight = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
  const auto d = static_cast<std::size_t>(direction);
  return frame.has(i + kLeft[d].first, j + kLeft[d].second) &&
         !frame.has(i + kRight[d].first, j + kRight[d].second);
}

// The ring that begins with an edge, whose edges are marked as done.
Ring traced(const Framed& frame, int i, int j, int direction, std::vector<std::uint8_t>& done) {
  Ring ring;
  const auto mark = [&](int d) {
    return std::pair{static_cast<std::size_t>(j) * static_cast<std::size_t>(frame.columns + 1) +
                         static_cast<std::size_t>(i),
                     static_cast<std::uint8_t>(1U << static_cast<unsigned>(d))};
  };
  while (true) {
    const auto [corner, bit] = mark(direction);
    if ((done[corner] & bit) != 0) return ring;
    done[corner] |= bit;
    i += kAlong[static_cast<std::size_t>(direction)].first;
    j += kAlong[static_cast<std::size_t>(direction)].second;
    const int left = (direction + 1) % 4;
    const int right = (direction + 3) % 4;
    if (has_edge(frame, i, j, left)) {
      // Ground goes on beyond the corner, too, where it touches itself.
      Vector2d moved = Vector2d::Zero();
      if (has_edge(frame, i, j, right)) {
        const auto& [x, y] = kAlong[static_cast<std::size_t>(direction)];
        moved = 0.5 * kCornerGap_m * Vector2d(-x - y, x - y);
      }
      ring.push_back(corner_W(frame, i, j, moved));
      direction = left;
    } else if (has_edge(frame, i, j, right)) {
      ring.push_back(corner_W(frame, i, j, Vector2d::Zero()));
      direction = right;
    }
  }
}

std::vector<Ring> outlines(const Framed& frame) {
  std::vector<Ring> rings;
  std::vector<std::uint8_t> done(
      static_cast<std::size_t>(frame.columns + 1) * static_cast<std::size_t>(frame.rows + 1), 0);
  for (int j = 0; j <= frame.rows; ++j) {
    for (int i = 0; i <= frame.columns; ++i) {
      for (int direction = 0; direction < 4; ++direction) {
        if (!has_edge(frame, i, j, direction)) continue;
        Ring ring = traced(frame, i, j, direction, done);
        if (!ring.empty()) rings.push_back(std::move(ring));
      }
    }
  }
  return rings;
}

}  // namespace

Field field_of_grid(const GridMap& map, double margin_m, const std::string& source) {
  if (!(margin_m >= 0.0 && margin_m <= kMaxGridMargin_m)) {
    throw InputError(source, "margin_m", fmt::format("{}", margin_m),
                     fmt::format("a number from 0 to {}", kMaxGridMargin_m));
  }
  Framed frame = framed(map, margin_m);
  keep_reachable(frame);
  Field field;
  for (Ring& ring : outlines(frame)) {
    if (signed_area_m2(ring) > 0.0) {
      field.boundary = std::move(ring);
    } else {
      field.holes.push_back(std::move(ring));
    }
  }
  field.to_work = free_outlines(map);
  return field;
}

std::vector<Ring> free_outlines(const GridMap& map) { return outlines(framed(map, 0.0)); }

}  // namespace headland

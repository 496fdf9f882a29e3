#include "terrains/grid_map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

std::string line_name(std::size_t line) { return fmt::format("line {}", line); }

// Lines without their ends; blank ones at the end are dropped.
std::vector<std::string> lines_of(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  while (!lines.empty() && lines.back().find_first_not_of(" \t") == std::string::npos) {
    lines.pop_back();
  }
  return lines;
}

std::vector<std::string> words_without_comment(const std::string& line) {
  std::istringstream stream(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string one; stream >> one;) words.push_back(one);
  return words;
}

template <typename Number>
bool read_number(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stopped == end;
}

void read_row(const std::string& line, std::size_t number, int row, GridMap& map,
              const std::string& source) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '.' && line[i] != '#') {
      throw InputError(source, fmt::format("line {}, column {}", number, i + 1), line.substr(i, 1),
                       "'.' for a free cell or '#' for a blocked one");
    }
    map.blocked[index_of(map, {static_cast<int>(i), row})] = line[i] == '#' ? 1 : 0;
  }
}

}  // namespace

GridMap parse_grid_map(const std::string& text, double cell_m, const std::string& source) {
  const std::vector<std::string> lines = lines_of(text);
  if (lines.empty()) throw InputError(source, "", "", "is empty");
  const std::size_t most = kMaxGridSide;
  if (lines.size() > most || lines.front().size() > most) {
    throw InputError(source, "map",
                     fmt::format("{} x {} cells", lines.front().size(), lines.size()),
                     fmt::format("1 to {} columns and rows", kMaxGridSide));
  }
  GridMap map =
      free_grid_map(static_cast<int>(lines.front().size()), static_cast<int>(lines.size()));
  map.cell_m = cell_m;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() != lines.front().size()) {
      throw InputError(source, line_name(i + 1), fmt::format("{} cells", lines[i].size()),
                       fmt::format("{} cells, as on line 1", lines.front().size()));
    }
    read_row(lines[i], i + 1, map.rows - 1 - static_cast<int>(i), map, source);
  }
  check_grid_map(map, source);
  return map;
}

GridMap read_grid_map(const std::filesystem::path& file, double cell_m) {
  return parse_grid_map(read_text(file), cell_m, file.string());
}

std::string grid_map_text(const GridMap& map) {
  std::string text;
  for (int row = map.rows - 1; row >= 0; --row) {
    for (int column = 0; column < map.columns; ++column) {
      text += is_free(map, {column, row}) ? '.' : '#';
    }
    text += '\n';
  }
  return text;
}

GridMap read_cell_list(const std::filesystem::path& file, double cell_m) {
  const std::vector<std::string> lines = lines_of(read_text(file));
  std::vector<GridCell> cells;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> words = words_without_comment(lines[i]);
    if (words.empty()) continue;
    GridCell cell;
    const bool read =
        words.size() == 2 && read_number(words[0], cell.column) && read_number(words[1], cell.row);
    if (!read || std::min(cell.column, cell.row) < 0 ||
        std::max(cell.column, cell.row) >= kMaxGridSide) {
      throw InputError(file.string(), line_name(i + 1), lines[i],
                       fmt::format("column and row of a free cell, two whole numbers from 0 to {}",
                                   kMaxGridSide - 1));
    }
    cells.push_back(cell);
  }
  if (cells.empty()) throw InputError(file.string(), "", "", "there is no free cell");
  GridMap map = free_grid_map(std::ranges::max(cells, {}, &GridCell::column).column + 1,
                              std::ranges::max(cells, {}, &GridCell::row).row + 1);
  map.cell_m = cell_m;
  std::ranges::fill(map.blocked, std::uint8_t{1});
  for (const GridCell cell : cells) map.blocked[index_of(map, cell)] = 0;
  check_grid_map(map, file.string());
  return map;
}

void read_cell_heights(const std::filesystem::path& file, GridMap& map) {
  const std::vector<std::string> lines = lines_of(read_text(file));
  std::vector<double> heights_m(map.blocked.size());
  int read_rows = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> words = words_without_comment(lines[i]);
    if (words.empty()) continue;
    if (words.size() != static_cast<std::size_t>(map.columns)) {
      throw InputError(file.string(), line_name(i + 1), fmt::format("{} heights", words.size()),
                       fmt::format("{} heights, one for each column of the map", map.columns));
    }
    const int row = map.rows - 1 - read_rows++;
    for (std::size_t k = 0; row >= 0 && k < words.size(); ++k) {
      double& height_m = heights_m[index_of(map, {static_cast<int>(k), row})];
      if (!read_number(words[k], height_m) || !std::isfinite(height_m)) {
        throw InputError(file.string(), line_name(i + 1), words[k], "a finite height [m]");
      }
    }
  }
  if (read_rows != map.rows) {
    throw InputError(file.string(), "", fmt::format("{} rows", read_rows),
                     fmt::format("{} rows, as many as the map has", map.rows));
  }
  map.height_m = std::move(heights_m);
}

}  // namespace headland

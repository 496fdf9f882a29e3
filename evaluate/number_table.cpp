#include "evaluate/number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

double cell_number(std::string_view cell, const std::string& file, int line,
                   const NumberColumn& column) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool number = error == std::errc() && end == cell.data() + cell.size();
  const bool fits = column.any || (value >= column.min && value <= column.max &&
                                   (!column.whole || value == std::floor(value)));
  if (number && fits) return value;
  throw InputError(file, fmt::format("line {}, {}", line, column.name), std::string(cell),
                   fmt::format("a {}number from {} to {} is needed", column.whole ? "whole " : "",
                               column.min, column.max));
}

// Where the wanted columns are in the header.
std::vector<std::size_t> indices_of(const std::vector<NumberColumn>& columns,
                                    const std::vector<std::string_view>& header,
                                    const std::string& file) {
  std::vector<std::size_t> indices;
  for (const NumberColumn& column : columns) {
    const auto found = std::find(header.begin(), header.end(), column.name);
    if (found == header.end()) {
      throw InputError(file, "line 1, " + column.name, "", "the column is missing");
    }
    if (std::find(found + 1, header.end(), column.name) != header.end()) {
      throw InputError(file, "line 1, " + column.name, "", "the column stands twice");
    }
    indices.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  return indices;
}

}  // namespace

void read_number_table(const std::filesystem::path& file, const std::vector<NumberColumn>& columns,
                       const std::function<void(std::span<const double>)>& row) {
  const std::string text = read_text(file);
  if (text.empty()) throw InputError(file.string(), "line 1", "", "the header line is missing");
  std::string_view rest = text;
  std::vector<std::size_t> indices;
  std::vector<double> values(columns.size());
  std::size_t width = 0;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::vector<std::string_view> cells = split(line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (number == 1) {
      indices = indices_of(columns, cells, file.string());
      width = cells.size();
      continue;
    }
    if (cells.size() != width) {
      throw InputError(file.string(), fmt::format("line {}", number),
                       fmt::format("{} cells", cells.size()),
                       fmt::format("the header has {} columns", width));
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      values[i] = cell_number(cells[indices[i]], file.string(), number, columns[i]);
    }
    row(values);
  }
}

}  // namespace headland

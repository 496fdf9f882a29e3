// CSV tables of numbers as headland writes them: one header line, commas, no quotes, no blank
// lines.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace headland {

// Far beyond what any run has.
inline constexpr double kMostInTable = 1e9;

// A column that is read, and what its numbers may be.
struct NumberColumn {
  std::string name;
  double min = -kMostInTable;
  double max = kMostInTable;
  bool whole = false;
  bool any = false;  // any number at all, NaN and infinity too
};

// Hands `row` the numbers of the columns, in their order, line by line; other columns are passed
// over. Throws InputError(file, "line N, NAME", value, what is allowed): a missing or repeated
// column, a row of another length than the header, no number or one out of its range.
void read_number_table(const std::filesystem::path& file, const std::vector<NumberColumn>& columns,
                       const std::function<void(std::span<const double>)>& row);

}  // namespace headland

// A table of text cells from a CSV file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace headland {

struct CsvRow {
  std::size_t line = 0;  // counted from 1
  std::vector<std::string> cells;
};

struct CsvTable {
  CsvRow header;  // names in lower case
  std::vector<CsvRow> rows;
  char separator = ',';
};

// Comma, semicolon or tab separated, whichever the header has most of; cells trimmed, quotes as in
// RFC 4180 except that a quoted cell ends with its line. CRLF, a byte order mark, blank lines and
// lines that start with # are taken in stride. Throws InputError: missing or unreadable file, empty
// file, a row with another number of cells than the header, an open quote (with the line).
CsvTable read_csv(const std::filesystem::path& file);

// A cell as a finite number. With semicolons or tabs the decimal sign may be a comma. Throws
// InputError(file, "line N, NAME", cell, ...).
double csv_number(const CsvTable& table, const CsvRow& row, std::size_t column,
                  const std::filesystem::path& file);

}  // namespace headland

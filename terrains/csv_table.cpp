#include "terrains/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlank = " \r\n\t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

char separator_of(std::string_view header) {
  char most = ',';
  for (const char sign : {';', '\t'}) {
    if (std::count(header.begin(), header.end(), sign) >
        std::count(header.begin(), header.end(), most)) {
      most = sign;
    }
  }
  return most;
}

std::vector<std::string> cells_of(std::string_view line, char separator, const std::string& file,
                                  std::size_t number) {
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  bool was_quoted = false;
  const auto finish = [&] {
    cells.push_back(was_quoted ? cell : std::string(trimmed(cell)));
    cell.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted) {
      if (line[i] != '"') {
        cell += line[i];
      } else if (i + 1 < line.size() && line[i + 1] == '"') {
        cell += line[++i];
      } else {
        quoted = false;
      }
    } else if (line[i] == '"' && trimmed(cell).empty()) {
      cell.clear();
      quoted = was_quoted = true;
    } else if (line[i] == separator) {
      finish();
    } else if (!was_quoted) {
      cell += line[i];
    }
  }
  if (quoted) throw InputError(file, fmt::format("line {}", number), "", "a quote is never closed");
  finish();
  return cells;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  return text;
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::istringstream stream(read_text(path));
  CsvTable table;
  std::string text;
  for (std::size_t line = 1; std::getline(stream, text); ++line) {
    std::string_view content = text;
    if (line == 1 && content.starts_with(kByteOrderMark)) {
      content.remove_prefix(kByteOrderMark.size());
    }
    if (!content.empty() && content.back() == '\r') content.remove_suffix(1);
    if (trimmed(content).empty() || content.front() == '#') continue;
    if (table.header.cells.empty()) {
      table.separator = separator_of(content);
      table.header = {line, cells_of(content, table.separator, file, line)};
      for (std::string& name : table.header.cells) name = lower(std::move(name));
      continue;
    }
    table.rows.push_back({line, cells_of(content, table.separator, file, line)});
    const std::size_t expected = table.header.cells.size();
    if (table.rows.back().cells.size() != expected) {
      throw InputError(
          file, fmt::format("line {}", line),
          fmt::format("{} cells", table.rows.back().cells.size()),
          fmt::format("{} cells, as in the header on line {}", expected, table.header.line));
    }
  }
  if (table.header.cells.empty()) throw InputError(file, "", "", "is empty");
  return table;
}

double csv_number(const CsvTable& table, const CsvRow& row, std::size_t column,
                  const std::filesystem::path& file) {
  std::string text = row.cells.at(column);
  if (table.separator != ',') std::ranges::replace(text, ',', '.');
  double value = 0.0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stopped != end || !std::isfinite(value)) {
    throw InputError(file.string(),
                     fmt::format("line {}, {}", row.line, table.header.cells[column]),
                     row.cells[column], "a finite number");
  }
  return value;
}

}  // namespace headland

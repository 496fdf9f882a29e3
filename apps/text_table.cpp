#include "apps/text_table.h"

#include <algorithm>

#include "render/typeface.h"

namespace headland {
namespace {

std::size_t width_of(const std::string& text) { return letters(text).size(); }

}  // namespace

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size() && row.size() > 1; ++i) {
      widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t used = std::min(widths[i], width_of(row[i]));
      const std::string blanks(widths[i] - used, ' ');
      line += i == 0 ? " " + row[i] + blanks : "  " + blanks + row[i];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace headland

#include "terrains/input_error.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace headland {
namespace {

// A value that would bury the message is cut.
std::string shortened(const std::string& value) {
  constexpr std::size_t kMost = 100;
  return value.size() <= kMost ? value : value.substr(0, kMost) + "...";
}

std::string one_line(const std::string& source, const std::string& where, const std::string& value,
                     const std::string& allowed) {
  std::string line = source;
  if (!where.empty()) line += (line.empty() ? "" : ": ") + where;
  if (!value.empty()) line += (line.empty() ? "'" : ": '") + shortened(value) + "'";
  if (!allowed.empty()) line += (line.empty() ? "" : ": ") + allowed;
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substitute, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

InputError::InputError(std::string source_in, std::string where_in, std::string value_in,
                       std::string allowed_in)
    : std::runtime_error(one_line(source_in, where_in, value_in, allowed_in)),
      source(std::move(source_in)),
      where(std::move(where_in)),
      value(std::move(value_in)),
      allowed(std::move(allowed_in)) {}

std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
  // The beginning of a name stands for it, however long the rest.
  const auto away = [&](const std::string& name) {
    return std::pair(!name.starts_with(word), edit_distance(word, name));
  };
  const auto nearest = std::ranges::min_element(candidates, {}, away);
  return nearest == candidates.end() ? std::string() : *nearest;
}

std::string unknown_name(std::string_view what, std::string_view word,
                         const std::vector<std::string>& known) {
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  return "unknown " + std::string(what) + "; did you mean '" + nearest_name(word, known) +
         "'? (known: " + all + ")";
}

}  // namespace headland

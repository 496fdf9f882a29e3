// Tables for the terminal.
#pragma once

#include <string>
#include <vector>

namespace headland {

using Row = std::vector<std::string>;

// The first column to the left, the others to the right, by letters, not bytes. A row with one
// entry is a line of its own.
std::string aligned(const std::vector<Row>& rows);

}  // namespace headland

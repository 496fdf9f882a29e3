// Reads grid maps and their heights from text files.
#pragma once

#include <filesystem>
#include <string>

#include "terrains/grid_map.h"

namespace headland {

// A picture of the map, one character a cell: '#' blocked, '.' free; the first line is the
// northernmost row. CRLF, a byte order mark and blank lines at the end are taken in stride. Throws
// InputError: missing or unreadable file, another character (line and column), rows of different
// length, more than kMaxGridSide columns or rows, no free cell, cell_m out of range.
GridMap read_grid_map(const std::filesystem::path& file, double cell_m);
GridMap parse_grid_map(const std::string& text, double cell_m, const std::string& source);

// The same picture; parse_grid_map reads it back.
std::string grid_map_text(const GridMap& map);

// The free cells, `x y` a line, counted from 0 in the south-west; '#' begins a comment. The map
// reaches as far as the cells do. Cells may be named twice. Throws InputError: missing or
// unreadable file, a line that is not two whole numbers from 0 to kMaxGridSide - 1, no cell at all,
// cell_m out of range.
GridMap read_cell_list(const std::filesystem::path& file, double cell_m);

// One height [m] for each cell, blocked ones too: a line of numbers for each row, the northernmost
// first, separated by blanks; '#' begins a comment. Throws InputError: missing or unreadable file,
// not a finite number (line), another number of rows or columns than the map.
void read_cell_heights(const std::filesystem::path& file, GridMap& map);

}  // namespace headland

// Charts by gnuplot, which is called as a program.
#pragma once

#include <string>

namespace headland {

enum class ChartFormat { kSvg, kPng };

// Throws InputError when gnuplot is not installed: to be asked before long work whose chart it is.
void require_gnuplot();

// The chart that a gnuplot script draws, as a file's bytes. Terminal, size and output are set for
// the script, which brings its data as data blocks. Throws InputError when gnuplot is not
// installed or refuses the script.
std::string chart_of(const std::string& script, ChartFormat format, int width_px, int height_px);

// A text inside a script's single quotes.
std::string gnuplot_text(std::string_view text);

}  // namespace headland

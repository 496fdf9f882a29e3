// Text of unknown origin (names, paths) as a terminal may get it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace headland {

// Control characters, line breaks too, and bytes that are not UTF-8 as "\xNN"; all else as it is.
std::string terminal_text(std::string_view text);

// What results lack, a line each on standard error, --quiet or not.
void tell_missing(const std::vector<std::string>& missing);

}  // namespace headland

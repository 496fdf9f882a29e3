// Text of unknown origin (names, paths) as a terminal may get it.
#pragma once

#include <string>
#include <string_view>

namespace headland {

// Control characters, line breaks too, and bytes that are not UTF-8 as "\xNN"; all else as it is.
std::string terminal_text(std::string_view text);

}  // namespace headland

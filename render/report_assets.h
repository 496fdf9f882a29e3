// The report's script and style as they were bundled from web/, part of the program.
#pragma once

#include <string_view>

namespace headland {

std::string_view report_script();
std::string_view report_style();

}  // namespace headland

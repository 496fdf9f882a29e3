// Text in the room that a picture has for it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/typeface.h"

namespace headland {

// The text, ending in an ellipsis where it would be wider.
std::string fitted_text(Typeface& typeface, std::string_view text, TextStyle style,
                        double width_px);

// Broken at spaces into lines no wider than that; a word that is wider has a line of its own.
std::vector<std::string> lines_within(Typeface& typeface, std::string_view text, TextStyle style,
                                      double width_px);

}  // namespace headland

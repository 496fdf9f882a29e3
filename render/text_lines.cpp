#include "render/text_lines.h"

#include <algorithm>

namespace headland {

std::string fitted_text(Typeface& typeface, std::string_view text, TextStyle style,
                        double width_px) {
  std::string out(text);
  if (text_width_px(typeface, out, style) <= width_px) return out;
  constexpr unsigned kContinuation = 0x80U;
  while (!out.empty() && text_width_px(typeface, out + "…", style) > width_px) {
    // A letter of several bytes goes as a whole.
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0U) == kContinuation) {
      out.pop_back();
    }
    if (!out.empty()) out.pop_back();
  }
  return out + "…";
}

std::vector<std::string> lines_within(Typeface& typeface, std::string_view text, TextStyle style,
                                      double width_px) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && text_width_px(typeface, longer, style) > width_px) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace headland

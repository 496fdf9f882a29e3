#include "apps/terminal_text.h"

#include <fmt/format.h>

#include <cstddef>

namespace headland {
namespace {

// Bytes of the UTF-8 letter that begins at `text`; 0 when none does.
std::size_t letter_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned lead = byte(0);
  const std::size_t count = lead < 0x80   ? 1
                            : lead < 0xC2 ? 0
                            : lead < 0xE0 ? 2
                            : lead < 0xF0 ? 3
                            : lead < 0xF5 ? 4
                                          : 0;
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  return count;
}

// C0, DEL and C1, which terminals obey.
bool is_control(std::string_view letter) {
  const auto lead = static_cast<unsigned char>(letter[0]);
  if (letter.size() == 1) return lead < 0x20 || lead == 0x7F;
  return lead == 0xC2 && static_cast<unsigned char>(letter[1]) < 0xA0;
}

}  // namespace

std::string terminal_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t bytes = letter_bytes(text);
    const std::string_view letter = text.substr(0, bytes == 0 ? 1 : bytes);
    if (bytes == 0 || is_control(letter)) {
      for (const char byte : letter) {
        shown += fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
      }
    } else {
      shown += letter;
    }
    text.remove_prefix(letter.size());
  }
  return shown;
}

void tell_missing(const std::vector<std::string>& missing) {
  for (const std::string& what : missing) {
    fmt::print(stderr, "headland: {}\n", terminal_text(what));
  }
}

}  // namespace headland

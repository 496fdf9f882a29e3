// Bytes as text, for pages that hold everything themselves.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace headland {

// RFC 4648 with padding, no line breaks.
std::string base64(std::string_view bytes);

// The numbers as 32-bit floats, little-endian, in base64: what a page's Float32Array takes.
std::string base64_floats(std::span<const float> numbers);

}  // namespace headland

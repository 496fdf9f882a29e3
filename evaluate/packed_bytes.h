// Bytes in few characters, for pages that hold everything themselves. The page's side of it:
// web/src/data.js.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace headland {

// RFC 4648 with padding, no line breaks.
std::string base64(std::string_view bytes);

// A zlib stream (RFC 1950) in base64.
std::string packed_bytes(std::string_view bytes);

// The numbers as 32-bit floats, none lost: how far each bit pattern is from the one before it
// (modulo 2^32, the first from 0), all lowest bytes first, then the next ones, and packed.
// Neighbours are alike, so that most bytes are.
std::string packed_floats(std::span<const float> numbers);

}  // namespace headland

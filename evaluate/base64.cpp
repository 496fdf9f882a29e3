#include "evaluate/base64.h"

#include <cpl_string.h>

#include <bit>
#include <memory>

namespace headland {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie");

std::string base64(std::string_view bytes) {
  if (bytes.empty()) return "";
  const std::unique_ptr<char, decltype(&VSIFree)> text(
      CPLBase64Encode(static_cast<int>(bytes.size()), reinterpret_cast<const GByte*>(bytes.data())),
      &VSIFree);
  return text.get();
}

std::string base64_floats(std::span<const float> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace headland

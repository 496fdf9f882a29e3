#include "evaluate/packed_bytes.h"

#include <cpl_string.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <stdexcept>

namespace headland {

std::string base64(std::string_view bytes) {
  if (bytes.empty()) return "";
  const std::unique_ptr<char, decltype(&VSIFree)> text(
      CPLBase64Encode(static_cast<int>(bytes.size()), reinterpret_cast<const GByte*>(bytes.data())),
      &VSIFree);
  return text.get();
}

std::string packed_bytes(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib: no memory");
  }
  stream.resize(size);
  return base64(stream);
}

std::string packed_floats(std::span<const float> numbers) {
  const std::size_t count = numbers.size();
  std::string planes(4 * count, '\0');
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(numbers[i]);
    const std::uint32_t change = bits - before;
    before = bits;
    for (std::size_t byte = 0; byte < 4; ++byte) {
      planes[byte * count + i] = static_cast<char>((change >> (8U * byte)) & 0xffU);
    }
  }
  return packed_bytes(planes);
}

}  // namespace headland

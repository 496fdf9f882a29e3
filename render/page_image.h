// Pictures as a page takes them up into itself.
#pragma once

#include <string>

#include "render/image.h"

namespace headland {

// A data: URL of the picture: as WebP at a quality at which text stays sharp, which takes a quarter
// of a PNG's bytes; without loss when it is a flat figure, which takes a third of them; as PNG when
// it is too large for WebP. Throws InputError when it cannot be made.
std::string image_url(const Image& image);

}  // namespace headland

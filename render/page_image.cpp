#include "render/page_image.h"

#include <webp/encode.h>

#include <algorithm>

#include "evaluate/packed_bytes.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

struct Encoding {
  Encoding() {
    WebPPictureInit(&picture);
    WebPMemoryWriterInit(&bytes);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &bytes;
  }
  ~Encoding() {
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&bytes);
  }
  Encoding(const Encoding&) = delete;
  Encoding& operator=(const Encoding&) = delete;

  WebPPicture picture{};
  WebPMemoryWriter bytes{};
};

std::string webp_of(const Image& image, bool lossless) {
  constexpr float kQuality = 90.0F;
  constexpr int kEffort = 6;  // of 9
  WebPConfig config{};
  Encoding encoding;
  bool made = WebPConfigPreset(&config, WEBP_PRESET_DRAWING, kQuality) != 0;
  config.use_sharp_yuv = 1;  // thin coloured lines and letters keep their colours
  if (lossless) made = made && WebPConfigLosslessPreset(&config, kEffort) != 0;
  encoding.picture.use_argb = 1;
  encoding.picture.width = image.width;
  encoding.picture.height = image.height;
  made = made &&
         WebPPictureImportRGBA(&encoding.picture, image.rgba.data(), 4 * image.width) != 0 &&
         WebPEncode(&config, &encoding.picture) != 0;
  if (!made) {
    throw InputError("picture", "", "",
                     "cannot be written as WebP: error " +
                         std::to_string(static_cast<int>(encoding.picture.error_code)));
  }
  return {reinterpret_cast<const char*>(encoding.bytes.mem), encoding.bytes.size};
}

}  // namespace

std::string image_url(const Image& image) {
  const std::string png = png_of(image);
  if (std::max(image.width, image.height) > WEBP_MAX_DIMENSION) {
    return "data:image/png;base64," + base64(png);
  }
  // A flat figure is as small as PNG already. Trying all without loss would take a second each.
  constexpr double kFlat = 1.5;
  const std::string webp = webp_of(image, false);
  const bool flat = static_cast<double>(png.size()) < kFlat * static_cast<double>(webp.size());
  return "data:image/webp;base64," + base64(flat ? webp_of(image, true) : webp);
}

}  // namespace headland

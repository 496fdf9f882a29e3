#include "render/typeface.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "terrains/input_error.h"

namespace headland {

struct Typeface::FreeType {
  FT_Library library = nullptr;
  std::array<FT_Face, 2> faces{};  // regular, bold

  FreeType() = default;
  FreeType(const FreeType&) = delete;
  FreeType& operator=(const FreeType&) = delete;
  ~FreeType() { FT_Done_FreeType(library); }
};

Typeface::Typeface(const std::filesystem::path& regular, const std::filesystem::path& bold)
    : freetype_(std::make_unique<FreeType>()) {
  if (FT_Init_FreeType(&freetype_->library) != 0) {
    throw std::runtime_error("FreeType cannot be started");
  }
  const std::array<std::filesystem::path, 2> files = {regular, bold};
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (FT_New_Face(freetype_->library, files[i].c_str(), 0, &freetype_->faces[i]) != 0) {
      throw InputError(files[i].string(), "", "",
                       "font missing or unreadable; install the package fonts-dejavu-core");
    }
  }
  texels_.assign(kTextureWidth, 0);
  texels_[0] = 255;
  shelf_x_ = 2;
  shelf_height_ = 1;
}

Typeface::~Typeface() = default;

const Glyph& Typeface::glyph(char32_t letter, TextStyle style) {
  const auto [entry, is_new] = glyphs_.try_emplace({letter, style.size_px, style.bold});
  Glyph& glyph = entry->second;
  if (!is_new) return glyph;

  FT_Face face = freetype_->faces[style.bold ? 1 : 0];
  FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(style.size_px));
  if (FT_Load_Char(face, letter, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) return glyph;
  const FT_GlyphSlot slot = face->glyph;
  const FT_Bitmap& bitmap = slot->bitmap;
  glyph.width = static_cast<int>(bitmap.width);
  glyph.height = static_cast<int>(bitmap.rows);
  glyph.left = slot->bitmap_left;
  glyph.top = slot->bitmap_top;
  glyph.advance = static_cast<int>((slot->advance.x + 32) / 64);

  if (shelf_x_ + glyph.width + 1 > kTextureWidth) {
    shelf_y_ += shelf_height_ + 1;
    shelf_x_ = 0;
    shelf_height_ = 0;
  }
  shelf_height_ = std::max(shelf_height_, glyph.height);
  const std::size_t needed = static_cast<std::size_t>(kTextureWidth) *
                             static_cast<std::size_t>(shelf_y_ + shelf_height_ + 1);
  if (texels_.size() < needed) texels_.resize(needed, 0);
  glyph.x = shelf_x_;
  glyph.y = shelf_y_;
  shelf_x_ += glyph.width + 1;
  for (int row = 0; row < glyph.height; ++row) {
    const unsigned char* from = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
    std::copy_n(
        from, glyph.width,
        texels_.begin() + static_cast<std::ptrdiff_t>(kTextureWidth) * (glyph.y + row) + glyph.x);
  }
  return glyph;
}

std::u32string letters(std::string_view utf8) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::u32string out;
  std::size_t i = 0;
  while (i < utf8.size()) {
    const auto lead = static_cast<unsigned char>(utf8[i++]);
    const int following = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    if (lead >= 0x80 && (lead < 0xC2 || lead > 0xF4)) {
      out += kReplacement;
      continue;
    }
    char32_t letter = following == 0 ? lead : lead & (0x3FU >> following);
    int seen = 0;
    for (; seen < following && i < utf8.size(); ++seen, ++i) {
      const auto next = static_cast<unsigned char>(utf8[i]);
      if ((next & 0xC0U) != 0x80U) break;
      letter = (letter << 6U) | (next & 0x3FU);
    }
    out += seen == following ? letter : kReplacement;
  }
  return out;
}

int text_width_px(Typeface& typeface, std::string_view utf8, TextStyle style) {
  int width = 0;
  for (const char32_t letter : letters(utf8)) width += typeface.glyph(letter, style).advance;
  return width;
}

}  // namespace headland

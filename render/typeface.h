// Letters: DejaVu Sans rasterised by FreeType into one texture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

namespace headland {

// The fonts the pictures are set in, as Debian's package fonts-dejavu-core installs them.
inline constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
inline constexpr const char* kBoldFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

struct TextStyle {
  int size_px = 14;
  bool bold = false;
};

// A letter's place in the texture and on its line. Whole pixels keep the letters sharp.
struct Glyph {
  int x = 0;  // upper left corner in the texture
  int y = 0;
  int width = 0;
  int height = 0;
  int left = 0;     // from the pen to the left edge
  int top = 0;      // from the base line up to the upper edge
  int advance = 0;  // of the pen
};

// Rasterises letters as they are asked for. Throws InputError naming the package when a font is
// missing.
class Typeface {
 public:
  Typeface(const std::filesystem::path& regular, const std::filesystem::path& bold);
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  const Glyph& glyph(char32_t letter, TextStyle style);

  // One byte of ink a texel, kTextureWidth wide; the texel (0, 0) is full ink.
  static constexpr int kTextureWidth = 1024;
  const std::vector<std::uint8_t>& texels() const { return texels_; }
  int texture_height() const { return static_cast<int>(texels_.size()) / kTextureWidth; }

 private:
  struct FreeType;
  std::unique_ptr<FreeType> freetype_;
  std::map<std::tuple<char32_t, int, bool>, Glyph> glyphs_;
  std::vector<std::uint8_t> texels_;
  int shelf_x_ = 0;
  int shelf_y_ = 0;
  int shelf_height_ = 0;
};

// The letters of UTF-8 text; a malformed byte becomes U+FFFD.
std::u32string letters(std::string_view utf8);

// Advance [px] of a line of text.
int text_width_px(Typeface& typeface, std::string_view utf8, TextStyle style);

}  // namespace headland

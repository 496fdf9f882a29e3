// OpenGL objects that free themselves. All need a current GlContext that outlives them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "render/gl_context.h"
#include "render/image.h"
#include "render/palette.h"

namespace headland {

// A linked vertex and fragment shader. Throws std::runtime_error with the compiler's log: the
// shaders are part of the program.
class GlProgram {
 public:
  GlProgram(const char* vertex_source, const char* fragment_source);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // The program must be in use.
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  void set(const char* uniform, Rgba colour) const;  // as a vec4 of 0..1

 private:
  GLuint id_ = 0;
};

// One attribute of an interleaved vertex: `components` floats, or normalised bytes.
struct GlAttribute {
  GLint components = 0;
  GLenum type = GL_FLOAT;
  std::size_t offset = 0;
};

// Triangles in a vertex buffer, with indices or (none given) in the order of the vertices.
class GlTriangles {
 public:
  GlTriangles(std::span<const std::byte> vertices, std::size_t stride,
              std::span<const GlAttribute> attributes, std::span<const std::uint32_t> indices);
  ~GlTriangles();
  GlTriangles(const GlTriangles&) = delete;
  GlTriangles& operator=(const GlTriangles&) = delete;

  void draw() const;
  // `count` indices from `first` on.
  void draw(std::size_t first, std::size_t count) const;

 private:
  GLuint array_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLsizei count_ = 0;
  bool indexed_ = false;
};

// An 8-bit texture with 1 (R) or 4 (RGBA) channels, rows bottom to top or as the user likes.
// `smooth`: linear with mipmaps, else the nearest texel.
class GlTexture {
 public:
  GlTexture(int width, int height, int channels, std::span<const std::uint8_t> texels, bool smooth);
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  void bind() const;

 private:
  GLuint id_ = 0;
};

// The programs of render/shaders.h. Compiling one takes longer than most drawing with it.
struct GlPrograms {
  GlProgram sheet;
  GlProgram terrain;
  GlProgram solid;
  GlProgram shadow;
  GlProgram furrow;
  GlPrograms();
};

// What is painted on: a tile of a picture. Places are given in pixels of the whole picture.
struct Canvas {
  const GlPrograms& programs;
  Eigen::Vector2i size_px;    // of the picture
  Eigen::Vector2i corner_px;  // the tile's upper left corner
  Eigen::Vector2i tile_px;    // the tile's size
};

// Where pictures are drawn: colour with depth and stencil, 4 samples a pixel, in equal tiles that
// bound the memory it takes. Throws InputError for a size that OpenGL or the memory does not allow.
class GlFrame {
 public:
  GlFrame(int width, int height, Rgba background, int tile_px = kTile_px);
  ~GlFrame();
  GlFrame(const GlFrame&) = delete;
  GlFrame& operator=(const GlFrame&) = delete;

  // The picture that `paint` paints, which is called for every tile and paints the same each time.
  Image draw(const std::function<void(const Canvas&)>& paint) const;

  static constexpr int kTile_px = 2048;  // wide, and half as high

 private:
  void read_into(Image& image, const Canvas& canvas) const;

  int width_ = 0;
  int height_ = 0;
  int tile_width_ = 0;
  int tile_height_ = 0;
  Rgba background_;
  GlPrograms programs_;
  GLuint frames_[2] = {0, 0};      // multisampled, resolved
  GLuint buffers_[3] = {0, 0, 0};  // colour and depth-stencil multisampled, colour resolved
};

inline constexpr int kSamples = 4;
}  // namespace headland

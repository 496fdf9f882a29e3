#include "render/gl_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "render/shaders.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

GLuint compiled(GLenum stage, const char* source) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  std::array<char, 2048> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteShader(shader);
  throw std::runtime_error(std::string("shader does not compile: ") + log.data());
}

// A side cut into as few equal pieces of at most `most_px` as there can be.
int tile_side(int side_px, int most_px) {
  const int pieces = (side_px + most_px - 1) / most_px;
  return pieces > 0 ? (side_px + pieces - 1) / pieces : side_px;
}

}  // namespace

GlProgram::GlProgram(const char* vertex_source, const char* fragment_source) {
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
  id_ = glCreateProgram();
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return;
  std::array<char, 2048> log{};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(id_);
  throw std::runtime_error(std::string("shaders do not link: ") + log.data());
}

GlProgram::~GlProgram() { glDeleteProgram(id_); }

void GlProgram::use() const { glUseProgram(id_); }

void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(id_, uniform), value);
}
void GlProgram::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(id_, uniform), value);
}
void GlProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(glGetUniformLocation(id_, uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(glGetUniformLocation(id_, uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(glGetUniformLocation(id_, uniform), 1, GL_FALSE, value.data());
}
void GlProgram::set(const char* uniform, Rgba colour) const {
  constexpr float kOne = 255.0F;
  glUniform4f(glGetUniformLocation(id_, uniform), static_cast<float>(colour.r) / kOne,
              static_cast<float>(colour.g) / kOne, static_cast<float>(colour.b) / kOne,
              static_cast<float>(colour.a) / kOne);
}

GlTriangles::GlTriangles(std::span<const std::byte> vertices, std::size_t stride,
                         std::span<const GlAttribute> attributes,
                         std::span<const std::uint32_t> indices)
    : count_(static_cast<GLsizei>(indices.empty() ? vertices.size() / stride : indices.size())),
      indexed_(!indices.empty()) {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(),
               GL_STATIC_DRAW);
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const GlAttribute& attribute = attributes[i];
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    // OpenGL takes the offset into the buffer as a pointer.
    glVertexAttribPointer(
        static_cast<GLuint>(i), attribute.components, attribute.type,
        attribute.type == GL_FLOAT ? GL_FALSE : GL_TRUE, static_cast<GLsizei>(stride),
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(attribute.offset)));
  }
  if (!indexed_) return;
  glGenBuffers(1, &indices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
               indices.data(), GL_STATIC_DRAW);
}

GlTriangles::~GlTriangles() {
  if (indexed_) glDeleteBuffers(1, &indices_);
  glDeleteBuffers(1, &vertices_);
  glDeleteVertexArrays(1, &array_);
}

void GlTriangles::draw() const {
  glBindVertexArray(array_);
  if (indexed_) {
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  } else {
    glDrawArrays(GL_TRIANGLES, 0, count_);
  }
}

void GlTriangles::draw(std::size_t first, std::size_t count) const {
  glBindVertexArray(array_);
  // OpenGL takes the offset into the buffer as a pointer.
  glDrawElements(
      GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first * sizeof(std::uint32_t))));
}

GlTexture::GlTexture(int width, int height, int channels, std::span<const std::uint8_t> texels,
                     bool smooth) {
  glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, channels == 1 ? GL_R8 : GL_RGBA8, width, height, 0,
               channels == 1 ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  if (smooth) glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  smooth ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

GlTexture::~GlTexture() { glDeleteTextures(1, &id_); }

void GlTexture::bind() const { glBindTexture(GL_TEXTURE_2D, id_); }

GlPrograms::GlPrograms()
    : sheet(kSheetVertexShader, kSheetFragmentShader),
      terrain(kSolidVertexShader, kTerrainFragmentShader),
      solid(kSolidVertexShader, kSolidFragmentShader),
      shadow(kSolidVertexShader, kShadowFragmentShader),
      furrow(kFurrowVertexShader, kFurrowFragmentShader) {}

GlFrame::GlFrame(int width, int height, Rgba background, int tile_px)
    : width_(width),
      height_(height),
      tile_width_(tile_side(width, tile_px)),
      tile_height_(tile_side(height, std::max(1, tile_px / 2))),
      background_(background) {
  // Tiles are moved windows of one view that spans the picture.
  std::array<GLint, 2> largest{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest.data());
  if (width > largest[0] || height > largest[1]) {
    throw InputError("picture", "size", fmt::format("{}x{}", width, height),
                     fmt::format("at most {} pixels wide and {} high", largest[0], largest[1]));
  }
  glGenFramebuffers(2, frames_);
  glGenRenderbuffers(3, buffers_);
  const std::array<GLenum, 3> formats = {GL_RGBA8, GL_DEPTH24_STENCIL8, GL_RGBA8};
  const std::array<GLsizei, 3> samples = {kSamples, kSamples, 0};
  for (std::size_t i = 0; i < formats.size(); ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples[i], formats[i], tile_width_,
                                     tile_height_);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, frames_[1]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[2]);
  glBindFramebuffer(GL_FRAMEBUFFER, frames_[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                            buffers_[1]);
  if (glGetError() != GL_NO_ERROR ||
      glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    glDeleteFramebuffers(2, frames_);
    glDeleteRenderbuffers(3, buffers_);
    throw InputError("picture", "size", fmt::format("{}x{}", width, height),
                     "too large for the memory; choose a smaller picture");
  }
}

GlFrame::~GlFrame() {
  glDeleteFramebuffers(2, frames_);
  glDeleteRenderbuffers(3, buffers_);
}

Image GlFrame::draw(const std::function<void(const Canvas&)>& paint) const {
  Image image{width_, height_, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  constexpr float kOne = 255.0F;
  glClearColor(static_cast<float>(background_.r) / kOne, static_cast<float>(background_.g) / kOne,
               static_cast<float>(background_.b) / kOne, 1.0F);
  for (int y = 0; y < height_; y += tile_height_) {
    for (int x = 0; x < width_; x += tile_width_) {
      const Canvas canvas{programs_,
                          {width_, height_},
                          {x, y},
                          {std::min(tile_width_, width_ - x), std::min(tile_height_, height_ - y)}};
      glBindFramebuffer(GL_FRAMEBUFFER, frames_[0]);
      glDisable(GL_SCISSOR_TEST);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      paint(canvas);
      read_into(image, canvas);
    }
  }
  return image;
}

void GlFrame::read_into(Image& image, const Canvas& canvas) const {
  const int width = canvas.tile_px.x();
  const int height = canvas.tile_px.y();
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frames_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frames_[1]);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frames_[1]);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  std::vector<std::uint8_t> tile(row * static_cast<std::size_t>(height));
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, tile.data());
  for (std::size_t i = 3; i < tile.size(); i += 4) tile[i] = 255;
  // OpenGL's rows run from the bottom up.
  for (int y = 0; y < height; ++y) {
    const auto from = tile.begin() + static_cast<std::ptrdiff_t>(row) * (height - 1 - y);
    const std::ptrdiff_t at =
        4 * (static_cast<std::ptrdiff_t>(canvas.corner_px.y() + y) * image.width +
             canvas.corner_px.x());
    std::copy(from, from + static_cast<std::ptrdiff_t>(row), image.rgba.begin() + at);
  }
}

}  // namespace headland

// The off-screen OpenGL context.
#pragma once

// Before any GL header: core functions are declared only by glext.h, and only with this macro.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
// gl.h comes first: glext.h extends it.
#include <GL/glext.h>

#include <memory>

namespace headland {

// An OpenGL 3.3 core context in software, current on the calling thread for as long as it lives.
// Pictures are drawn into a GlFrame (render/gl_objects.h). Which library makes it is chosen when
// the program is configured (HEADLAND_GL): OSMesa, or EGL without a surface on Mesa's llvmpipe.
// Nothing else depends on the choice. Throws std::runtime_error when there is no such context.
class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace headland

// The off-screen OpenGL context.
#pragma once

// Before any GL header: core functions are declared only by glext.h, and only with this macro.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// osmesa.h comes first: it includes the gl.h that glext.h extends.
#include <GL/glext.h>

#include <array>

namespace headland {

// An OpenGL 3.3 core context in software, current on the calling thread for as long as it lives.
// Pictures are drawn into a Frame (render/gl_objects.h); the context's own buffer is one pixel.
// Throws std::runtime_error when OSMesa gives no such context.
class OsmesaContext {
 public:
  OsmesaContext();
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace headland

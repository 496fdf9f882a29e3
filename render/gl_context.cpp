#include "render/gl_context.h"

#ifdef HEADLAND_GL_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#else
#include <GL/osmesa.h>
#endif

#include <array>
#include <stdexcept>

namespace headland {

#ifdef HEADLAND_GL_EGL

struct GlContext::Library {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Library() {
    // Pictures are to be the same whatever graphics card there is.
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
        eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
      throw std::runtime_error("EGL gives no display without a surface");
    }
    constexpr std::array<EGLint, 7> kAttributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                   3,
                                                   EGL_CONTEXT_MINOR_VERSION,
                                                   3,
                                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                   EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
    if (context == EGL_NO_CONTEXT) {
      throw std::runtime_error("EGL gives no OpenGL 3.3 core context");
    }
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
      eglDestroyContext(display, context);
      throw std::runtime_error("EGL's context cannot be made current");
    }
  }
  // The display stays: it is the process's, and others may be drawing.
  ~Library() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

#else

struct GlContext::Library {
  OSMesaContext context = nullptr;
  std::array<unsigned char, 4> pixel{};  // the context's own buffer, which nothing is drawn into

  Library() {
    constexpr std::array<int, 11> kAttributes = {OSMESA_FORMAT,
                                                 OSMESA_RGBA,
                                                 OSMESA_DEPTH_BITS,
                                                 0,
                                                 OSMESA_PROFILE,
                                                 OSMESA_CORE_PROFILE,
                                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                                 3,
                                                 OSMESA_CONTEXT_MINOR_VERSION,
                                                 3,
                                                 0};
    context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context == nullptr) throw std::runtime_error("OSMesa gives no OpenGL 3.3 core context");
    if (OSMesaMakeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
      OSMesaDestroyContext(context);
      throw std::runtime_error("OSMesa's context cannot be made current");
    }
  }
  ~Library() {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

#endif

GlContext::GlContext() : library_(std::make_unique<Library>()) {}
GlContext::~GlContext() = default;

}  // namespace headland

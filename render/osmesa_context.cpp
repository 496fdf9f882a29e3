#include "render/osmesa_context.h"

#include <stdexcept>

namespace headland {

OsmesaContext::OsmesaContext() {
  constexpr std::array<int, 13> kAttributes = {OSMESA_FORMAT,
                                               OSMESA_RGBA,
                                               OSMESA_DEPTH_BITS,
                                               0,
                                               OSMESA_PROFILE,
                                               OSMESA_CORE_PROFILE,
                                               OSMESA_CONTEXT_MAJOR_VERSION,
                                               3,
                                               OSMESA_CONTEXT_MINOR_VERSION,
                                               3,
                                               0,
                                               0,
                                               0};
  context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  if (context_ == nullptr) throw std::runtime_error("OSMesa gives no OpenGL 3.3 core context");
  if (OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
    OSMesaDestroyContext(context_);
    throw std::runtime_error("OSMesa's context cannot be made current");
  }
}

OsmesaContext::~OsmesaContext() {
  OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  OSMesaDestroyContext(context_);
}

}  // namespace headland

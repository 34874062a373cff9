// An OpenGL context without a display or a window, for rendering to memory.
//
// The context is created through EGL.  A software rasteriser is preferred to the graphics card, because it needs no
// permission to use a device and draws the same picture on every machine.
#pragma once

#include <EGL/egl.h>

namespace ease {

/// An OpenGL context that is current in the calling thread from construction to destruction.
class OffscreenContext {
 public:
  /// Creates the context.  Throws ComputationError with the reason if that is not possible.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace ease

// An OpenGL context without a display or a window, for rendering to memory.
//
// Through EGL, on a software rasteriser where there is one: it needs no permission on a device, and the same picture
// comes out on every machine.
#pragma once

#include <EGL/egl.h>

namespace ease {

/// Bound to the calling thread from construction to destruction.
class OffscreenContext {
 public:
  /// Throws ComputationError with the reason if no context can be had.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace ease

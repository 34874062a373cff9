// An OpenGL context without a display or a window, for rendering to memory.
//
// The context is created through EGL.  For files a software rasteriser is preferred to the graphics card, because it
// needs no permission to use a device and draws the same picture on every machine.
#pragma once

#include <EGL/egl.h>

#include "viz/renderer.h"

class vtkGenericOpenGLRenderWindow;

namespace ease {

/// An OpenGL context that is current in the calling thread from construction to destruction, or until another one is.
class OffscreenContext {
 public:
  /// Creates the context.  Throws ComputationError with the reason if that is not possible.
  explicit OffscreenContext(Renderer renderer = Renderer::software_first);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Lets a VTK window draw into memory with this context.
  void lend(vtkGenericOpenGLRenderWindow& window) const;
  /// Makes the context current in the calling thread again, of which there must be only one.
  void makeCurrent() const;
  /// Whether it draws in software, as far as EGL tells.
  bool isSoftware() const { return is_software_; }

 private:
  bool is_software_ = true;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace ease

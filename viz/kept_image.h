// Colour and depth of what stands still, to begin the next picture with: in software, a body of 55,000 triangles that
// is drawn anew takes longer than the garment on it and all the rest.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>

class vtkOpenGLRenderWindow;

namespace ease {

class KeptImage {
 public:
  /// Keeps what the window has just drawn.
  void take(vtkOpenGLRenderWindow& window);
  /// Puts it where the window draws next; the renderer must not erase it.
  void put(vtkOpenGLRenderWindow& window);
  /// Before the window ends.
  void release(vtkOpenGLRenderWindow& window);

 private:
  vtkNew<vtkOpenGLFramebufferObject> kept_;
};

}  // namespace ease

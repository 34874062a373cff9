#include "viz/kept_image.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <vtkOpenGLRenderWindow.h>

namespace ease {

namespace {

/// Copies colour and depth from one to the other, which are of one size and format.
void copy(vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to) {
  from.SaveCurrentBindingsAndBuffers();
  from.Bind(GL_READ_FRAMEBUFFER);
  from.ActivateReadBuffer(0);
  to.Bind(GL_DRAW_FRAMEBUFFER);
  to.ActivateDrawBuffer(0);
  int size[2];
  from.GetLastSize(size);
  const int all[4] = {0, size[0], 0, size[1]};
  vtkOpenGLFramebufferObject::Blit(all, all, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  from.RestorePreviousBindingsAndBuffers();
}

}  // namespace

void KeptImage::take(vtkOpenGLRenderWindow& window) {
  vtkOpenGLFramebufferObject* drawn = window.GetRenderFramebuffer();
  int size[2], kept[2];
  drawn->GetLastSize(size);
  kept_->GetLastSize(kept);
  if (kept_->GetFBOIndex() == 0 || kept[0] != size[0] || kept[1] != size[1]) {
    kept_->ReleaseGraphicsResources(&window);
    kept_->SetContext(&window);
    kept_->SaveCurrentBindingsAndBuffers();
    kept_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, 32, drawn->GetMultiSamples(),
                               window.GetStencilCapable() != 0);  // as the window makes its own
    kept_->RestorePreviousBindingsAndBuffers();
  }
  copy(*drawn, *kept_);
}

void KeptImage::put(vtkOpenGLRenderWindow& window) {
  copy(*kept_, *window.GetRenderFramebuffer());
}

void KeptImage::release(vtkOpenGLRenderWindow& window) {
  kept_->ReleaseGraphicsResources(&window);
}

}  // namespace ease

// Keeps VTK and its OpenGL loader from printing on the terminal; only for the source files of this folder.
#pragma once

#include <vtkObject.h>

namespace ease {

/// Switches VTK's warnings off during the lifetime of the object.
class Quiet {
 public:
  Quiet() { vtkObject::GlobalWarningDisplayOff(); }
  ~Quiet() { vtkObject::SetGlobalWarningDisplay(before_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  vtkTypeBool before_ = vtkObject::GetGlobalWarningDisplay();
};

}  // namespace ease

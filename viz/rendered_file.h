// A picture rendered without a display and written as a PNG file.
#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <functional>

#include "viz/overlay.h"

namespace ease {

constexpr int kSamplesPerPixel = 2;  // in each direction, to smooth edges

/// Renders what `compose` adds to a window of this size, in pixels, and what it lays over that.  Throws
/// ComputationError where OpenGL cannot render or the file cannot be written.
void renderToFile(const std::filesystem::path& file, int width, int height,
                  const std::function<void(vtkRenderWindow*, Overlay&)>& compose);

}  // namespace ease

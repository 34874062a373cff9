// The lamps of all pictures: they stand still beside the camera.
#pragma once

class vtkRenderer;

namespace ease {

/// Adds a main lamp above on the left, and a weaker one on the right.
void addLights(vtkRenderer* renderer);

}  // namespace ease

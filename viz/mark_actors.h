// Lines and dots on the surfaces of a live view.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/live_view.h"

namespace ease {

/// Actors of these marks: one for the lines of every width, and one for all dots.
std::vector<vtkSmartPointer<vtkActor>> markActors(const std::vector<MarkLine>& lines, const std::vector<MarkDot>& dots);

}  // namespace ease

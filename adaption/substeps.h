// Into how many parts time steps and interpolation steps are divided where the body moves far in one.
#pragma once

#include <vector>

#include "adaption/timeline.h"
#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Substeps {
  int time = 1;           // parts of a time step, so that contact can follow the body
  int interpolation = 1;  // parts of an interpolation step, so that a level set's band reaches to the next
};

/// How far the body's triangles that are near the garment at the start move in a time step, at most, m.
double bodyMotionPerStep(const Schedule& schedule, const Triangles& body, const std::vector<Positions>& poses,
                         const Positions& garment);

/// Chooses the parts so that the body's surface moves by at most the comfort offset (or 5 mm, where the offset is less)
/// in a part of a time step, and by 3 cm in a part of an interpolation step.  `body_motion`: in a time step, m.  Throws
/// InputError where a time step would have more than 256 parts.
Substeps chooseSubsteps(const Schedule& schedule, double body_motion, double comfort_offset);

}  // namespace ease

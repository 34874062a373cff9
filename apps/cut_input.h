// A scene's garment as it is after cuts through its triangles were found.
#pragma once

#include "apps/scene.h"
#include "garment/pattern/region_cut.h"
#include "solver/model/rest_shape.h"

namespace ease {

/// Puts the cut garment in the place of the one that was read: what belongs to vertices is interpolated, what belongs
/// to triangles is that of the uncut triangle.  A new vertex is pinned where all vertices that it lies between are.
void cutInput(const CutUp& cut, SceneInput& input, RestShape& rest);

}  // namespace ease

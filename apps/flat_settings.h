// How the pieces of a scene's pattern are flattened.
#pragma once

#include "apps/scene.h"
#include "garment/pattern/flat_pattern.h"

namespace ease {

/// Limits, darts, grain, width and names of [pattern], stiffnesses of [material] over the largest of them.
FlatSettings flatSettings(const Scene& scene);

}  // namespace ease

// What of a scene's pattern is refused before a run that may take minutes.
#pragma once

#include "apps/scene.h"
#include "garment/pattern/flat_pattern.h"
#include "solver/base/error.h"

namespace ease {

/// Whether the program finds the seams of the scene's pattern.  Throws InputError where the garment has none and the
/// scene wants none found, or gives a plane of symmetry that misses the garment.
bool findsCuts(const Scene& scene, const SceneInput& input);

/// Throws InputError where the garment as it is before the run cannot be cut along its seams, lacks a seam, loop or
/// piece that a key names, or has a piece that is too wide for the cloth: pieces are let out, hardly ever taken in.
void checkPieces(const Scene& scene, const SceneInput& input);

/// Throws InputError where an allowance is given for a seam or loop that no piece has.
void checkAllowanceNames(const Allowances& allowances, const CutGarment& cut);

/// Calls `make`; says of its InputErrors which scene's pattern they are about.
template <class Make>
void ofPattern(const Scene& scene, const Make& make) try {
  make();
} catch (const InputError& error) {
  throw InputError(scene.file.string() + ": [pattern] " + error.what());
}

}  // namespace ease

// Makes the garment of a scene that is being edited, as `ease garment` would, and keeps what an edit has not changed:
// the body's poses always, the mesh where only paint or pins differ.
#pragma once

#include <memory>
#include <string>

#include "apps/scene.h"
#include "garment/boundary_loop.h"

namespace ease {

/// A garment made, or, of a draft, its boundaries alone.
struct MadeGarment {
  Scene scene;
  std::string mesh_key;             // meshKey() of its text
  SceneInput input;                 // of a draft: the body alone
  std::vector<BoundaryLoop> loops;  // on the body, in the scene's order; none where the garment was not made by tools
  std::vector<NamedLoop> edges;     // boundary loops of the garment, by the names that pins use
  std::vector<std::vector<Vec3>> seams;  // points of each seam, m
  double seconds = 0.0;                  // that it took

  bool hasGarment() const { return input.garment.triangles.rows() > 0; }
};

/// `body`: readBodyInput() of the same [body].  `last`: what was made before, or null.  Throws InputError or
/// ComputationError as authoring does.
MadeGarment makeGarment(const std::string& text, const Scene& scene, const SceneInput& body, const MadeGarment* last,
                        const Pause& pause = nullptr);

}  // namespace ease

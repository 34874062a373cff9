// Reads the file of a garment: cut, welded, in metres, y up.
#pragma once

#include "apps/scene.h"

namespace ease {

/// Reads `scene.garment.mesh` into `input.garment`, and `input.as_read` where its vertices are other ones than the
/// file's. Returns the file's name for messages. Throws InputError naming the file.
std::string readGarmentFile(const Scene& scene, const Warn& warn, SceneInput& input);

/// The part that each vertex of the garment belongs to, largest first, and the number of vertices of each part.
struct GarmentParts {
  std::vector<int> of_vertex, vertices;
};
GarmentParts partsOf(const TriangleMesh& garment);

/// Warns of parts that nothing joins to the rest.
void tellParts(const TriangleMesh& garment, const std::string& name, const Warn& warn);

}  // namespace ease

// What `ease garment` writes of a garment that the scene's tools made.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "apps/scene.h"

namespace ease {

/// Writes into `directory`, which exists: garment.obj; garment.vtp with the tools' work at every vertex and triangle;
/// body.obj, the body that it was made on; garment.json with the loops' vertices, mesh quality and times; garment.png.
/// Returns a few lines for people.  No picture once `interrupted` is true.  Throws ComputationError naming a file that
/// could not be written.
std::string writeGarment(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
                         const std::atomic<bool>& interrupted);

/// Cuts the garment, or its rest shape, along the seams: NAME.obj, NAME.vtp with the number of every triangle's piece,
/// and NAME.json with the vertex of the whole garment that every vertex is, to glue them together again.  Returns a
/// line for people.
std::string writePieces(const TriangleMesh& garment, const std::vector<Seam>& seams,
                        const std::filesystem::path& directory, const std::string& name);

}  // namespace ease

// Files that `ease garment` writes about a garment that the scene's tools made.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "apps/scene.h"

namespace ease {

/// Writes these files into `directory`, which must exist: garment.obj; garment.vtp, with arrays that show what the
/// tools did at every vertex and triangle; body.obj, the body that the garment was made on; garment.json, with the
/// vertices of the loops, mesh quality and times; and garment.png, unless `interrupted` is true by then.  Returns a
/// summary of a few lines.  Throws ComputationError naming a file that could not be written.
std::string writeGarment(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
                         const std::atomic<bool>& interrupted);

/// Cuts the garment, or its rest shape, along the seams.  Writes NAME.obj; NAME.vtp, with the number of the piece that
/// each triangle belongs to; and NAME.json, which gives for each vertex of the pieces the vertex of the whole garment,
/// so that the pieces can be joined again.  `file_vertex`: the numbers of the garment's vertices in its file; empty:
/// the same.  Returns a summary of one line.
std::string writePieces(const TriangleMesh& garment, const std::vector<Seam>& seams,
                        const std::filesystem::path& directory, const std::string& name,
                        const std::vector<int>& file_vertex = {});

}  // namespace ease

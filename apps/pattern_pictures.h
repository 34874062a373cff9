// Pictures of a sewing pattern, and its pieces as a mesh for ParaView.
#pragma once

#include "apps/pattern_files.h"

namespace ease {

/// Writes the pieces in the plane, in m, with thread_warp, thread_weft and shear_deg of every triangle.
void writeFlatMesh(const MadePattern& made, const std::filesystem::path& file);

/// Writes pattern.png, the sheet coloured by how far threads must stretch, and, where the garment was sewn again,
/// pattern_resewn.png, it and the designed one.  Returns the reasons why pictures could not be made.
std::vector<std::string> drawPatternPictures(const Scene& scene, const SceneInput& input, const MadePattern& made,
                                             const std::filesystem::path& directory);

}  // namespace ease

// Pictures of a run: the garment on the body, coloured by the larger principal stretch sigma_1.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/model/cloth.h"

namespace ease {

/// A garment to be drawn in a picture.
struct ShownGarment {
  TriangleMesh mesh;
  std::vector<float> sigma_1;  // larger principal stretch of every triangle
};

/// Returns the cloth at positions `x`, with its stretch relative to the current rest shape.
ShownGarment showGarment(const Cloth& cloth, const Positions& x);

/// A column of a picture.
struct ShownColumn {
  const char* title;
  const ShownGarment* garment;
};

/// Draws the garments side by side, each on `body`, which may be empty.  The colour scale ends at twice `limit` and
/// shows the limit.  Returns an empty string, or the reason why no picture could be made.
std::string drawGarments(const std::filesystem::path& file, const std::vector<ShownColumn>& columns,
                         const TriangleMesh& body, double limit);

}  // namespace ease

// Pictures of a run: the garment on the body, coloured by its stretch.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/model/cloth.h"

namespace ease {

/// A garment as a picture shows it.
struct ShownGarment {
  TriangleMesh mesh;
  std::vector<float> sigma_1;  // of every triangle
};

/// The cloth at `x`, stretched from its present rest shape.
ShownGarment showGarment(const Cloth& cloth, const Positions& x);

/// A column of a picture: its title, and what it shows.
struct ShownColumn {
  const char* title;
  const ShownGarment* garment;
};

/// Draws the garments beside each other on `body`, which may be empty.  The colours end at twice `limit`, and the limit
/// is marked.  Returns an empty text, or why there is no picture.
std::string drawGarments(const std::filesystem::path& file, const std::vector<ShownColumn>& columns,
                         const TriangleMesh& body, double limit);

}  // namespace ease

// Files of the adapted rest shape, and the figures that tell how far it grew.
#pragma once

#include <filesystem>

#include "apps/scene.h"
#include "solver/mesh/numbering.h"
#include "solver/model/cloth.h"

namespace ease {

/// Growth of the rest triangles, relative to the first rest shape.
struct RestGrowth {
  double max = 1.0, p99 = 1.0;  // of sigma_1 of the map from the first to the present rest triangle
  double area_ratio = 1.0;
};

struct RestShapeFigures {
  RestGrowth growth;
  int folded_edges = 0;  // adaption/stitch.h
};

/// Writes rest_shape.obj and rest_shape.vtp into the directory, and rest_pieces where the scene has seams; the cloth's
/// triangles and vertices, in `numbering`, get the order that they have in `given`.
RestShapeFigures writeRestShape(const Cloth& cloth, const SceneInput& given, const Numbering& numbering,
                                const std::filesystem::path& directory);

}  // namespace ease

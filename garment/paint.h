// Tool 3: paints where the garment has more or less cloth, as a scale factor of each triangle's rest shape.
#pragma once

#include <vector>

#include "garment/brush.h"

namespace ease {

/// Scale factor of each triangle's rest edges: the product of the brushes' values, each faded to 1 at its rim.  Throws
/// InputError naming the number of a brush that touches no triangle.
std::vector<double> paintedScales(const TriangleMesh& garment, const std::vector<Brush>& brushes);

/// Factors after / before of two paintings; an empty one means that nothing is painted.  Empty if both are equal.
std::vector<double> paintBetween(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace ease

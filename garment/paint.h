// Tool 4: paints how much cloth the garment has in each place, as a scale factor of each triangle's rest shape.
#pragma once

#include <vector>

#include "garment/brush.h"

namespace ease {

/// Computes the scale factor of each triangle's rest edges: the product of the brushes' values, where each fades to 1
/// at the brush's rim.  Throws InputError naming the number of a brush that touches no triangle.
std::vector<double> paintedScales(const TriangleMesh& garment, const std::vector<Brush>& brushes);

/// Computes the factor after / before of each triangle between two paintings.  An empty painting is 1 everywhere.  The
/// result is empty if both are equal.
std::vector<double> paintBetween(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace ease

// Tool 3: more cloth here, less there, as a scale factor of every triangle's rest shape.
#pragma once

#include <vector>

#include "garment/brush.h"

namespace ease {

/// How many times as long each triangle's rest edges are to be: the brushes' values, faded to 1, multiplied.  Throws
/// InputError, naming its place in the list, where a brush touches no triangle.
std::vector<double> paintedScales(const TriangleMesh& garment, const std::vector<Brush>& brushes);

/// The factors that lead from one painting to another; either may be empty, nothing painted, and so are equal ones'.
std::vector<double> paintBetween(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace ease

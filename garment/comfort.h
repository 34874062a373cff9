// Tool 4: comfort, the smallest distance that the garment keeps from the body, everywhere or by region.
#pragma once

#include <vector>

#include "collision/triangle_tree.h"
#include "garment/brush.h"
#include "garment/looped_mesh.h"

namespace ease {

/// Comfort offset at every vertex, m: `offset`, blended towards a brush's value where the brush acts; later brushes act
/// on the result of earlier ones.  Throws InputError naming the number of a brush that touches no vertex.
std::vector<double> comfortOffsets(const Positions& positions, double offset, const std::vector<Brush>& regions);

/// Moves the garment out until every vertex, edge midpoint and centroid is its offset, the mean of its vertices', away
/// from the body's union.
///
///   x = x_0 + d    d smoothed over neighbours, along the loops over neighbours in the loop, then out along the level
///                  set's normal wherever a sample lacks distance; again and again, at last by exact distances
///
/// Smoothing d and not x leaves the garment its shape and the triangles theirs.  Where parts of the body face each
/// other with less room than two offsets (thighs), the garment keeps to the middle; returns how many vertices do so.
/// Where triangles are too large for a fold, samples settle for less, but not for a place inside the body: throws
/// ComputationError if there is none.
int moveClear(const TriangleTree& body, const std::vector<double>& offsets, LoopedMesh& garment);

}  // namespace ease

// Tool 5: comfort, the smallest distance that the garment keeps from the body, everywhere or by region.
#pragma once

#include <vector>

#include "collision/triangle_tree.h"
#include "garment/brush.h"
#include "garment/looped_mesh.h"

namespace ease {

/// Comfort offset at every vertex, m: `offset`, blended towards a brush's value where the brush acts; later brushes act
/// on the result of earlier ones.  Throws InputError naming the number of a brush that touches no vertex.
std::vector<double> comfortOffsets(const Positions& positions, double offset, const std::vector<Brush>& regions);

/// Moves the garment out until every vertex, edge midpoint and centroid keeps its offset from the body's union.  The
/// offset of a midpoint or centroid is the mean of its vertices' offsets.
///
///   x = x_0 + d    x: position of a vertex, x_0: its position at the start, d: its displacement, m
///
/// Each round first smooths d over the neighbours of a vertex (on a loop, over its neighbours there), then moves
/// vertices along the level set's normal wherever a sample lacks distance.  The last rounds do not smooth and measure
/// distances exactly.  Smoothing d instead of x keeps the shape of the garment and of its triangles.  Where two parts
/// of the body leave less room than two offsets (thighs), the garment keeps near the middle; returns how many vertices
/// do so.  Where triangles are too large for a fold, samples accept a smaller distance, but none inside the body:
/// throws ComputationError if they find no such place.
int moveClear(const TriangleTree& body, const std::vector<double>& offsets, LoopedMesh& garment);

}  // namespace ease

// The garment cut exactly along the lines between its regions.
//
//   slide    a vertex nearer to a line than a quarter of the edge towards it moves along that edge onto the line,
//            unless a triangle around it would become too thin; so the cut leaves no slivers
//   split    triangles that a line still crosses are split along it; new vertices lie on edges and, where three
//            regions meet, inside a triangle
//   chains   edges between different regions, from junction to junction, become seams
//
// Seams that the garment has already stay: regions are found on its pieces (cutIntoPieces), and a line that reaches
// such a seam ends at a vertex of it, because its other side is another piece.
#pragma once

#include "garment/pattern/region_map.h"

namespace ease {

/// Cuts along the lines of the map, which belongs to the surface of `pieces`: the garment cut along its seams.
CutUp cutAlongRegions(const RestGarment& garment, const Pieces& pieces, const RestSurface& surface,
                      const RegionMap& map);

}  // namespace ease

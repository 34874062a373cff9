// Darts and openings, which are found along the mesh's edges, made as smooth as they are sewn.
//
//      o---o                    A chain of edges zigzags around the line that is meant, and the two sides of a zigzag
//     /     \   o               lie differently on the paper.  So the chain's vertices slide within the garment's
//    o       o-/                surface onto the shortest way between its ends, or else onto the chain itself made
//    -o--o--o--o-  slid         smooth, and their surroundings with them (seam_straightening.h); vertices of seams and
//                               of the garment's edge stay.  The mesh keeps its triangles, which cover other cloth:
//
//   D'_t = mean over points of t of (D_s E_s^+) E'_t     rest edges; D_s, E_s: edges at rest and in space of triangle
//                                                        s, in which the point lay before
#pragma once

#include "garment/pattern/cut_garment.h"
#include "garment/pattern/rest_garment.h"

namespace ease {

/// The garment whose vertices slid.  A line stays along edges as they were where triangles would become too thin.
/// Chains lose vertices where they make a detour around one triangle.
CutUp slideLines(const RestGarment& garment, std::vector<CutLine>& lines);

}  // namespace ease

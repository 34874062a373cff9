// The regions of a garment as levels: one function a label, negative inside the label's regions.
//
//   phi_k(v)   signed distance of vertex v to the border of the regions with label k, m
//   label      the k with the least phi_k(v)
//   crossing   on edge (a, b) with labels i, j: s = g_a / (g_a + g_b),  g_a = phi_j(a) - phi_i(a), g_b the other way
//
// The levels may vary freely; regions merge where two of one label touch, split, and vanish.  redistanced() makes the
// levels distances again without moving the lines noticeably, by fast marching over the triangles (Kimmel and Sethian
// 1998; across a triangle the front is taken as straight).
#pragma once

#include "garment/pattern/region_map.h"

namespace ease {

struct RegionLevels {
  int labels = 0;
  std::vector<double> phi;  // by label, then by vertex, m

  double* of(int label) { return phi.data() + static_cast<size_t>(label) * (phi.size() / labels); }
  const double* of(int label) const { return phi.data() + static_cast<size_t>(label) * (phi.size() / labels); }
};

/// Levels whose lines run through the middles of the edges between vertices of different labels.
RegionLevels levelsFrom(const RestSurface& surface, const std::vector<int>& label, int labels);

/// The regions that the levels describe: the label of every vertex, and where lines cross edges.
RegionMap mapOf(const RestSurface& surface, const RegionLevels& levels);

/// The levels as distances to the lines of the map, up to a band of some edges, beyond which they stay the same.
RegionLevels redistanced(const RestSurface& surface, const RegionMap& map, int labels);

/// Distances of vertices over the surface, m, from those that `distance` already has; infinity: none yet.  Vertices
/// further than `until` keep what they have.
void marchDistances(const RestSurface& surface, double until, std::vector<double>& distance);

}  // namespace ease

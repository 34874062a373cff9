// The rest shape as a metric: one rest length for every edge, and the flat triangles that have these lengths.
//
//   D'_t    flat edges that triangle t asks for, 2x2, m
//   l_e     rest length of edge e: the longer of its lengths in the triangles D'_t beside it, m
//   D_t     the flat triangle with the lengths l_e, turned so that it lies nearest to D'_t, m
//
// Neighbours agree on the length of their common edge, so the flat triangles can be sewn together, although no surface
// in space has been computed.  A surface with nearly these lengths is computed once, at the end (stitch.h): computing
// one after every growth would squeeze some triangles by a few per cent, and they would be over the limit again.
#pragma once

#include <vector>

#include "solver/model/cloth.h"

namespace ease {

/// Gives the cloth the smallest metric in which no edge is shorter than its triangles grown by `growth` ask for
/// (growth.h); the positions of the rest shape in space stay.  A triangle keeps its edges to the last bit where neither
/// it nor a neighbour grows.
void growMetric(const std::vector<Mat2>& growth, Cloth& cloth);

/// The flat triangle with edges of these lengths, m: from corner 0 to 1, from 0 to 2, and from 1 to 2.  It is turned
/// so that it lies nearest to `wanted`, which is returned where no triangle has these lengths, or only a sliver.
Mat2 flatTriangle(double length_01, double length_02, double length_12, const Mat2& wanted);

/// By how much edges in space differ from the lengths of the metric, relative.
struct MetricError {
  double mean = 0.0, p99 = 0.0;
};

/// Compares the lengths of the edges at `x`, m, with those of the cloth's flat rest triangles.
MetricError metricError(const Cloth& cloth, const Positions& x);

}  // namespace ease

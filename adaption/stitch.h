// Stitching: one mesh again from rest triangles that grew each on its own, as rigidly as possible.
//
//   minimise over x, R_t   sum_t a_t |E_t(x) D_t^-1 - R_t D'_t D_t^-1|^2 + nearness
//
//   D_t   2x2 rest edges before, D'_t those asked for, m      R_t  3x2 with orthonormal columns
//   E_t   3x2 edges of the stitched mesh, m
//
// What triangles ask for is remembered: D'_t only ever grows, and one that the others squeezed asks for its own size
// again the next time.  Otherwise squeezed triangles would count as stretched, grow, and squeeze others.
//
// The minimum is found by alternating between R_t (closed-form polar) and x (the gradient system, factored once) after
// Sorkine and Alexa 2007. The new flat edges are R_tᵀ E_t: they carry the grain.
#pragma once

#include <vector>

#include "solver/linear/gradient_system.h"
#include "solver/model/cloth.h"

namespace ease {

class Stitcher {
 public:
  /// Factors for the cloth's first rest shape; its cotangents serve for all later ones.
  /// `ordering`: of the mesh's systems.
  Stitcher(const Cloth& cloth, std::span<const int> ordering);

  /// Gives the cloth the rest shape nearest to its triangles grown by `growth` (2x2 each; identity: as it was).
  void stitch(Cloth& cloth, const std::vector<Mat2>& growth);

  /// Gives the cloth the rest shape nearest to what its triangles ask for scaled by these factors, above or below 1.
  void rescale(Cloth& cloth, const std::vector<double>& scales);

  /// D' of every triangle so far, m: all that is remembered; and to go on from there.
  const std::vector<Mat2>& wanted() const { return wanted_; }
  void restore(const std::vector<Mat2>& wanted) { wanted_ = wanted; }

 private:
  void fitWanted(Cloth& cloth, int iterations);

  GradientSystem system_;
  std::vector<Mat2> reference_inverse_;  // D^-1 of the first rest shape, by which gradients are taken
  std::vector<Mat2> wanted_, rest_edges_;
  std::vector<Mat32> targets_;
  Positions anchors_, x_;
};

/// Edges across which the rest shape is folded over, by more than 120 degrees, that were bent by less than 90 in
/// `first`: where neighbours ask for sizes that do not fit together.
int foldedEdges(const Cloth& cloth, const Positions& first);

/// 3x2 matrix with orthonormal columns that is nearest to A (polar factor), in closed form.
Mat32 nearestRotation(const Mat32& A);

}  // namespace ease

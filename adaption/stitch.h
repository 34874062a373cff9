// Stitching: joins rest triangles, each of which grew on its own, into one mesh again, as rigidly as possible.
//
//   minimise over x, R_t   sum_t a_t |E_t(x) D_t^-1 - R_t D'_t D_t^-1|^2 + a weak pull towards the present rest shape
//
//   D_t   2x2 edges of the first rest shape, D'_t wanted edges, m      R_t  3x2 with orthonormal columns
//   E_t   3x2 edges of the stitched mesh, m
//
// The wanted edges D'_t are kept from one adaption to the next and only grow, so that a triangle squeezed by others
// still has its own size as target.  Otherwise squeezed triangles would count as stretched, grow, and squeeze others.
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
  /// Factors the system of the cloth's first rest shape, which serves all later ones.  `ordering`: systemOrdering() of
  /// the mesh.
  Stitcher(const Cloth& cloth, std::span<const int> ordering);

  /// Gives the cloth the rest shape nearest to its triangles grown by `growth` (2x2 each; identity: no growth).
  void stitch(Cloth& cloth, const std::vector<Mat2>& growth);

  /// Iterations of rescale(): more than of stitch(), since it is done once and starts further from the minimum.
  static constexpr int kRescaleIterations = 100;
  /// Scales the wanted edges of each triangle by its factor, above or below 1, and gives the cloth the nearest rest
  /// shape.
  void rescale(Cloth& cloth, const std::vector<double>& scales, int iterations = kRescaleIterations);

  /// Computes positions of the vertices at which the edges have the lengths of the cloth's flat rest triangles as
  /// nearly as a surface in space can, starting from its present positions; m.
  Positions embed(const Cloth& cloth);

  /// D' of each triangle, m: the whole state of the stitcher, which restore() sets.
  const std::vector<Mat2>& wanted() const { return wanted_; }
  void restore(const std::vector<Mat2>& wanted) { wanted_ = wanted; }

 private:
  void iterate(const Cloth& cloth);
  void fitWanted(Cloth& cloth, int iterations);

  GradientSystem system_;
  std::vector<Mat2> reference_inverse_;  // D^-1 of the first rest shape
  std::vector<Mat2> wanted_, rest_edges_;
  std::vector<Mat32> targets_;
  Positions anchors_, x_;
};

/// Counts the edges across which the rest shape is folded by more than 120 degrees although `first` was bent there by
/// less than 90: the wanted sizes of the adjacent triangles do not fit together.
int foldedEdges(const Cloth& cloth, const Positions& first);

/// Computes the 3x2 matrix with orthonormal columns nearest to A (its polar factor), in closed form.
Mat32 nearestRotation(const Mat32& A);

}  // namespace ease

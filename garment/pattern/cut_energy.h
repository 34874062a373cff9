// What a division of the garment into regions costs: length of its lines, and how far its pieces are from flat.
//
//   -Laplace u = -G in every region, u = 0 on its border      u: logarithm of the scale of the conformal flattening
//   E = 2 w_l |lines| / L + c integral of u^2                 L, m: side of a square as large as the garment
//   c = 1000 w_d / L^2
//   -Laplace p = -2 c u, p = 0 on the border                  p: adjoint
//
// After Sharp and Crane 2018, "Variational surface cutting", whose weights these are; |u| is the strain of the map.
// Linear elements on the cells into which the lines divide the triangles (region_cells.h).  Only vertices of the mesh
// inside the garment are unknown, because u = 0 on the lines: the matrix has the same pattern for every division, is
// ordered once, and one factor serves u and p.
//
// The derivative by the levels is that of this discrete energy itself, so that it agrees with finite differences:
// moving point X_j of an element of area A changes its share  A d,  d = c mean(u^2) + grad p . grad u + G mean(p),  by
//
//   d(A d) / dX_j = A [ d grad psi_j - (grad p . grad psi_j) grad u - (grad u . grad psi_j) grad p ]
//
// (Hiptmair, Paganini and Sargheini 2015 compare such volume forms with the usual ones on the boundary.)
#pragma once

#include "garment/pattern/region_cells.h"
#include "garment/pattern/vertex_matrix.h"

namespace ease {

struct CutWeights {
  double distortion = 10.0;  // w_d
  double length = 5.0;       // w_l
};

class CutEnergy {
 public:
  /// The surface must outlive this object.
  CutEnergy(const RestSurface& surface, const CutWeights& weights);

  /// The energy of a division; infinite where a region has no border at all, as all of a closed surface.
  double operator()(const RegionLevels& levels);
  /// Derivative by the levels last evaluated, ordered as phi.
  std::vector<double> derivative();

  double length() const { return length_; }  // of the lines, m

 private:
  /// Tells triangles that lines cross from those that lie in one region whole.
  void findCrossed();
  /// Solves in place with u = 0 on the border.
  void solve(std::vector<double>& x) const;
  void solveAdjoint();

  const RestSurface& surface_;
  const CutWeights weights_;
  double scale_;  // 1000 w_d / L^2
  VertexMatrix matrix_;
  std::vector<Mat3> stiffness_;  // of whole triangles
  RegionLevels levels_;
  std::vector<int> crossed_, whole_;  // triangles
  std::vector<double> u_, p_;
  double length_ = 0.0;
};

}  // namespace ease

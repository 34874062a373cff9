// Symmetric sparse matrix of 3x3 blocks that couples every vertex of a mesh with itself and its neighbours.
//
// Both triangles are stored, row by row, so that rows can be assembled and multiplied in parallel without write
// conflicts; the pattern is fixed.
#pragma once

#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/mesh/topology.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

class BlockMatrix {
 public:
  /// The same pattern for all; zero.
  BlockMatrix(int vertices, const std::vector<Edge>& edges);

  int rows() const { return static_cast<int>(start_.size()) - 1; }
  /// Blocks of a row: columns ascending, the row's own among them.
  int rowBegin(int row) const { return start_[row]; }
  int rowEnd(int row) const { return start_[row + 1]; }
  int column(int block) const { return column_[block]; }
  /// Edge between a block's row and column; -1 on the diagonal.
  int edge(int block) const { return edge_[block]; }
  Mat3& block(int block) { return blocks_[block]; }
  const Mat3& block(int block) const { return blocks_[block]; }

  /// y = A x; y must not be x.
  void multiply(const Positions& x, Positions& y) const;

  /// Lower triangle as a scalar matrix of 3 x 3 blocks (3n x 3n).  Rows and columns of `fixed` vertices become those of
  /// the identity. `lower` keeps its pattern from the first call on.
  void toScalar(std::span<const char> fixed, SparseMatrix& lower) const;

 private:
  std::vector<int> start_, column_, edge_;
  std::vector<Mat3> blocks_;
};

}  // namespace ease

// Symmetric sparse matrix of 3x3 blocks that couples every vertex of a mesh with itself and its neighbours.
//
// The blocks above the diagonal are stored as well as those below it, row by row, so that threads can assemble and
// multiply rows in parallel without write conflicts. The pattern is fixed.
#pragma once

#include <span>
#include <vector>

#include "solver/linear/cholesky.h"
#include "solver/mesh/topology.h"
#include "solver/mesh/triangle_gradient.h"

namespace ease {

class BlockMatrix {
 public:
  /// Couples the vertices that an edge joins; all entries are zero.
  BlockMatrix(int vertices, const std::vector<Edge>& edges);

  int rows() const { return static_cast<int>(start_.size()) - 1; }
  /// Range of a row's blocks, ordered by column. The diagonal block is one of them.
  int rowBegin(int row) const { return start_[row]; }
  int rowEnd(int row) const { return start_[row + 1]; }
  int column(int block) const { return column_[block]; }
  /// Edge between a block's row and column; -1 on the diagonal.
  int edge(int block) const { return edge_[block]; }
  Mat3& block(int block) { return blocks_[block]; }
  const Mat3& block(int block) const { return blocks_[block]; }

  /// Computes y = A x; y and x must be different arrays.
  void multiply(const Positions& x, Positions& y) const;

  /// Copies the lower triangle to a scalar matrix, 3n x 3n.  Rows and columns of `fixed` vertices become those of
  /// the identity. `lower` keeps its pattern from the first call on.
  void toScalar(std::span<const char> fixed, SparseMatrix& lower) const;

 private:
  std::vector<int> start_, column_, edge_;
  std::vector<Mat3> blocks_;
};

}  // namespace ease

#include "garment/pattern/vertex_matrix.h"

#include <algorithm>

#include "solver/linear/gradient_system.h"

namespace ease {

VertexMatrix::VertexMatrix(int vertices, const Triangles& triangles)
    : matrix_(vertexPattern(vertices, triangles)),
      cholesky_(Cholesky::Kind::kSimplicial),
      slots_(triangles.rows()),
      diagonal_(vertices) {
  cholesky_.analyse(matrix_);
  const auto slot = [&](int row, int column) {
    const int *rows = matrix_.innerIndexPtr(), *columns = matrix_.outerIndexPtr();
    return static_cast<int>(std::lower_bound(rows + columns[column], rows + columns[column + 1], row) - rows);
  };
  for (int v = 0; v < vertices; ++v) diagonal_[v] = slot(v, v);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 9; ++k) {
      const int row = triangles(t, k / 3), column = triangles(t, k % 3);
      slots_[t][k] = row < column ? -1 : slot(row, column);
    }
}

void VertexMatrix::add(int t, const Mat3& block) {
  double* values = matrix_.valuePtr();
  for (int k = 0; k < 9; ++k)
    if (slots_[t][k] >= 0) values[slots_[t][k]] += block(k / 3, k % 3);
}

void VertexMatrix::fix(std::span<const char> fixed) {
  for (int column = 0; column < matrix_.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix_, column); entry; ++entry)
      if (fixed[column] || fixed[entry.row()]) entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
}

void VertexMatrix::solve(std::span<double> x) const {
  cholesky_.solve(x.data(), x.data(), static_cast<int>(static_cast<long>(x.size()) / matrix_.cols()));
}

}  // namespace ease

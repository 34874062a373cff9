#include "solver/linear/block_matrix.h"

#include <algorithm>

#include "solver/base/parallel.h"

namespace ease {

BlockMatrix::BlockMatrix(int vertices, const std::vector<Edge>& edges) : start_(vertices + 1, 0) {
  std::vector<std::vector<std::pair<int, int>>> neighbours(vertices);  // (column, edge)
  for (int i = 0; i < vertices; ++i) neighbours[i].emplace_back(i, -1);
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const auto [i, j] = edges[e].vertex;
    neighbours[i].emplace_back(j, e);
    neighbours[j].emplace_back(i, e);
  }
  for (int i = 0; i < vertices; ++i) {
    std::sort(neighbours[i].begin(), neighbours[i].end());
    for (const auto& [column, edge] : neighbours[i]) {
      column_.push_back(column);
      edge_.push_back(edge);
    }
    start_[i + 1] = static_cast<int>(column_.size());
  }
  blocks_.assign(column_.size(), Mat3::Zero());
}

void BlockMatrix::multiply(const Positions& x, Positions& y) const {
  parallelFor(rows(), 512, [&](int i) {
    Vec3 sum = Vec3::Zero();
    for (int k = start_[i]; k < start_[i + 1]; ++k) sum.noalias() += blocks_[k] * x.row(column_[k]).transpose();
    y.row(i) = sum;
  });
}

namespace {

/// Pattern of the scalar matrix: all entries on and below the diagonal.
SparseMatrix scalarPattern(std::span<const int> start, std::span<const int> column) {
  const int n = static_cast<int>(start.size()) - 1;
  SparseMatrix lower(3 * n, 3 * n);
  std::vector<int> size(3 * n);
  for (int j = 0; j < n; ++j)
    for (int b = 0; b < 3; ++b) {
      size[3 * j + b] = 3 - b;
      for (int k = start[j]; k < start[j + 1]; ++k) size[3 * j + b] += column[k] > j ? 3 : 0;
    }
  lower.reserve(size);
  for (int j = 0; j < n; ++j)
    for (int b = 0; b < 3; ++b)
      for (int k = start[j]; k < start[j + 1]; ++k)
        if (const int i = column[k]; i >= j)
          for (int a = i == j ? b : 0; a < 3; ++a) lower.insert(3 * i + a, 3 * j + b) = 0.0;
  lower.makeCompressed();
  return lower;
}

}  // namespace

void BlockMatrix::toScalar(std::span<const char> fixed, SparseMatrix& lower) const {
  if (lower.cols() != 3 * rows()) lower = scalarPattern(start_, column_);
  const int* column_start = lower.outerIndexPtr();
  double* values = lower.valuePtr();
  parallelFor(rows(), 512, [&](int j) {
    for (int b = 0; b < 3; ++b) {
      double* value = values + column_start[3 * j + b];
      for (int k = start_[j]; k < start_[j + 1]; ++k) {
        const int i = column_[k];
        if (i < j) continue;
        // Column (j, b) holds A(i a, j b), which by symmetry is the block (j, i) at (b, a).
        for (int a = i == j ? b : 0; a < 3; ++a)
          *value++ = fixed[i] || fixed[j] ? (i == j && a == b ? 1.0 : 0.0) : blocks_[k](b, a);
      }
    }
  });
}

}  // namespace ease

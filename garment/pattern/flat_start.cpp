#include "garment/pattern/flat_start.h"

#include <cmath>

#include "garment/pattern/flip_free.h"
#include "solver/base/error.h"
#include "solver/linear/cholesky.h"

namespace ease {
namespace {

std::vector<double> restAreas(const FlatPieces& pieces, const std::vector<int>& piece) {
  std::vector<double> areas(pieces.outlines.size(), 0.0);
  for (size_t t = 0; t < pieces.rest_edges.size(); ++t)
    areas[piece[pieces.triangles(static_cast<int>(t), 0)]] += 0.5 * pieces.rest_edges[t].determinant();
  return areas;
}

/// Length of every step along an outline, m.
std::vector<double> outlineSteps(const FlatPieces& pieces, const std::vector<int>& outline) {
  std::vector<int> place(pieces.vertices, -1);
  for (size_t i = 0; i < outline.size(); ++i) place[outline[i]] = static_cast<int>(i);
  std::vector<double> steps(outline.size(), 0.0);
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = pieces.triangles(t, k), b = pieces.triangles(t, (k + 1) % 3);
      if (place[a] < 0 || outline[(place[a] + 1) % outline.size()] != b) continue;
      const Mat2& d = pieces.rest_edges[t];
      steps[place[a]] = (k == 0 ? d.col(0) : k == 1 ? Eigen::Vector2d(d.col(1) - d.col(0)) : d.col(1)).norm();
    }
  return steps;
}

/// Solves A x = b where some coordinates are fixed at what `x` has there; A is symmetric, given by its lower triangle.
void solveAround(const std::vector<Eigen::Triplet<double>>& lower, const std::vector<char>& fixed,
                 std::vector<double>& x) {
  const int n = static_cast<int>(x.size());
  std::vector<Eigen::Triplet<double>> kept;
  std::vector<double> right(n, 0.0);
  for (const auto& entry : lower) {
    const int i = entry.row(), j = entry.col();
    if (!fixed[i] && !fixed[j]) kept.push_back(entry);
    if (fixed[i] && !fixed[j]) right[j] -= entry.value() * x[i];
    if (fixed[j] && !fixed[i]) right[i] -= entry.value() * x[j];
  }
  for (int i = 0; i < n; ++i)
    if (fixed[i]) {
      kept.emplace_back(i, i, 1.0);
      right[i] = x[i];
    }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(kept.begin(), kept.end());
  Cholesky cholesky(Cholesky::Kind::kSimplicial);
  cholesky.analyse(matrix);
  if (!cholesky.factor(matrix))
    throw ComputationError("a pattern piece cannot be flattened: its triangles are degenerate");
  cholesky.solve(right.data(), x.data(), 1);
}

/// Scales every piece about the origin so that it has the area of its triangles at rest.
void scaleToRest(const FlatPieces& pieces, const std::vector<int>& piece, Positions& x) {
  const std::vector<double> wanted = restAreas(pieces, piece);
  std::vector<double> areas(wanted.size(), 0.0);
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    areas[piece[pieces.triangles(t, 0)]] +=
        0.5 * std::abs(edgeMatrix(x, pieces.triangles, t).topRows<2>().determinant());
  for (int v = 0; v < pieces.vertices; ++v) x.row(v) *= std::sqrt(wanted[piece[v]] / areas[piece[v]]);
}

}  // namespace

Positions conformalStart(const FlatPieces& pieces) {
  const int n = pieces.vertices;
  std::vector<Eigen::Triplet<double>> lower;  // of the matrix of coordinates p_v = 2 v, q_v = 2 v + 1
  lower.reserve(21 * pieces.triangles.rows());
  for (int t = 0; t < pieces.triangles.rows(); ++t) {
    const Mat2& d = pieces.rest_edges[t];
    const double area = 0.5 * d.determinant();
    const Mat32 b = shapeGradients(d.inverse());
    Eigen::Matrix<double, 2, 6> residual;  // of p_u - q_v and p_v + q_u by the six coordinates
    for (int k = 0; k < 3; ++k) {
      residual.col(2 * k) << b(k, 0), b(k, 1);
      residual.col(2 * k + 1) << -b(k, 1), b(k, 0);
    }
    const Eigen::Matrix<double, 6, 6> block = area * residual.transpose() * residual;
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c) {
        const int i = 2 * pieces.triangles(t, r / 2) + r % 2, j = 2 * pieces.triangles(t, c / 2) + c % 2;
        if (i >= j) lower.emplace_back(i, j, block(r, c));
      }
  }
  std::vector<char> fixed(2 * n, 0);
  std::vector<double> x(2 * n, 0.0);
  for (const std::vector<int>& outline : pieces.outlines) {
    const std::vector<double> steps = outlineSteps(pieces, outline);
    double length = 0.0, half = 0.0;
    for (const double step : steps) length += step;
    size_t opposite = 0;
    while (half < 0.5 * length) half += steps[opposite++];
    const int a = outline.front(), b = outline[opposite % outline.size()];
    fixed[2 * a] = fixed[2 * a + 1] = fixed[2 * b] = fixed[2 * b + 1] = 1;
    x[2 * b] = 0.5 * length;
  }
  solveAround(lower, fixed, x);
  Positions flat = Positions::Zero(n, 3);
  for (int v = 0; v < n; ++v) flat.row(v) << x[2 * v], x[2 * v + 1], 0.0;
  scaleToRest(pieces, pieceOfVertex(pieces), flat);
  return flat;
}

Positions convexStart(const FlatPieces& pieces) {
  const int n = pieces.vertices;
  std::vector<Eigen::Triplet<double>> lower;
  for (const auto& t : pieces.triangles.rowwise())
    for (int k = 0; k < 3; ++k) {  // an inner edge counts twice, once from each side
      const int a = t[k], b = t[(k + 1) % 3];
      lower.emplace_back(a, a, 1.0);
      lower.emplace_back(b, b, 1.0);
      lower.emplace_back(std::max(a, b), std::min(a, b), -1.0);
    }
  std::vector<char> fixed(n, 0);
  std::vector<double> p(n, 0.0), q(n, 0.0);
  for (const std::vector<int>& outline : pieces.outlines) {
    const std::vector<double> steps = outlineSteps(pieces, outline);
    double length = 0.0, so_far = 0.0;
    for (const double step : steps) length += step;
    for (size_t i = 0; i < outline.size(); ++i) {
      const double angle = 2.0 * M_PI * so_far / length;
      fixed[outline[i]] = 1;
      p[outline[i]] = std::cos(angle);
      q[outline[i]] = std::sin(angle);
      so_far += steps[i];
    }
  }
  solveAround(lower, fixed, p);
  solveAround(lower, fixed, q);
  Positions flat = Positions::Zero(n, 3);
  for (int v = 0; v < n; ++v) flat.row(v) << p[v], q[v], 0.0;
  scaleToRest(pieces, pieceOfVertex(pieces), flat);
  return flat;
}

}  // namespace ease

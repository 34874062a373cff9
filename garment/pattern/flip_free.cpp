#include "garment/pattern/flip_free.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "garment/pattern/woven_stress.h"
#include "solver/base/error.h"
#include "solver/linear/gradient_system.h"
#include "solver/mesh/disjoint_sets.h"
#include "solver/mesh/numbering.h"

namespace ease {
namespace {

constexpr int kIterations = 300;     // of each of the two energies
constexpr double kBarrier = 0.01;    // weight of the symmetric Dirichlet energy beside the woven one
constexpr double kBeforeFlip = 0.8;  // share of the way to the first flip that a step may go

double barrier(const Mat2& F) {
  const double det = F.determinant();
  if (det <= 0.0) return std::numeric_limits<double>::infinity();
  return F.squaredNorm() * (1.0 + 1.0 / (det * det));  // |F^-1|^2 = |F|^2 / det^2 in the plane
}

/// Half the derivative of barrier() by F.
Mat2 barrierStress(const Mat2& F) {
  const Mat2 inverse = F.inverse();
  return F - inverse.transpose() * inverse * inverse.transpose();
}

/// The largest step, at most 1, before a triangle with edges `e` flips that changes by `d` in a whole step.
double stepToFlip(const Mat2& e, const Mat2& d) {
  // det(e + s d) = a s^2 + b s + c
  const double a = d.determinant(), c = e.determinant();
  const double b = e(0, 0) * d(1, 1) + d(0, 0) * e(1, 1) - e(0, 1) * d(1, 0) - d(0, 1) * e(1, 0);
  double first = std::numeric_limits<double>::infinity();
  const double root2 = b * b - 4.0 * a * c;
  if (root2 >= 0.0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(root2), b));
    for (const double s : {q != 0.0 ? c / q : -1.0, a != 0.0 ? q / a : -1.0})
      if (s > 0.0) first = std::min(first, s);
  }
  return std::min(1.0, kBeforeFlip * first);
}

/// One piece, its energy and its descent.
class FlipFree {
 public:
  FlipFree(const FlatPieces& piece, const WovenSettings& settings)
      : piece_(piece),
        settings_(settings),
        system_(piece.vertices, piece.triangles),
        targets_(piece.rest_edges.size(), Mat32::Zero()) {
    std::vector<double> diagonal(piece.vertices, 0.0);
    diagonal[piece.outlines.front().front()] = 1.0;
    for (const Mat2& d : piece.rest_edges) {
      areas_.push_back(0.5 * d.determinant());
      inverse_.push_back(d.inverse());
    }
    if (!system_.factor(inverse_, areas_, diagonal))
      throw ComputationError("a pattern piece cannot be flattened: its triangles are degenerate");
  }

  /// Descends with weights of both energies; the gradient system is the metric of the descent.
  void descend(double woven, double symmetric, Positions& x) {
    double energy = energyAt(x, woven, symmetric);
    for (int i = 0; i < kIterations; ++i) {
      if (i % 10 == 0) {
        turnToGrain(piece_, inverse_, std::vector<int>(piece_.vertices, 0), x);
        energy = energyAt(x, woven, symmetric);
      }
      for (size_t t = 0; t < targets_.size(); ++t) {
        const Mat2 F = gradient(x, t);
        targets_[t].topRows<2>() = F - woven * wovenStress(F, settings_) - symmetric * barrierStress(F);
      }
      Positions moved;
      system_.solve(targets_, x, moved);
      const Positions way = moved - x;
      double step = 1.0;
      for (int t = 0; t < piece_.triangles.rows(); ++t)
        step = std::min(step, stepToFlip(edgeMatrix(x, piece_.triangles, t).topRows<2>(),
                                         edgeMatrix(way, piece_.triangles, t).topRows<2>()));
      double lower = energy;
      Positions trial;
      for (int halving = 0; halving < 30; ++halving, step *= 0.5) {
        trial = x + step * way;
        lower = energyAt(trial, woven, symmetric);
        if (lower < energy) break;
      }
      if (!(lower < energy)) return;
      x = trial;
      const bool is_done = energy - lower < 1e-10 * energy;
      energy = lower;
      if (is_done) return;
    }
  }

 private:
  Mat2 gradient(const Positions& x, size_t t) const {
    return planeGradient(piece_, x, static_cast<int>(t), inverse_[t]);
  }

  double energyAt(const Positions& x, double woven, double symmetric) const {
    double sum = 0.0;
    for (size_t t = 0; t < areas_.size(); ++t) {
      const Mat2 F = gradient(x, t);
      sum += areas_[t] * (woven * wovenEnergy(F, settings_) + symmetric * barrier(F));
    }
    return sum;
  }

  const FlatPieces& piece_;
  const WovenSettings settings_;
  GradientSystem system_;
  std::vector<double> areas_;
  std::vector<Mat2> inverse_;
  std::vector<Mat32> targets_;
};

}  // namespace

std::vector<int> pieceOfVertex(const FlatPieces& pieces) {
  DisjointSets sets(pieces.vertices);
  for (const auto& t : pieces.triangles.rowwise()) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<int> of_set(pieces.vertices, -1), piece(pieces.vertices);
  for (size_t p = 0; p < pieces.outlines.size(); ++p)
    of_set[sets.find(pieces.outlines[p].front())] = static_cast<int>(p);
  for (int v = 0; v < pieces.vertices; ++v) piece[v] = of_set[sets.find(v)];
  return piece;
}

void turnToGrain(const FlatPieces& pieces, const std::vector<Mat2>& rest_inverse, const std::vector<int>& piece,
                 Positions& x) {
  const size_t count = pieces.outlines.size();
  std::vector<Mat2> turn(count, Mat2::Zero());
  std::vector<Vec3> middle(count, Vec3::Zero());
  std::vector<double> area(count, 0.0);
  for (int t = 0; t < pieces.triangles.rows(); ++t) {
    const int p = piece[pieces.triangles(t, 0)];
    const double a = 0.5 * pieces.rest_edges[t].determinant();
    turn[p] += a * planeGradient(pieces, x, t, rest_inverse[t]);
    for (int k = 0; k < 3; ++k) middle[p] += a / 3.0 * x.row(pieces.triangles(t, k)).transpose();
    area[p] += a;
  }
  for (size_t p = 0; p < count; ++p) {
    turn[p] = leftPolar(turn[p]).R.transpose().eval();
    middle[p] /= area[p];
  }
  for (int v = 0; v < pieces.vertices; ++v) {
    const int p = piece[v];
    const Eigen::Vector2d from_middle = (x.row(v) - middle[p].transpose()).head<2>();
    x.row(v).head<2>() = middle[p].head<2>() + turn[p] * from_middle;
  }
}

std::vector<int> flippedPieces(const FlatPieces& pieces, const std::vector<int>& piece, const Positions& x) {
  std::vector<int> flipped;
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    if (!(edgeMatrix(x, pieces.triangles, t).topRows<2>().determinant() > 0.0))
      flipped.push_back(piece[pieces.triangles(t, 0)]);
  std::sort(flipped.begin(), flipped.end());
  flipped.erase(std::unique(flipped.begin(), flipped.end()), flipped.end());
  return flipped;
}

void flattenWithoutFlips(const FlatPieces& pieces, const std::vector<int>& piece, int which,
                         const WovenSettings& settings, Positions& x) {
  std::vector<int> kept;
  for (int t = 0; t < pieces.triangles.rows(); ++t)
    if (piece[pieces.triangles(t, 0)] == which) kept.push_back(t);
  const Numbering part = partNumbering(pieces.triangles, std::move(kept));
  const std::vector<int> number = newNumbers(part.vertices);
  FlatPieces one;
  one.vertices = static_cast<int>(part.vertices.size());
  one.triangles = renumbered(pieces.triangles, part);
  one.rest_edges = renumbered(pieces.rest_edges, part.triangles);
  one.outlines.emplace_back();
  for (const int v : pieces.outlines[which]) one.outlines.front().push_back(number[v]);
  Positions flat = convexStart(one);
  FlipFree descent(one, settings);
  descent.descend(0.0, 1.0, flat);
  descent.descend(1.0, kBarrier, flat);
  for (int v = 0; v < one.vertices; ++v) x.row(part.vertices[v]) = flat.row(v);
}

}  // namespace ease

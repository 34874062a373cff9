#include "garment/pattern/flattening.h"

#include <algorithm>
#include <cmath>

#include "garment/pattern/flip_free.h"
#include "garment/pattern/woven_stress.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/linear/gradient_system.h"

namespace ease {
namespace {

constexpr int kTurnEvery = 10;  // iterations
constexpr int kGrain = 128;     // triangles for a task

/// The pieces' triangles as one linear system, and the steps of the local/global alternation.
class Alternation {
 public:
  Alternation(const FlatPieces& pieces, const std::vector<SewnPair>& pairs, const std::vector<WovenSettings>& of_piece,
              const std::vector<int>& piece_of_vertex, const std::vector<double>& excess_of_triangle)
      : pieces_(pieces),
        pairs_(pairs),
        of_piece_(of_piece),
        piece_of_vertex_(piece_of_vertex),
        excess_of_triangle_(excess_of_triangle),
        system_(pieces.vertices, pieces.triangles),
        targets_(pieces.rest_edges.size(), Mat32::Zero()),
        bond_targets_(2 * pairs.size()),
        overshoot_(pairs.size(), 0.0) {
    std::vector<double> areas, diagonal(pieces.vertices, 0.0);
    for (const Mat2& d : pieces.rest_edges) {
      areas.push_back(0.5 * d.determinant());
      rest_inverse_.push_back(d.inverse());
    }
    for (const std::vector<int>& outline : pieces.outlines) diagonal[outline.front()] = 1.0;
    std::vector<Bond> bonds;
    for (const SewnPair& pair : pairs) {
      bonds.push_back({pair.a1, pair.a0, of_piece.front().seam_weight});
      bonds.push_back({pair.b1, pair.b0, of_piece.front().seam_weight});
    }
    system_.setBonds(bonds);
    if (!system_.factor(rest_inverse_, areas, diagonal))
      throw ComputationError("a pattern piece cannot be flattened: its triangles are degenerate");
  }

  const std::vector<Mat2>& restInverse() const { return rest_inverse_; }
  WovenSettings settingsOf(int t) const {
    WovenSettings settings = of_piece_[piece_of_vertex_[pieces_.triangles(t, 0)]];
    if (!excess_of_triangle_.empty()) settings.excess = excess_of_triangle_[t];
    return settings;
  }

  /// One local and one global step; returns the largest move of a vertex, m.
  double step(Positions& x) {
    parallelFor(static_cast<int>(targets_.size()), kGrain, [&](int t) {
      const Mat2 F = planeGradient(pieces_, x, t, rest_inverse_[t]);
      targets_[t].topRows<2>() = F - wovenStress(F, settingsOf(t));
    });
    for (size_t p = 0; p < pairs_.size(); ++p) {
      const Vec3 a = x.row(pairs_[p].a1) - x.row(pairs_[p].a0), b = x.row(pairs_[p].b1) - x.row(pairs_[p].b0);
      const double mean = 0.5 * (a.norm() + b.norm());
      overshoot_[p] += 0.5 * (a.norm() - b.norm());
      bond_targets_[2 * p] = a.normalized() * std::max(0.0, mean - overshoot_[p]);
      bond_targets_[2 * p + 1] = b.normalized() * std::max(0.0, mean + overshoot_[p]);
    }
    before_ = x;
    system_.solve(targets_, before_, x, bond_targets_);
    return (x - before_).rowwise().norm().maxCoeff();
  }

 private:
  const FlatPieces& pieces_;
  const std::vector<SewnPair>& pairs_;
  const std::vector<WovenSettings>& of_piece_;
  const std::vector<int>& piece_of_vertex_;
  const std::vector<double>& excess_of_triangle_;
  GradientSystem system_;
  std::vector<Mat2> rest_inverse_;
  std::vector<Mat32> targets_;
  std::vector<Vec3> bond_targets_;
  std::vector<double> overshoot_;  // by pair, m: sum of how much longer than their mean the first edge was
  Positions before_;
};

}  // namespace

Flattened flatten(const FlatPieces& pieces, const std::vector<SewnPair>& pairs, const WovenSettings& settings,
                  const Positions* start, const std::vector<double>& shear_of_piece,
                  const std::vector<double>& excess_of_triangle) {
  Flattened flat;
  flat.x = start ? *start : conformalStart(pieces);
  const std::vector<int> piece = pieceOfVertex(pieces);
  std::vector<WovenSettings> of_piece(pieces.outlines.size(), settings);
  for (size_t p = 0; p < shear_of_piece.size(); ++p) of_piece[p].shear = shear_of_piece[p];
  Alternation alternation(pieces, pairs, of_piece, piece, excess_of_triangle);
  const auto iterate = [&](int most) {
    for (int i = 0; i < most; ++i) {
      if (i % kTurnEvery == 0) turnToGrain(pieces, alternation.restInverse(), piece, flat.x);
      if (alternation.step(flat.x) < settings.tolerance) break;
    }
  };
  iterate(settings.max_iterations);
  if (const std::vector<int> flipped = flippedPieces(pieces, piece, flat.x); settings.mends && !flipped.empty()) {
    flat.mended = static_cast<int>(flipped.size());
    for (const int p : flipped) flattenWithoutFlips(pieces, piece, p, of_piece[p], flat.x);
  }
  turnToGrain(pieces, alternation.restInverse(), piece, flat.x);
  for (size_t t = 0; t < pieces.rest_edges.size(); ++t)
    flat.energy += 0.5 * pieces.rest_edges[t].determinant() *
                   wovenEnergy(planeGradient(pieces, flat.x, static_cast<int>(t), alternation.restInverse()[t]),
                               alternation.settingsOf(static_cast<int>(t)));
  return flat;
}

}  // namespace ease

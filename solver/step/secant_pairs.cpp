#include "solver/step/secant_pairs.h"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kRows = 1024;  // rows of a block

/// A range of rows of an n x 3 array.
struct Block {
  int begin, rows;
  auto of(Positions& a) const { return a.middleRows(begin, rows); }
  auto of(const Positions& a) const { return a.middleRows(begin, rows); }
  double dot(const Positions& a, const Positions& b) const { return of(a).cwiseProduct(of(b)).sum(); }
};

}  // namespace

/// Calls sweep(block, sums) for all blocks of rows; adds up the blocks' sums in the order of the blocks.
template <class Sweep>
SecantPairs::Sums SecantPairs::sums(int rows, const Sweep& sweep) {
  partial_.resize((rows + kRows - 1) / kRows);
  parallelFor(static_cast<int>(partial_.size()), 1, [&](int b) {
    partial_[b].fill(0.0);
    sweep(Block{b * kRows, std::min(kRows, rows - b * kRows)}, partial_[b]);
  });
  Sums total{};
  for (const Sums& partial : partial_)
    for (size_t k = 0; k < total.size(); ++k) total[k] += partial[k];
  return total;
}

void SecantPairs::applyFirstLoop(const Positions& gradient, Positions& q) {
  const int rows = static_cast<int>(gradient.rows());
  q.resize(rows, 3);
  const Sums along = sums(rows, [&](const Block& block, Sums& sum) {
    for (int k = 0; k < count_; ++k) sum[k] = -block.dot(pairs_[slot(k)].s, gradient);
  });
  for (int k = 0; k < count_; ++k) {
    double s_q = along[k];
    for (int newer = 0; newer < k; ++newer) s_q -= alpha_[newer] * product_[slot(k)][slot(newer)];
    alpha_[k] = s_q / product_[slot(k)][slot(k)];
  }
  sums(rows, [&](const Block& block, Sums&) {
    block.of(q) = -block.of(gradient);
    for (int k = 0; k < count_; ++k) block.of(q) -= alpha_[k] * block.of(pairs_[slot(k)].y);
  });
}

double SecantPairs::applySecondLoop(const Positions& gradient, Positions& d) {
  const int rows = static_cast<int>(gradient.rows());
  const Sums along = sums(rows, [&](const Block& block, Sums& sum) {
    for (int k = 0; k < count_; ++k) sum[k] = block.dot(pairs_[slot(k)].y, d);
  });
  std::array<double, kMaxPairs> weight;
  for (int k = count_ - 1; k >= 0; --k) {
    double y_d = along[k];
    for (int older = k + 1; older < count_; ++older) y_d += weight[older] * product_[slot(older)][slot(k)];
    weight[k] = alpha_[k] - y_d / product_[slot(k)][slot(k)];
  }
  return sums(rows, [&](const Block& block, Sums& sum) {
    for (int k = 0; k < count_; ++k) block.of(d) += weight[k] * block.of(pairs_[slot(k)].s);
    sum[0] = block.dot(gradient, d);
  })[0];
}

void SecantPairs::remember(const Positions& x, const Positions& gradient, const Positions& next_x,
                           const Positions& next_gradient) {
  const int next = (newest_ + 1) % kMaxPairs, older = std::min(count_, kMaxPairs - 1);
  Pair& pair = pairs_[next];
  pair.s.resize(x.rows(), 3);
  pair.y.resize(x.rows(), 3);
  const Sums sum = sums(static_cast<int>(x.rows()), [&](const Block& block, Sums& partial) {
    block.of(pair.s) = block.of(next_x) - block.of(x);
    block.of(pair.y) = block.of(next_gradient) - block.of(gradient);
    for (int k = 0; k < older; ++k) partial[k] = block.dot(pairs_[slot(k)].s, pair.y);
    partial[kMaxPairs - 1] = block.dot(pair.s, pair.y);
    partial[kMaxPairs] = block.dot(pair.s, pair.s);
    partial[kMaxPairs + 1] = block.dot(pair.y, pair.y);
  });
  const double curvature = sum[kMaxPairs - 1];
  if (!(curvature > 1e-10 * std::sqrt(sum[kMaxPairs] * sum[kMaxPairs + 1]))) {
    count_ = older;  // the new pair has overwritten the oldest one
    return;
  }
  for (int k = 0; k < older; ++k) product_[slot(k)][next] = sum[k];
  product_[next][next] = curvature;
  newest_ = next;
  count_ = older + 1;
}

}  // namespace ease

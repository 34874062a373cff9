#include "solver/linear/panels.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>

#include "solver/base/parallel.h"

namespace ease {

namespace {

constexpr int kMaxStride = 4;          // floats per row of x
constexpr size_t kParts = 8;           // a subtree has at most 1/kParts of the entries
constexpr size_t kMinToSplit = 20000;  // a factor with fewer entries is solved before a second thread could start

using Quad = Eigen::Array4f;  // three right-hand sides of a row and one unused value
using Vector = Eigen::Map<Eigen::VectorXf>;
using Block = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

Eigen::Map<Quad> quad(float* values, int row) {
  return Eigen::Map<Quad>(values + 4 * static_cast<size_t>(row));
}

}  // namespace

void Panels::set(const PanelShape& shape, std::span<const double> values) {
  if (!(shape == shape_)) {
    shape_ = shape;
    findSubtrees();
  }
  values_.resize(values.size());
  constexpr int kBlock = 1 << 14;
  const int blocks = static_cast<int>((values.size() + kBlock - 1) / kBlock);
  parallelFor(blocks, 4, [&](int b) {
    const size_t begin = size_t{kBlock} * b, end = std::min(values.size(), begin + kBlock);
    std::transform(values.begin() + begin, values.begin() + end, values_.begin() + begin,
                   [](double value) { return static_cast<float>(value); });
  });
}

void Panels::findSubtrees() {
  const int count = shape_.panelCount(), n = shape_.first_column.back();
  std::vector<int> panel_of(n), parent(count, -1), first(count);
  std::vector<size_t> entries(count);  // number of entries in a panel and all its descendants
  size_t total = 0;
  int most_rows = 0;
  for (int s = 0; s < count; ++s) {
    std::fill(panel_of.begin() + shape_.first_column[s], panel_of.begin() + shape_.first_column[s + 1], s);
    entries[s] = static_cast<size_t>(shape_.rowCount(s)) * shape_.columnCount(s);
    total += entries[s];
    first[s] = s;
    most_rows = std::max(most_rows, shape_.rowCount(s));
  }
  std::vector<std::vector<int>> children(count);
  std::vector<int> open;  // roots of subtrees
  for (int s = 0; s < count; ++s) {
    if (shape_.rowCount(s) > shape_.columnCount(s))
      parent[s] = panel_of[shape_.rows[shape_.row_start[s] + shape_.columnCount(s)]];
    assert(parent[s] < 0 || parent[s] > s);
    if (parent[s] < 0) {
      open.push_back(s);
    } else {
      children[parent[s]].push_back(s);
      entries[parent[s]] += entries[s];
      first[parent[s]] = std::min(first[parent[s]], first[s]);
    }
  }

  subtrees_.clear();
  top_.clear();
  while (!open.empty()) {
    const int s = open.back();
    open.pop_back();
    if (total > kMinToSplit && entries[s] > total / kParts) {
      top_.push_back(s);
      open.insert(open.end(), children[s].begin(), children[s].end());
    } else {
      const int columns = shape_.columnCount(s), below = shape_.rowCount(s) - columns;
      const std::span<const int> above(shape_.rows.data() + shape_.row_start[s] + columns, below);
      subtrees_.push_back({first[s], s + 1, above, std::vector<float>(kMaxStride * n), std::vector<float>(most_rows)});
    }
  }
  std::sort(top_.begin(), top_.end());
  std::sort(subtrees_.begin(), subtrees_.end(), [](const Subtree& a, const Subtree& b) { return a.begin < b.begin; });
  x_.resize(kMaxStride * n);
  work_.resize(most_rows);
}

/// Solves with L for the panel's columns, one after the other. Then subtracts their products from the rows below: rows
/// before `last_column` are changed in x_, the products of later rows are added to `updates`.
template <>
void Panels::forward<1>(int panel, int last_column, float* updates, float* work) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int below = height - width;
  const int* rows = shape_.rows.data() + shape_.row_start[panel] + width;
  const float* values = values_.data() + shape_.value_start[panel];
  float* own = x_.data() + first;
  for (int j = 0; j < width; ++j) {
    const float* column = values + static_cast<size_t>(j) * height;
    own[j] /= column[j];
    for (int i = j + 1; i < width; ++i) own[i] -= column[i] * own[j];
  }
  if (below == 0) return;
  Vector product(work, below);
  product.noalias() = Block(values + width, below, width, Eigen::OuterStride<>(height)) * Vector(own, width);
  int i = 0;
  for (; i < below && rows[i] < last_column; ++i) x_[rows[i]] -= product[i];
  for (; i < below; ++i) updates[rows[i]] += product[i];
}

/// Solves with Lᵀ for the panel's columns, from the last to the first. The rows below must be solved already.
template <>
void Panels::backward<1>(int panel, float* work) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int below = height - width;
  const int* rows = shape_.rows.data() + shape_.row_start[panel] + width;
  const float* values = values_.data() + shape_.value_start[panel];
  float* own = x_.data() + first;
  if (below > 0) {
    Vector known(work, below);
    for (int i = 0; i < below; ++i) known[i] = x_[rows[i]];
    Vector(own, width).noalias() -=
        Block(values + width, below, width, Eigen::OuterStride<>(height)).transpose() * known;
  }
  for (int j = width - 1; j >= 0; --j) {
    const float* column = values + static_cast<size_t>(j) * height;
    for (int i = j + 1; i < width; ++i) own[j] -= column[i] * own[i];
    own[j] /= column[j];
  }
}

/// Solves for three right-hand sides, one quad per row. Each entry of L is read once for all three, and four rows at a
/// time keep four sums in registers.
template <>
void Panels::forward<3>(int panel, int last_column, float* updates, float*) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int* rows = shape_.rows.data() + shape_.row_start[panel];
  const float* values = values_.data() + shape_.value_start[panel];
  float* x = x_.data();
  for (int j = 0; j < width; ++j) {
    const float* column = values + static_cast<size_t>(j) * height;
    const Quad known = quad(x, first + j) / column[j];
    quad(x, first + j) = known;
    for (int i = j + 1; i < width; ++i) quad(x, first + i) -= column[i] * known;
  }
  const auto hand_on = [&](int i, const Quad& sum) {
    if (rows[i] < last_column) {
      quad(x, rows[i]) -= sum;
    } else {
      quad(updates, rows[i]) += sum;
    }
  };
  int i = width;
  for (; i + 4 <= height; i += 4) {
    Quad sum[4] = {Quad::Zero(), Quad::Zero(), Quad::Zero(), Quad::Zero()};
    for (int j = 0; j < width; ++j) {
      const float* entry = values + static_cast<size_t>(j) * height + i;
      const Quad known = quad(x, first + j);
      for (int r = 0; r < 4; ++r) sum[r] += entry[r] * known;
    }
    for (int r = 0; r < 4; ++r) hand_on(i + r, sum[r]);
  }
  for (; i < height; ++i) {
    Quad sum = Quad::Zero();
    for (int j = 0; j < width; ++j) sum += values[static_cast<size_t>(j) * height + i] * quad(x, first + j);
    hand_on(i, sum);
  }
}

/// Solves for three right-hand sides, one quad per row. Four columns at a time keep four sums in registers.
template <>
void Panels::backward<3>(int panel, float*) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int* rows = shape_.rows.data() + shape_.row_start[panel];
  const float* values = values_.data() + shape_.value_start[panel];
  float* x = x_.data();
  int j = 0;
  for (; j + 4 <= width; j += 4) {
    Quad sum[4] = {Quad::Zero(), Quad::Zero(), Quad::Zero(), Quad::Zero()};
    const float* column = values + static_cast<size_t>(j) * height;
    for (int i = width; i < height; ++i) {
      const Quad known = quad(x, rows[i]);
      for (int c = 0; c < 4; ++c) sum[c] += column[static_cast<size_t>(c) * height + i] * known;
    }
    for (int c = 0; c < 4; ++c) quad(x, first + j + c) -= sum[c];
  }
  for (; j < width; ++j) {
    const float* column = values + static_cast<size_t>(j) * height;
    Quad sum = Quad::Zero();
    for (int i = width; i < height; ++i) sum += column[i] * quad(x, rows[i]);
    quad(x, first + j) -= sum;
  }
  for (j = width - 1; j >= 0; --j) {
    const float* column = values + static_cast<size_t>(j) * height;
    Quad sum = quad(x, first + j);
    for (int i = j + 1; i < width; ++i) sum -= column[i] * quad(x, first + i);
    quad(x, first + j) = sum / column[j];
  }
}

template <int Columns>
void Panels::solveColumns(const double* b, double* x) {
  constexpr int kStride = Columns == 1 ? 1 : kMaxStride;
  const int n = shape_.first_column.back(), subtrees = static_cast<int>(subtrees_.size());
  const auto& ordering = shape_.ordering;
  parallelFor(n, 4096, [&](int k) {
    for (int c = 0; c < Columns; ++c) x_[k * kStride + c] = static_cast<float>(b[ordering[k] * Columns + c]);
  });
  parallelFor(subtrees, 1, [&](int t) {
    Subtree& subtree = subtrees_[t];
    for (int row : subtree.above) std::fill_n(subtree.updates.data() + row * kStride, kStride, 0.0f);
    const int last_column = shape_.first_column[subtree.end];
    for (int s = subtree.begin; s < subtree.end; ++s)
      forward<Columns>(s, last_column, subtree.updates.data(), subtree.work.data());
  });
  for (const Subtree& subtree : subtrees_)
    for (int row : subtree.above)
      for (int c = 0; c < Columns; ++c) x_[row * kStride + c] -= subtree.updates[row * kStride + c];
  for (int s : top_) forward<Columns>(s, n, nullptr, work_.data());
  for (auto s = top_.rbegin(); s != top_.rend(); ++s) backward<Columns>(*s, work_.data());
  parallelFor(subtrees, 1, [&](int t) {
    for (int s = subtrees_[t].end - 1; s >= subtrees_[t].begin; --s) backward<Columns>(s, subtrees_[t].work.data());
  });
  parallelFor(n, 4096, [&](int k) {
    for (int c = 0; c < Columns; ++c) x[ordering[k] * Columns + c] = x_[k * kStride + c];
  });
}

void Panels::solve(const double* b, double* x, int columns) {
  assert(columns == 1 || columns == 3);
  columns == 1 ? solveColumns<1>(b, x) : solveColumns<3>(b, x);
}

}  // namespace ease

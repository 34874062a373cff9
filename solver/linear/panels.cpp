#include "solver/linear/panels.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>

#include "solver/linear/parallel.h"

namespace ease {

namespace {

constexpr int kMostColumns = 3;
constexpr size_t kParts = 8;            // a subtree is at most this part of the work
constexpr size_t kWorthASplit = 20000;  // entries: a smaller factor is solved before a second thread has woken up

using Vector = Eigen::Map<Eigen::VectorXf>;
using Block = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

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
  std::vector<size_t> entries(count);  // of a panel and all that lead to it
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
    if (total > kWorthASplit && entries[s] > total / kParts) {
      top_.push_back(s);
      open.insert(open.end(), children[s].begin(), children[s].end());
    } else {
      const int columns = shape_.columnCount(s), below = shape_.rowCount(s) - columns;
      const std::span<const int> above(shape_.rows.data() + shape_.row_start[s] + columns, below);
      subtrees_.push_back(
          {first[s], s + 1, above, std::vector<float>(kMostColumns * n), std::vector<float>(kMostColumns * most_rows)});
    }
  }
  std::sort(top_.begin(), top_.end());
  std::sort(subtrees_.begin(), subtrees_.end(), [](const Subtree& a, const Subtree& b) { return a.begin < b.begin; });
  x_.resize(kMostColumns * n);
  work_.resize(kMostColumns * most_rows);
}

// L is solved column by column of the panel, then what the panel's unknowns do to the rows below is handed on: to x_ up
// to last_column, to the updates beyond.
template <int Columns>
void Panels::forward(int panel, int last_column, float* updates, float* work) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int below = height - width;
  const int* rows = shape_.rows.data() + shape_.row_start[panel] + width;
  const float* values = values_.data() + shape_.value_start[panel];
  for (int k = 0; k < Columns; ++k) {
    float* own = work;
    for (int j = 0; j < width; ++j) own[j] = x_[(first + j) * Columns + k];
    for (int j = 0; j < width; ++j) {
      const float* column = values + static_cast<size_t>(j) * height;
      own[j] /= column[j];
      const float value = own[j];
      for (int i = j + 1; i < width; ++i) own[i] -= column[i] * value;
      x_[(first + j) * Columns + k] = value;
    }
    if (below == 0) continue;
    Vector product(work + width, below);
    product.noalias() = Block(values + width, below, width, Eigen::OuterStride<>(height)) * Vector(own, width);
    int i = 0;
    for (; i < below && rows[i] < last_column; ++i) x_[rows[i] * Columns + k] -= product[i];
    for (; i < below; ++i) updates[rows[i] * Columns + k] += product[i];
  }
}

template <int Columns>
void Panels::backward(int panel, float* work) {
  const int first = shape_.first_column[panel], width = shape_.columnCount(panel), height = shape_.rowCount(panel);
  const int below = height - width;
  const int* rows = shape_.rows.data() + shape_.row_start[panel] + width;
  const float* values = values_.data() + shape_.value_start[panel];
  for (int k = 0; k < Columns; ++k) {
    float* own = work;
    for (int j = 0; j < width; ++j) own[j] = x_[(first + j) * Columns + k];
    if (below > 0) {
      Vector known(work + width, below);
      for (int i = 0; i < below; ++i) known[i] = x_[rows[i] * Columns + k];
      Vector(own, width).noalias() -=
          Block(values + width, below, width, Eigen::OuterStride<>(height)).transpose() * known;
    }
    for (int j = width - 1; j >= 0; --j) {
      const float* column = values + static_cast<size_t>(j) * height;
      float sum = own[j];
      for (int i = j + 1; i < width; ++i) sum -= column[i] * own[i];
      own[j] = sum / column[j];
      x_[(first + j) * Columns + k] = own[j];
    }
  }
}

void Panels::solve(const double* b, double* x, int columns) {
  assert(columns == 1 || columns == 3);
  columns == 1 ? solveColumns<1>(b, x) : solveColumns<3>(b, x);
}

template <int Columns>
void Panels::solveColumns(const double* b, double* x) {
  const int n = shape_.first_column.back(), subtrees = static_cast<int>(subtrees_.size());
  const auto& ordering = shape_.ordering;
  parallelFor(n, 4096, [&](int k) {
    for (int c = 0; c < Columns; ++c) x_[k * Columns + c] = static_cast<float>(b[ordering[k] * Columns + c]);
  });
  parallelFor(subtrees, 1, [&](int t) {
    Subtree& subtree = subtrees_[t];
    for (int row : subtree.above) std::fill_n(subtree.updates.data() + row * Columns, Columns, 0.0f);
    const int last_column = shape_.first_column[subtree.end];
    for (int s = subtree.begin; s < subtree.end; ++s)
      forward<Columns>(s, last_column, subtree.updates.data(), subtree.work.data());
  });
  for (const Subtree& subtree : subtrees_)
    for (int row : subtree.above)
      for (int c = 0; c < Columns; ++c) x_[row * Columns + c] -= subtree.updates[row * Columns + c];
  for (int s : top_) forward<Columns>(s, n, nullptr, work_.data());
  for (auto s = top_.rbegin(); s != top_.rend(); ++s) backward<Columns>(*s, work_.data());
  parallelFor(subtrees, 1, [&](int t) {
    for (int s = subtrees_[t].end - 1; s >= subtrees_[t].begin; --s) backward<Columns>(s, subtrees_[t].work.data());
  });
  parallelFor(n, 4096, [&](int k) {
    for (int c = 0; c < Columns; ++c) x[ordering[k] * Columns + c] = x_[k * Columns + c];
  });
}

}  // namespace ease

#include "bench/machine_bounds.h"

#include <Eigen/Core>
#include <chrono>
#include <cmath>

#include "solver/base/parallel.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

constexpr double kMeasure = 0.01;  // s: shortest duration of each of the five measurements

/// Returns the time of one call in the fastest of five measurements, s.
template <class Work>
double leastSeconds(const Work& work) {
  double least = 1e9;
  for (int attempt = 0; attempt < 5; ++attempt) {
    const auto start = std::chrono::steady_clock::now();
    int calls = 0;
    double seconds = 0.0;
    while (seconds < kMeasure) {
      work();
      ++calls;
      seconds = secondsSince(start);
    }
    least = std::min(least, seconds / calls);
  }
  return least;
}

}  // namespace

double readBandwidth(size_t bytes) {
  constexpr int kBlock = 8192;  // doubles
  const int blocks = std::max(1, static_cast<int>(bytes / sizeof(double) / kBlock));
  const Eigen::VectorXd data = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(blocks) * kBlock);
  double total = 0.0, most = 0.0;
  const auto measure = [&](const auto& sumOfBlock) {
    const double seconds = leastSeconds([&] { total += parallelSum(blocks, sumOfBlock); });
    most = std::max(most, static_cast<double>(data.size() * sizeof(double)) / seconds);
  };
  const auto part = [&](int b, int k, int parts) {
    return data.segment(static_cast<Eigen::Index>(b) * kBlock + k * (kBlock / parts), kBlock / parts).array();
  };
  measure([&](int b) { return part(b, 0, 1).sum(); });
  measure([&](int b) { return (part(b, 0, 4) + part(b, 1, 4) + part(b, 2, 4) + part(b, 3, 4)).sum(); });
  return total > 0.0 ? most : 0.0;
}

double peakFlops() {
  constexpr int kSize = 256;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(kSize, kSize), b = Eigen::MatrixXd::Random(kSize, kSize);
  Eigen::MatrixXd product(kSize, kSize);
  const double seconds = leastSeconds([&] { product.noalias() = a * b; });
  return 2.0 * std::pow(kSize, 3) / seconds;
}

// Entries of L are counted row by row with the elimination tree (Liu 1990): a column has an entry in a row if it lies
// on the path in the tree from one of the row's entries to the row itself.
double factorFlops(const SparseMatrix& lower, std::span<const int> ordering, int block) {
  const int n = static_cast<int>(lower.rows());
  std::vector<int> place(n), parent(n, -1), reached_by(n, -1);
  for (int k = 0; k < n; ++k) place[ordering[k]] = k;
  std::vector<std::vector<int>> row_entries(n);
  for (int j = 0; j < n; ++j)
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      const int a = place[entry.row()], b = place[j];
      if (a != b) row_entries[std::max(a, b)].push_back(std::min(a, b));
    }
  std::vector<double> below(n, 0.0);  // entries of L's column below its diagonal
  for (int row = 0; row < n; ++row) {
    reached_by[row] = row;
    for (int column : row_entries[row])
      for (int k = column; reached_by[k] != row; k = parent[k]) {
        if (parent[k] < 0) parent[k] = row;
        reached_by[k] = row;
        ++below[k];
      }
  }
  double flops = 0.0;
  for (double count : below)
    for (int i = 0; i < block; ++i) flops += std::pow(block * count + (block - i), 2);
  return flops;
}

}  // namespace ease

#include "garment/pattern/thread_strain.h"

#include <algorithm>
#include <cmath>

namespace ease {
namespace {

/// The value that a share of the weights lies at or below.
double percentile(std::vector<std::pair<double, double>> values, double share) {
  std::sort(values.begin(), values.end());
  double total = 0.0, sum = 0.0;
  for (const auto& [value, weight] : values) total += weight;
  for (const auto& [value, weight] : values) {
    sum += weight;
    if (sum >= share * total) return value;
  }
  return 0.0;
}

}  // namespace

std::vector<ThreadStrain> threadStrains(const FlatPieces& pieces, const Positions& x) {
  std::vector<ThreadStrain> strains(pieces.rest_edges.size());
  for (size_t t = 0; t < strains.size(); ++t) {
    const Mat2 flat = edgeMatrix(x, pieces.triangles, static_cast<int>(t)).topRows<2>();
    const Mat2 to_rest = pieces.rest_edges[t] * flat.inverse();
    const double warp = to_rest.col(0).norm(), weft = to_rest.col(1).norm();
    const double sine = to_rest.col(0).dot(to_rest.col(1)) / (warp * weft);
    strains[t] = {warp, weft, std::asin(std::clamp(sine, -1.0, 1.0))};
  }
  return strains;
}

StrainSummary strainOf(const FlatPieces& pieces, const Positions& x, const std::vector<ThreadStrain>& strains,
                       const std::vector<int>& piece_of_triangle, int piece, const StrainLimits& limits) {
  StrainSummary summary;
  std::vector<std::pair<double, double>> threads, shears;
  double over = 0.0;
  for (size_t t = 0; t < strains.size(); ++t) {
    if (piece_of_triangle[t] != piece) continue;
    const double area = 0.5 * pieces.rest_edges[t].determinant(), worst = strains[t].worst();
    summary.area += area;
    summary.thread_mean += area * worst;
    if (worst > limits.thread) over += area;
    threads.emplace_back(worst, area);
    shears.emplace_back(std::abs(strains[t].shear), area);
    if (edgeMatrix(x, pieces.triangles, static_cast<int>(t)).topRows<2>().determinant() <= 0.0) ++summary.flipped;
  }
  summary.thread_mean /= summary.area;
  summary.thread_over_share = over / summary.area;
  summary.thread_p98 = percentile(std::move(threads), 0.98);
  summary.shear_p99 = percentile(std::move(shears), 0.99);
  return summary;
}

}  // namespace ease

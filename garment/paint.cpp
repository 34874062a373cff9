#include "garment/paint.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.h"

namespace ease {

std::vector<double> paintedScales(const TriangleMesh& garment, const std::vector<Brush>& brushes) {
  std::vector<double> scales(garment.triangles.rows(), 1.0);
  for (size_t b = 0; b < brushes.size(); ++b) {
    const Brush& brush = brushes[b];
    bool touches = false;
    for (size_t t = 0; t < scales.size(); ++t) {
      Vec3 centroid = Vec3::Zero();
      for (int k = 0; k < 3; ++k) centroid += garment.positions.row(garment.triangles(t, k)) / 3.0;
      const double weight = brushWeight(brush, centroid);
      touches = touches || weight > 0.0;
      scales[t] *= 1.0 + weight * (brush.value - 1.0);
    }
    if (!touches)
      throw InputError(fmt::format("paint number {}: at = [{:g}, {:g}, {:g}], radius = {:g}: touches no triangle",
                                   b + 1, brush.at.x(), brush.at.y(), brush.at.z(), brush.radius));
  }
  return scales;
}

std::vector<double> paintBetween(const std::vector<double>& before, const std::vector<double>& after) {
  if (before == after) return {};
  std::vector<double> factors = after;
  factors.resize(std::max(before.size(), after.size()), 1.0);
  for (size_t t = 0; t < before.size(); ++t) factors[t] /= before[t];
  return factors;
}

}  // namespace ease

// Rate at which an error falls with the size of the mesh or of the time step.
#pragma once

#include <cmath>
#include <vector>

namespace ease {

/// Slope of the least-squares line through (log size, log error).
inline double fittedOrder(const std::vector<double>& sizes, const std::vector<double>& errors) {
  const double n = static_cast<double>(sizes.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (size_t k = 0; k < sizes.size(); ++k) {
    const double a = std::log(sizes[k]), b = std::log(errors[k]);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace ease

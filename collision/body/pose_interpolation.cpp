#include "collision/body/pose_interpolation.h"

#include <algorithm>
#include <cmath>

#include "collision/body/gradient_interpolation.h"
#include "solver/base/parallel.h"
#include "solver/linear/gradient_system.h"
#include "solver/mesh/numbering.h"

namespace ease {

namespace {

constexpr double kError = 1e-10;  // bound of the polynomial's error, as a share of the body's size

/// Smallest degree whose error is below kError for a turn by `theta`, radians.
int polynomialDegree(double theta) {
  int n = 1;
  for (double error = 2.0 * theta / 4.0; error > kError; error *= theta / (4.0 * n)) ++n;
  return n;
}

/// Weights of the poses at s; their sum is 1.  s must not be one of the points.
std::vector<double> barycentricCoefficients(const std::vector<double>& points, double s) {
  const size_t n = points.size() - 1;
  std::vector<double> coefficients(n + 1);
  double sum = 0.0;
  for (size_t j = 0; j <= n; ++j) {
    const double weight = (j % 2 == 0 ? 1.0 : -1.0) * (j == 0 || j == n ? 0.5 : 1.0);
    coefficients[j] = weight / (s - points[j]);
    sum += coefficients[j];
  }
  for (double& coefficient : coefficients) coefficient /= sum;
  return coefficients;
}

}  // namespace

PoseInterpolation::PoseInterpolation(const Triangles& triangles, const Positions& from, const Positions& to,
                                     std::span<const int> ordering) {
  GradientInterpolation solved(triangles, from, to, ordering);
  const int n = polynomialDegree(solved.largestTurn());
  poses_.resize(n + 1);
  for (int j = 0; j <= n; ++j) {
    const double root = std::sin(0.5 * M_PI * j / n);
    points_.push_back(root * root);
    solved.at(points_[j], poses_[j]);
  }
}

void PoseInterpolation::at(double s, Positions& x) const {
  const auto node = std::find(points_.begin(), points_.end(), s);
  if (node != points_.end()) {
    x = poses_[node - points_.begin()];
    return;
  }
  const std::vector<double> coefficients = barycentricCoefficients(points_, s);
  x.resize(poses_.front().rows(), 3);
  // Blocks fit into the first-level cache; their division does not depend on the number of threads.
  constexpr int kBlock = 1024;
  const int count = static_cast<int>(x.size());
  parallelFor((count + kBlock - 1) / kBlock, 1, [&](int b) {
    const int begin = b * kBlock, end = std::min(count, begin + kBlock);
    double* out = x.data();
    std::fill(out + begin, out + end, 0.0);
    for (size_t j = 0; j < poses_.size(); ++j) {
      const double coefficient = coefficients[j];
      const double* pose = poses_[j].data();
      for (int i = begin; i < end; ++i) out[i] += coefficient * pose[i];
    }
  });
}

void PoseInterpolation::renumber(const std::vector<int>& order) {
  for (Positions& pose : poses_) pose = renumbered(pose, order);
}

InterpolatedPoses::InterpolatedPoses(const Triangles& triangles, const std::vector<Positions>& poses,
                                     std::vector<int> known_ordering)
    : ordering(std::move(known_ordering)) {
  if (poses.size() < 2) return;
  if (ordering.empty()) ordering = systemOrdering(static_cast<int>(poses.front().rows()), triangles);
  for (size_t p = 0; p + 1 < poses.size(); ++p)
    interpolations.emplace_back(triangles, poses[p], poses[p + 1], ordering);
}

InterpolatedPoses renumbered(InterpolatedPoses poses, const std::vector<int>& order) {
  const std::vector<int> number = newNumbers(order);
  for (int& vertex : poses.ordering) vertex = number[vertex];
  for (PoseInterpolation& interpolation : poses.interpolations) interpolation.renumber(order);
  return poses;
}

}  // namespace ease

#include "collision/body/body_size.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ease {

namespace {

constexpr double kReach = 0.2;  // m: what lies further from the middle moves along and keeps its size
constexpr double kKeeps = 0.3;  // m: from here on the arms keep their depth
constexpr double kKnee = 0.55, kShoulders = 1.44;  // m: heights below and above which the scale fades to 1
constexpr double kHead = 1.52;                     // m
constexpr double kNarrowest = 0.75, kWidest = 1.45;
constexpr double kSmallest = 0.8, kTallest = 2.3;  // m, of heights

/// From 0 at `from` to 1 at `to`, with no slope at either.
double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

}  // namespace

BodySize::BodySize(const BodyMeasures& measures) : height_(measures.height.value_or(kHeight) / kHeight) {
  const std::array<std::optional<double>, 3> wanted = {measures.hips, measures.waist, measures.chest};
  for (size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k]) across_[k] = *wanted[k] / (height_ * kGirths[k]);
}

double BodySize::scaleAcross(double y) const {
  const std::array<double, 6> heights = {kKnee, kLevels[0], kLevels[1], kLevels[2], kShoulders, kHead};
  const std::array<double, 6> scales = {1.0, across_[0], across_[1], across_[2], across_[2], 1.0};
  if (y <= heights.front() || y >= kHead) return 1.0;
  size_t k = 0;
  while (y > heights[k + 1]) ++k;
  return scales[k] + (scales[k + 1] - scales[k]) * smoothStep(heights[k], heights[k + 1], y);
}

Vec3 BodySize::warped(const Vec3& x) const {
  const double s = scaleAcross(x.y()), side = std::abs(x.x());
  const double out = side + (s - 1.0) * std::min(side, kReach);
  const double depth = 1.0 + (s - 1.0) * (1.0 - smoothStep(kReach, kKeeps, side));
  return {std::copysign(out, x.x()), x.y(), depth * x.z()};
}

double BodySize::minScale() const {
  return height_ * std::min(1.0, *std::min_element(across_.begin(), across_.end()));
}

MeasureRange BodySize::range(const BodyMeasures& measures, const std::string& name) {
  if (name == "height") return {kSmallest, kTallest};
  const size_t k = name == "hips" ? 0 : name == "waist" ? 1 : 2;
  const double own = measures.height.value_or(kHeight) / kHeight * kGirths[k];
  return {kNarrowest * own, kWidest * own};
}

double girth(const TriangleMesh& body, double y, double reach) {
  std::vector<Eigen::Vector2d> section;
  for (int t = 0; t < body.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = body.positions.row(body.triangles(t, k)), b = body.positions.row(body.triangles(t, (k + 1) % 3));
      if ((a.y() - y) * (b.y() - y) >= 0.0) continue;
      const Vec3 x = a + (b - a) * (y - a.y()) / (b.y() - a.y());
      if (std::abs(x.x()) < reach) section.emplace_back(x.x(), x.z());
    }
  if (section.size() < 3) return 0.0;
  std::sort(section.begin(), section.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  // Andrew's monotone chain: the lower half of the hull from left to right, then the upper one back.
  std::vector<Eigen::Vector2d> hull;
  for (int half = 0; half < 2; ++half) {
    const size_t begin = hull.size();
    for (const Eigen::Vector2d& x : section) {
      while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), x) <= 0.0) hull.pop_back();
      hull.push_back(x);
    }
    hull.pop_back();
    std::reverse(section.begin(), section.end());
  }
  double length = 0.0;
  for (size_t k = 0; k < hull.size(); ++k) length += (hull[(k + 1) % hull.size()] - hull[k]).norm();
  return length;
}

}  // namespace ease

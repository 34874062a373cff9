#include "collision/body/body_size.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

constexpr double kReach = 0.2;  // m from the plane x = 0: points beyond are shifted sideways, not scaled in x
constexpr double kKeeps = 0.3;  // m from that plane: points beyond are not scaled in z either
constexpr double kKnee = 0.55, kShoulders = 1.44;    // m: heights below and above which the scale fades to 1
constexpr double kHead = 1.52;                       // m
constexpr double kNarrowest = 0.75, kWidest = 1.45;  // allowed girths over the mannequin's at the same height
constexpr double kSmallest = 0.8, kTallest = 2.3;    // allowed heights, m

/// From 0 at `from` to 1 at `to`, with no slope at either.
double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
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

}  // namespace ease

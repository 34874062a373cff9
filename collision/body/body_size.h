// The mannequin in other sizes: its T-pose as a warp of space, from the measures of a person.
//
//   H        scale in all directions: height over the mannequin's
//   s(y)     scale across at height y, from hips over waist to chest: measure / (H times the mannequin's); 1 at the
//            knees and at the head, smooth between
//
// Up to 0.2 m from the plane between left and right a point moves to (s x, y, s z); what lies beyond, the arms, is
// moved along with that, and keeps its thickness.  A tape round chest, waist or hips therefore measures exactly s times
// as much.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Measures of a person, m. A girth that is not given is the mannequin's, scaled with the height.
struct BodyMeasures {
  std::optional<double> height, chest, waist, hips;
};

struct MeasureRange {
  double low, high;  // m
};

class BodySize {
 public:
  /// Requires measures within range().
  explicit BodySize(const BodyMeasures& measures);

  double height() const { return height_; }  // H
  /// Moves a point of the T-pose; H is not applied yet.
  Vec3 warped(const Vec3& x) const;
  /// The least by which a distance is scaled, H included.
  double minScale() const;

  /// Allowed range of "height", "chest", "waist" or "hips", m, beside the other measures.
  static MeasureRange range(const BodyMeasures& measures, const std::string& name);

  /// The mannequin's own measures, m: with a tape around, so that hollows are bridged.
  static constexpr double kHeight = 1.703;
  static constexpr std::array<double, 3> kLevels = {0.89, 1.10, 1.28};        // of hips, waist, chest, m
  static constexpr std::array<double, 3> kGirths = {0.9741, 0.6911, 0.8697};  // there, m

 private:
  double scaleAcross(double y) const;

  double height_ = 1.0;
  std::array<double, 3> across_ = {1.0, 1.0, 1.0};  // s at the levels
};

}  // namespace ease

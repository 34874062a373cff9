// Pictures of the garment for the page of a run: one moment, coloured by a value, from four sides.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/page/motion_album.h"
#include "viz/color_scale.h"
#include "viz/live_view.h"

namespace ease {

/// A value that the garment is coloured by.
struct ShownValue {
  std::string title;                                  // "Stretch"
  std::string unit;                                   // "mm"; empty: a pure number
  double factor;                                      // from the value to the unit
  ColorScale scale;                                   // of the value
  std::vector<std::pair<double, std::string>> marks;  // on the scale, with a word
};

constexpr std::array<const char*, 4> kSides = {"front", "back", "wearer's left", "wearer's right"};

class PagePictures {
 public:
  /// Throws ComputationError where no OpenGL context can be made.
  explicit PagePictures(const SceneInput& input);

  /// The garment at a moment from a side (kSides), as a data URI.  `values`: of every triangle, or of every vertex.
  std::string draw(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale, size_t side);
  /// The stretch at all moments of an album, from the front, with one camera.
  std::vector<std::string> drawFrames(const MotionAlbum& album, const ColorScale& scale);

 private:
  std::string drawn(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale,
                    const Vec3& lower, const Vec3& upper, double yaw_deg, const PictureSize& size);

  const SceneInput& input_;
  Vec3 origin_;  // m: pictures are drawn in single precision, around the garment
  LiveView view_;
};

}  // namespace ease

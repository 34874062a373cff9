// Pictures of the garment for the page of a run, coloured by a value: at one moment from four sides, or through the
// motion.
#pragma once

#include <array>
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

/// A row of pictures: the garment at a moment from all sides, coloured by a value.
struct PictureRow {
  std::string title;
  ShownValue value;
  const ShownMoment* moment;
  const std::vector<float>* values;  // of every triangle, or of every vertex
};

/// A picture from each side, as data URIs.
using SidePictures = std::array<std::string, kSides.size()>;

class PagePictures {
 public:
  /// Throws ComputationError where no OpenGL context can be made.
  explicit PagePictures(const SceneInput& input);

  /// Draws every row, with one camera for each side.
  std::vector<SidePictures> drawSides(const std::vector<PictureRow>& rows);
  /// Draws the stretch at all moments of an album, from the front, with one camera; as data URIs.
  std::vector<std::string> drawFrames(const MotionAlbum& album, const ColorScale& scale);

 private:
  const Picture& draw(const ShownMoment& moment, const std::vector<float>& values, const ColorScale& scale,
                      const Eigen::AlignedBox3d& extent, double yaw_deg, const PictureSize& size);

  const SceneInput& input_;
  Vec3 origin_;  // m: pictures are drawn in single precision, around the garment
  LiveView view_;
};

}  // namespace ease

// Colours of a value that has a limit: pale to blue up to the limit, then at once orange to dark red.
//
// The change of hue at the limit is one that colour-blind eyes see (blue against orange), and lightness falls all along
// the scale, with a step at the limit, so that a print in grey reads the same.  Colours between the given ones are
// interpolated in Oklab (Ottosson 2020, "A perceptual color space for image processing"), where equal steps look equal.
#pragma once

#include <array>
#include <cstdint>

namespace ease {

using Rgb = std::array<std::uint8_t, 3>;  // sRGB

class ColorScale {
 public:
  /// low <= limit <= high, low < high.  A limit at one of the ends leaves one half of the scale.
  ColorScale(double low, double high, double limit) : low_(low), high_(high), limit_(limit) {}

  double low() const { return low_; }
  double high() const { return high_; }
  double limit() const { return limit_; }
  bool isOver(double value) const { return value > limit_; }

  /// Colour of a value; beyond the ends as at the ends, NaN mid grey.
  Rgb color(double value) const;

 private:
  double low_, high_, limit_;
};

/// Lightness of a colour in Oklab: 0 black, 1 white.
double lightness(const Rgb& color);

}  // namespace ease

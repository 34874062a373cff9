// A colour scale for a value that has a limit: pale to dark blue up to the limit, orange to dark red above it.
//
// Colour-blind people can tell blue from orange, so they see the change of hue at the limit.  Lightness decreases along
// the whole scale and jumps at the limit, so the scale can also be read in a grey print.  Colours between the given
// ones are interpolated in Oklab (Ottosson 2020, "A perceptual color space for image processing"), where steps of equal
// length look equally large.
#pragma once

#include <array>
#include <cstdint>

namespace ease {

using Rgb = std::array<std::uint8_t, 3>;  // sRGB

class ColorScale {
 public:
  /// Requires low <= limit <= high and low < high.  If the limit equals `low` or `high`, only one half of the scale is
  /// used.
  ColorScale(double low, double high, double limit) : low_(low), high_(high), limit_(limit) {}

  double low() const { return low_; }
  double high() const { return high_; }
  double limit() const { return limit_; }
  bool isOver(double value) const { return value > limit_; }

  /// Returns the colour of a value.  Values beyond an end get the colour of that end, NaN gets a medium grey.
  Rgb color(double value) const;

 private:
  double low_, high_, limit_;
};

/// Returns the lightness of a colour in Oklab: 0 is black, 1 is white.
double lightness(const Rgb& color);

/// The smallest step of 1, 2 or 5 times a power of ten that divides `range` into at most `intervals` parts.
double tickStep(double range, int intervals);

}  // namespace ease

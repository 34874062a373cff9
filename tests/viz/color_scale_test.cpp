#include "viz/color_scale.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace {

// Degrees around the wheel red, green, blue; red 0, blue 240.
double hue(const ease::Rgb& color) {
  const double r = color[0], g = color[1], b = color[2];
  const double largest = std::max({r, g, b}), chroma = largest - std::min({r, g, b});
  REQUIRE(chroma > 0);
  if (largest == r) return std::fmod(60 * (g - b) / chroma + 360, 360);
  return largest == g ? 60 * (b - r) / chroma + 120 : 60 * (r - g) / chroma + 240;
}

}  // namespace

TEST_CASE("the steps of a scale are round and few") {
  CHECK(ease::tickStep(1.0, 5) == Approx(0.2));
  CHECK(ease::tickStep(9.0, 5) == Approx(2.0));
  CHECK(ease::tickStep(0.013, 5) == Approx(0.005));
  CHECK(ease::tickStep(600.0, 6) == Approx(100.0));
}

TEST_CASE("lightness falls all along the scale, so that a print in grey can be read") {
  const ease::ColorScale scale(0.95, 1.3, 1.09);
  double before = 2.0;
  for (int i = 0; i <= 70; ++i) {
    const double now = ease::lightness(scale.color(0.95 + 0.005 * i));
    CHECK(now < before);
    before = now;
  }
}

TEST_CASE("at the limit the hue changes at once, from blue to orange") {
  const ease::ColorScale scale(0.95, 1.3, 1.09);
  CHECK(hue(scale.color(1.09)) == Approx(205).margin(15));
  CHECK(hue(scale.color(std::nextafter(1.09, 2.0))) == Approx(22).margin(10));
  CHECK(ease::lightness(scale.color(1.09)) - ease::lightness(scale.color(1.0901)) > 0.02);
}

TEST_CASE("values beyond the ends have the colours of the ends, and NaN one of its own") {
  const ease::ColorScale scale(0.95, 1.3, 1.09);
  CHECK(scale.color(0.1) == scale.color(0.95));
  CHECK(scale.color(9.0) == scale.color(1.3));
  CHECK(scale.color(std::numeric_limits<double>::quiet_NaN()) == ease::Rgb{128, 128, 128});
}

TEST_CASE("black has no lightness, white has all") {
  CHECK(ease::lightness({0, 0, 0}) == Approx(0).margin(1e-12));
  CHECK(ease::lightness({255, 255, 255}) == Approx(1).epsilon(1e-6));
}

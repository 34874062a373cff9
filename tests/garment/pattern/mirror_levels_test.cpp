#include "garment/pattern/mirror_levels.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("mirrored levels are equal on both sides, and the left side keeps its own") {
  const RestSurface sheet = flatSheet(10, 1.0);
  const RegionLevels given = discLevels(sheet, 0.2, 0.25, 0.1);
  RegionLevels levels = given;
  MirrorLevels(sheet, 0.0, 0.05)(levels);
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 5; ++i) {
      const int right = j * 11 + i, left = j * 11 + 10 - i;
      CHECK(levels.of(1)[right] == Approx(levels.of(1)[left]).margin(1e-12));
      CHECK(levels.of(1)[left] == given.of(1)[left]);
    }
}

TEST_CASE(
    "mirrored levels stay as they are when mirrored again, and a gathered derivative is theirs by the left ones") {
  const RestSurface sheet = flatSheet(10, 1.0);
  const MirrorLevels mirror(sheet, 0.02, 0.15);  // no vertex has its image at another one
  RegionLevels levels = discLevels(sheet, 0.2, 0.25, 0.1);
  mirror(levels);
  RegionLevels again = levels;
  mirror(again);
  CHECK(again.phi == levels.phi);

  // E = sum_v c_v phi(v) of levels that are mirrored after a change d: dE = c . P d = gathered(c) . d.
  std::vector<double> c(levels.phi.size()), d(levels.phi.size());
  for (size_t v = 0; v < c.size(); ++v) {
    c[v] = std::sin(3.0 * static_cast<double>(v));
    d[v] = std::cos(5.0 * static_cast<double>(v));
  }
  RegionLevels changed = levels;
  for (size_t v = 0; v < d.size(); ++v) changed.phi[v] += d[v];
  mirror(changed);
  double change = 0.0, promised = 0.0;
  for (size_t v = 0; v < c.size(); ++v) change += c[v] * (changed.phi[v] - levels.phi[v]);
  mirror.gather(levels.labels, c);
  for (size_t v = 0; v < c.size(); ++v) promised += c[v] * d[v];
  CHECK(change == Approx(promised));
}

TEST_CASE("the middle plane halves the area") {
  CHECK(middlePlane(flatSheet(10, 1.0)) == Approx(0.0).margin(0.06));
}

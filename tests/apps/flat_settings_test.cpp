#include "apps/flat_settings.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("stiffnesses are those of the material over the largest, and shear is as soft as its limit asks for") {
  Scene scene;
  scene.material.stretch_warp = 1000.0;
  scene.material.stretch_weft = 500.0;
  scene.material.shear = 900.0;
  const WovenSettings stiff = flatSettings(scene).woven;
  CHECK(stiff.warp == 1.0);
  CHECK(stiff.weft == 0.5);
  CHECK(stiff.shear < 0.2);
  scene.material.shear = 50.0;
  CHECK(flatSettings(scene).woven.shear == Approx(0.05));
  scene.material.membrane = Membrane::isotropic;
  CHECK(flatSettings(scene).woven.shear == 0.5);
}

TEST_CASE("limits, darts, grain and width are those of the pattern") {
  Scene scene;
  scene.pattern.limits.thread = 0.03;
  scene.pattern.max_darts = 2;
  scene.pattern.free_grain = true;
  scene.pattern.fabric_width = 1.0;
  scene.pattern.allowances.all = 0.02;
  const FlatSettings settings = flatSettings(scene);
  CHECK(settings.limits.thread == 0.03);
  CHECK(settings.woven.shear_limit == settings.limits.shear);
  CHECK(settings.max_darts == 2);
  CHECK(settings.free_grain);
  CHECK(settings.widest == Approx(0.96));
}

#include "apps/flat_settings.h"

#include <algorithm>
#include <cmath>

namespace ease {
namespace {

WovenSettings wovenOf(const Material& material, const StrainLimits& limits) {
  WovenSettings woven;
  woven.shear_limit = limits.shear;
  // Cloth that is too large folds nearly without force, cloth that is too small pulls at what is around it.  On
  // shirt_4270 with three darts, the sewn garment hangs 3.03, 2.99 and 2.94 mm (RMS) from the designed one with 0.8,
  // 0.755 and 0.74, and 14.4, 14.9 and 15.1 mm at most; with 1 and the same darts 0.2 mm more, and with 0.7 five darts
  // are found.
  woven.excess = 0.755;
  if (material.membrane == Membrane::isotropic) {  // (warp, weft) any two directions: shear is half of a stretch
    woven.shear = 0.5;
    return woven;
  }
  const double largest = std::max({material.stretch_warp, material.stretch_weft, 1e-9});
  constexpr double kMinStiffness = 0.02;  // of the largest: cloth that resists nothing along a thread has no shape
  woven.warp = std::max(kMinStiffness, material.stretch_warp / largest);
  woven.weft = std::max(kMinStiffness, material.stretch_weft / largest);
  // Shear at its limit is to cost somewhat less than stretch at its own, however stiff the material is: only then are
  // both limits reached by the same shape.  The share was found on shirt_4270: with 1, threads are over 5 % on 2.0 % of
  // the cloth and shear is 12.2 degrees at 99 %, with 0.7 on 1.5 % and 13.6 degrees.
  constexpr double kShareOfStretch = 0.7;
  const double by_limits = kShareOfStretch * std::pow(limits.thread / (0.5 * limits.shear), 2);
  woven.shear = std::clamp(std::min(material.shear / largest, by_limits), kMinStiffness, 1.0);
  return woven;
}

}  // namespace

FlatSettings flatSettings(const Scene& scene) {
  FlatSettings settings;
  settings.limits = scene.pattern.limits;
  settings.woven = wovenOf(scene.material, scene.pattern.limits);
  settings.max_darts = scene.pattern.max_darts;
  settings.free_grain = scene.pattern.free_grain;
  settings.widest = scene.pattern.fabric_width - 2.0 * scene.pattern.allowances.widest();
  settings.names = scene.pattern.names;
  return settings;
}

}  // namespace ease

// What the cloth is made of.
#pragma once

#include <optional>

namespace ease {

/// Membrane after Baraff and Witkin 1998; bending after Bergou 2006.  Zero switches a term off.
struct Material {
  double density = 0.15;             // kg/m^2 of the first rest shape
  std::optional<double> total_mass;  // kg; instead of density
  double stretch_warp = 800.0;       // N/m
  double stretch_weft = 800.0;       // N/m
  double shear = 200.0;              // N/m
  double bending = 0.0;              // N m
  double damping_stretch = 0.0;      // N s/m
  double damping_shear = 0.0;        // N s/m
  double damping_bending = 0.0;      // N m s
};

}  // namespace ease

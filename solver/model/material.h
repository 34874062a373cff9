// Material of the cloth: density, stiffnesses and damping.
#pragma once

#include <optional>

namespace ease {

enum class Membrane { woven, isotropic };
enum class ShearForm { orthogonal, bw98 };

/// Membrane woven, threads as springs and shear between them, or isotropic (co-rotational); bending after Bergou 2006.
/// A stiffness of zero switches its term off.
struct Material {
  double density = 0.15;             // kg/m^2 of the first rest shape
  std::optional<double> total_mass;  // kg; instead of density
  Membrane membrane = Membrane::woven;
  double stretch_warp = 800.0;  // N/m, woven
  double stretch_weft = 800.0;  // N/m, woven
  double compression = 1.0;     // share of the stretch stiffness that compressed threads have, 0 to 1, woven
  double shear = 200.0;         // N/m, woven
  ShearForm shear_form = ShearForm::orthogonal;
  double mu = 400.0;             // N/m, isotropic
  double lambda = 0.0;           // N/m, isotropic
  double bending = 0.0;          // N m
  double damping_stretch = 0.0;  // N s/m
  double damping_shear = 0.0;    // N s/m
  double damping_bending = 0.0;  // N m s

  bool operator==(const Material&) const = default;
};

}  // namespace ease

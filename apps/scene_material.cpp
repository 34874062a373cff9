#include "apps/scene_material.h"

namespace ease {

namespace {

void readDamping(const TomlTable& table, Material& material) {
  table.allow({"stretch", "shear", "bending"});
  material.damping_stretch = table.number("stretch", material.damping_stretch, {0.0, 1e6, false, "N s/m"});
  material.damping_shear = table.number("shear", material.damping_shear, {0.0, 1e6, false, "N s/m"});
  material.damping_bending = table.number("bending", material.damping_bending, {0.0, 1e3, false, "N m s"});
}

}  // namespace

Material readMaterial(const TomlTable& table) {
  table.allow({"density", "total_mass", "membrane", "stretch", "compression", "shear", "shear_form", "mu", "lambda",
               "bending", "damping"});
  Material material;
  if (table.has("density") && table.has("total_mass"))
    table.refuse("total_mass", "either density or total_mass, not both");
  material.density = table.number("density", material.density, {0.0, 100.0, true, "kg/m^2"});
  if (table.has("total_mass")) material.total_mass = table.number("total_mass", 0.0, {0.0, 1000.0, true, "kg"});

  const bool woven = table.choice("membrane", "woven", {"woven", "isotropic"}) == "woven";
  material.membrane = woven ? Membrane::woven : Membrane::isotropic;
  for (const char* key : {"stretch", "compression", "shear", "shear_form"})
    if (!woven && table.has(key)) table.refuse(key, "mu and lambda, since the membrane is isotropic");
  for (const char* key : {"mu", "lambda"})
    if (woven && table.has(key)) table.refuse(key, "membrane = 'isotropic' for it");
  const bool bw98 = table.choice("shear_form", "orthogonal", {"orthogonal", "bw98"}) == "bw98";
  material.shear_form = bw98 ? ShearForm::bw98 : ShearForm::orthogonal;
  const Range membrane{0.0, 1e7, false, "N/m"};
  material.mu = table.number("mu", material.mu, {0.0, 1e7, true, "N/m"});
  material.lambda = table.number("lambda", material.lambda, membrane);
  if (table.isArray("stretch")) {
    const std::vector<double> stretch = table.numbers("stretch", membrane);
    if (stretch.size() != 2) table.refuse("stretch", "one number or two, [warp, weft], N/m");
    material.stretch_warp = stretch[0];
    material.stretch_weft = stretch[1];
  } else if (table.has("stretch")) {
    material.stretch_warp = material.stretch_weft = table.number("stretch", 0.0, membrane);
  }
  material.compression = table.number("compression", material.compression, {0.0, 1.0, false, ""});
  material.shear = table.number("shear", material.shear, membrane);
  material.bending = table.number("bending", material.bending, {0.0, 1e3, false, "N m"});
  if (woven && material.stretch_warp + material.stretch_weft + material.shear + material.bending == 0.0)
    table.refuse("stretch", "a stiffness above 0: with stretch, shear and bending all 0 there is no cloth");
  if (const auto damping = table.table("damping")) readDamping(*damping, material);
  return material;
}

}  // namespace ease

#include "apps/scene_material.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace ease {

namespace {

const Range kStiffness{0.0, 1e7, false, "N/m"};

void readWoven(const TomlTable& table, Material& material) {
  if (table.isArray("stretch")) {
    const std::vector<double> stretch = table.numbers("stretch", kStiffness);
    if (stretch.size() != 2) table.refuse("stretch", "one number or two, [warp, weft], N/m");
    material.stretch_warp = stretch[0];
    material.stretch_weft = stretch[1];
  } else if (table.has("stretch")) {
    material.stretch_warp = material.stretch_weft = table.number("stretch", 0.0, kStiffness);
  }
  material.compression = table.number("compression", material.compression, {0.0, 1.0, false, ""});
  material.shear = table.number("shear", material.shear, kStiffness);
  const bool bw98 = table.choice("shear_form", "orthogonal", {"orthogonal", "bw98"}) == "bw98";
  material.shear_form = bw98 ? ShearForm::bw98 : ShearForm::orthogonal;
  if (material.stretch_warp + material.stretch_weft + material.shear + material.bending == 0.0)
    table.refuse("stretch", "a stiffness above 0: with stretch, shear and bending all 0 there is no cloth");
}

void readIsotropic(const TomlTable& table, Material& material) {
  material.mu = table.number("mu", material.mu, {0.0, 1e7, true, "N/m"});
  material.lambda = table.number("lambda", material.lambda, kStiffness);
}

/// A kind of membrane: its name in a scene, the keys that it alone has, and the function that reads them.
struct MembraneKeys {
  Membrane kind;
  std::string name;
  std::vector<std::string_view> keys;
  void (*read)(const TomlTable& table, Material& material);
};
const std::vector<MembraneKeys> kMembranes = {
    {Membrane::woven, "woven", {"stretch", "compression", "shear", "shear_form"}, readWoven},
    {Membrane::isotropic, "isotropic", {"mu", "lambda"}, readIsotropic},
};

/// Reads the key `membrane` and the keys of the one chosen; refuses those of the others.
void readMembrane(const TomlTable& table, Material& material) {
  std::vector<std::string> names;
  for (const MembraneKeys& membrane : kMembranes) names.push_back(membrane.name);
  const std::string chosen = table.choice("membrane", names.front(), names);
  for (const MembraneKeys& membrane : kMembranes) {
    if (membrane.name == chosen) {
      material.membrane = membrane.kind;
      membrane.read(table, material);
      continue;
    }
    for (const std::string_view key : membrane.keys)
      if (table.has(key))
        table.refuse(
            key, fmt::format("no such key with membrane = '{}': it belongs to membrane = '{}'", chosen, membrane.name));
  }
}

void readDamping(const TomlTable& table, Material& material) {
  table.allow({"stretch", "shear", "bending"});
  material.damping_stretch = table.number("stretch", material.damping_stretch, {0.0, 1e6, false, "N s/m"});
  material.damping_shear = table.number("shear", material.damping_shear, {0.0, 1e6, false, "N s/m"});
  material.damping_bending = table.number("bending", material.damping_bending, {0.0, 1e3, false, "N m s"});
}

}  // namespace

Material readMaterial(const TomlTable& table) {
  std::vector<std::string_view> keys = {"density", "total_mass", "membrane", "bending", "damping"};
  for (const MembraneKeys& membrane : kMembranes) keys.insert(keys.end(), membrane.keys.begin(), membrane.keys.end());
  table.allow(keys);
  Material material;
  if (table.has("density") && table.has("total_mass"))
    table.refuse("total_mass", "either density or total_mass, not both");
  material.density = table.number("density", material.density, {0.0, 100.0, true, "kg/m^2"});
  if (table.has("total_mass")) material.total_mass = table.number("total_mass", 0.0, {0.0, 1000.0, true, "kg"});
  material.bending = table.number("bending", material.bending, {0.0, 1e3, false, "N m"});
  readMembrane(table, material);
  if (const auto damping = table.table("damping")) readDamping(*damping, material);
  return material;
}

}  // namespace ease

// A scene in which every term of the incremental potential acts, for tests of its derivatives.
#pragma once

#include <string>
#include <vector>

#include "solver/step/incremental_potential.h"
#include "tests/sheet.h"

namespace ease {

/// A material for which no term of the potential is zero.
inline Material everyTerm() {
  Material material;
  material.bending = 1e-3;
  material.damping_stretch = 2.0;
  material.damping_shear = 1.0;
  material.damping_bending = 1e-5;
  return material;
}

struct Term {
  std::string name;
  Material material;
  bool touches = false;
};

/// Each term of the potential alone, and all terms together. A term alone still has inertia, but with a billionth of
/// the usual mass.
inline std::vector<Term> terms() {
  Material nothing;
  nothing.density = 1.5e-10;
  nothing.stretch_warp = nothing.stretch_weft = nothing.shear = nothing.mu = nothing.lambda = 0.0;
  std::vector<Term> all;
  const auto add = [&](const std::string& name, const auto& change) {
    all.push_back({name, nothing});
    change(all.back().material);
  };
  add("stretch", [](Material& m) { m.stretch_warp = 800.0, m.stretch_weft = 500.0; });
  add("orthogonal shear", [](Material& m) { m.shear = 200.0; });
  add("bw98 shear", [](Material& m) { m.shear = 200.0, m.shear_form = ShearForm::bw98; });
  add("isotropic", [](Material& m) { m.membrane = Membrane::isotropic, m.mu = 400.0, m.lambda = 300.0; });
  add("bending", [](Material& m) { m.bending = 1e-3; });
  add("damping of stretch", [](Material& m) { m.damping_stretch = 2.0; });
  add("damping of orthogonal shear", [](Material& m) { m.damping_shear = 1.0; });
  add("damping of bw98 shear", [](Material& m) { m.damping_shear = 1.0, m.shear_form = ShearForm::bw98; });
  add("damping of bending", [](Material& m) { m.damping_bending = 1e-5; });
  add("inertia and gravity", [](Material& m) { m.density = 0.15; });
  all.push_back({"contact", nothing, true});
  all.push_back({"all", everyTerm(), true});
  return all;
}

/// A moving sheet, stretched in some places and compressed in others. If it `touches`, some samples are in contact.
struct PotentialScene {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Cloth cloth;
  IncrementalPotential potential;
  StepOptions options;
  Contacts contacts;
  Positions x;

  explicit PotentialScene(const Material& material = everyTerm(), bool touches = true)
      : cloth(mesh, Vec3(0.3, -1.0, 0.1), material), potential(cloth) {
    const int n = cloth.vertexCount(), e = static_cast<int>(cloth.topology().edges.size());
    State start{mesh.positions + 2e-3 * randomPositions(n, 1), 0.5 * randomPositions(n, 2)};
    x = start.positions + 2e-3 * randomPositions(n, 3);
    contacts.planes.resize(n + e + cloth.triangleCount());
    for (size_t s = 0; touches && s < contacts.planes.size(); s += 3) {
      contacts.planes[s].normal = Vec3(0.1, 0.2 * std::sin(0.1 * s), 1.0).normalized();
      contacts.planes[s].offset = 1.2e-2;
      if (s % 4 == 0) contacts.seconds.push_back({static_cast<int>(s), {Vec3(0.8, 0.0, 0.6), 0.1, 2e-3}});
    }
    potential.begin(start, options);
    potential.setContacts(contacts);
  }
};

}  // namespace ease

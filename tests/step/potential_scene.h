// A cloth that feels every term of the incremental potential at once, for tests of its derivatives.
#pragma once

#include "solver/step/incremental_potential.h"
#include "tests/sheet.h"

namespace ease {

/// No term of the potential is zero.
inline Material everyTerm() {
  Material material;
  material.bending = 1e-3;
  material.damping_stretch = 2.0;
  material.damping_shear = 1.0;
  material.damping_bending = 1e-5;
  return material;
}

/// A sheet in motion, stretched here and compressed there, with some samples in contact.
struct PotentialScene {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Cloth cloth;
  IncrementalPotential potential;
  StepOptions options;
  Contacts contacts;
  Positions x;

  explicit PotentialScene(const Material& material = everyTerm())
      : cloth(mesh, Vec3(0.3, -1.0, 0.1), material), potential(cloth) {
    const int n = cloth.vertexCount(), e = static_cast<int>(cloth.topology().edges.size());
    State start{mesh.positions + 2e-3 * randomPositions(n, 1), 0.5 * randomPositions(n, 2)};
    x = start.positions + 2e-3 * randomPositions(n, 3);
    contacts.planes.resize(n + e + cloth.triangleCount());
    for (size_t s = 0; s < contacts.planes.size(); s += 3) {
      contacts.planes[s].normal = Vec3(0.1, 0.2 * std::sin(0.1 * s), 1.0).normalized();
      contacts.planes[s].offset = 1.2e-2;
      if (s % 4 == 0) contacts.seconds.push_back({static_cast<int>(s), {Vec3(0.8, 0.0, 0.6), 0.1, 2e-3}});
    }
    potential.begin(start, options);
    potential.setContacts(contacts);
  }
};

}  // namespace ease

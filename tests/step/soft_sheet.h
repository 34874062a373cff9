// Sheets of soft cloth and their time steps.
#pragma once

#include "solver/step/time_step.h"
#include "tests/sheet.h"

namespace ease {

inline const FindContacts kNoContacts = [](const Positions&, Contacts& contacts) { contacts.planes.clear(); };

inline Material softCloth() {
  Material material;
  material.stretch_warp = material.stretch_weft = 200.0;
  material.shear = 50.0;
  material.bending = 1e-5;
  return material;
}

inline State atRest(const TriangleMesh& mesh) {
  return {mesh.positions, Positions::Zero(mesh.positions.rows(), 3)};
}

inline TimeStep makeStep(const Cloth& cloth, const MethodOptions& options) {
  return TimeStep(cloth, options, systemOrdering(cloth.vertexCount(), cloth.triangles()));
}

/// Pins the boundary, stretched by 5 %, so that the potential has a single minimum.
inline Pins tautPins(const Cloth& cloth) {
  Pins pins;
  for (const std::vector<int>& loop : cloth.topology().boundary_loops)
    for (int v : loop) {
      pins.vertices.push_back(v);
      pins.positions.push_back(1.05 * cloth.restPositions().row(v));
    }
  return pins;
}

}  // namespace ease

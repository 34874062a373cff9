#include "solver/step/hinge_forces.h"

#include <catch2/catch.hpp>

#include "tests/differences.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kStep = 0.01;  // s

Material bending(double stiffness, double damping) {
  Material material;
  material.bending = stiffness;
  material.damping_bending = damping;
  return material;
}

/// A sheet that is bent and then bends further within a step.
struct BentSheet {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.3);
  Cloth cloth;
  HingeForces forces;
  Positions start = mesh.positions + 1e-2 * randomPositions(static_cast<int>(mesh.positions.rows()), 1);
  Positions x = start + 5e-3 * randomPositions(static_cast<int>(mesh.positions.rows()), 2);

  explicit BentSheet(const Material& material = bending(2e-3, 1e-5))
      : cloth(mesh, -Vec3::UnitY(), material), forces(cloth) {
    forces.begin(start, kStep);
  }
};

}  // namespace

TEST_CASE("energy and vectors of the hinges are those of one hinge after the other") {
  for (const auto& [stiffness, damping] : {std::pair(2e-3, 1e-5), std::pair(2e-3, 0.0)}) {
    BentSheet sheet(bending(stiffness, damping));
    REQUIRE(sheet.cloth.hinges().size() % kLanes != 0);
    CHECK(sheet.forces.damps() == (damping > 0.0));
    const double energy = sheet.forces.evaluate(sheet.x);
    double expected = 0.0, largest = 0.0;
    for (int e = 0; e < sheet.forces.count(); ++e) {
      const Hinge& hinge = sheet.cloth.hinges()[e];
      const Vec3 b = hingeVector(hinge, sheet.x);
      const double w = stiffness * hinge.inverse_area, damped = damping / kStep * hinge.inverse_area;
      const double before = hingeVector(hinge, sheet.start).norm(), rate = b.norm() - before;
      expected += 0.5 * w * b.squaredNorm() + 0.5 * damped * rate * rate;
      const Vec3 g = (w + damped * rate / b.norm()) * b;
      CHECK((sheet.forces.vectors()[e] - g).norm() < 1e-12 * g.norm());
      CHECK(sheet.forces.damper(e).start == Approx(before).epsilon(1e-12));
      largest = std::max(largest, std::abs(rate) / before);
    }
    CHECK(energy == Approx(expected).epsilon(1e-12));
    CHECK(largest > 0.1);
  }
}

TEST_CASE("what a vertex gets from its hinges is the derivative of their energy") {
  BentSheet sheet;
  const Positions d = randomPositions(sheet.cloth.vertexCount(), 3);
  sheet.forces.evaluate(sheet.x);
  double slope = 0.0;
  for (int v = 0; v < sheet.cloth.vertexCount(); ++v) slope += sheet.forces.sumAt(v).dot(d.row(v));
  const auto energy = [&](double e) { return sheet.forces.evaluate(sheet.x + e * d); };
  CHECK(std::abs(sharpDifference(energy, 1e-5) - slope) < 1e-8 * std::abs(slope));
}

TEST_CASE("hinges follow the rest shape, and flat cloth neither bends nor divides by zero") {
  BentSheet sheet;
  const double before = sheet.forces.evaluate(sheet.x);
  std::vector<Mat2> edges = sheet.cloth.restEdges();
  for (Mat2& edge : edges) edge *= 2.0;
  sheet.cloth.setRest({sheet.cloth.restPositions(), edges});
  sheet.forces.begin(sheet.start, kStep);
  CHECK(sheet.forces.evaluate(sheet.x) == Approx(before / 4.0).epsilon(1e-12));

  sheet.forces.begin(sheet.mesh.positions, kStep);
  CHECK(sheet.forces.evaluate(sheet.mesh.positions) < 1e-25);
  for (int v = 0; v < sheet.cloth.vertexCount(); ++v) CHECK(sheet.forces.sumAt(v).norm() < 1e-12);
}

TEST_CASE("cloth without bending has no hinges to compute") {
  CHECK(BentSheet(bending(0.0, 0.0)).forces.empty());
  CHECK_FALSE(BentSheet(bending(1e-3, 0.0)).forces.empty());
}

#include "solver/step/bending_matrix.h"

#include <catch2/catch.hpp>

#include "solver/model/cloth.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kStiffness = 2e-3;  // N m

struct Bent {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.3);
  Cloth cloth;
  BendingMatrix matrix;
  Positions x;

  Bent() : cloth(mesh, -Vec3::UnitY(), bending()), matrix(cloth.vertexCount(), cloth.hinges()) {
    matrix.set(cloth.hinges(), kStiffness);
    x = mesh.positions + 1e-2 * randomPositions(cloth.vertexCount(), 1);
  }
  static Material bending() {
    Material material;
    material.bending = kStiffness;
    return material;
  }
  /// Adds the matrix times `at` to `product` and returns the energy, J.
  double add(const Positions& at, Positions& product) const {
    double energy = 0.0;
    for (int i = 0; i < at.rows(); ++i) {
      Vec3 row = Vec3::Zero();
      matrix.addRow(i, at, row);
      energy += 0.5 * row.dot(at.row(i) - at.row(0));
      product.row(i) += row.transpose();
    }
    return energy;
  }
};

}  // namespace

TEST_CASE("the bending matrix's energy and product are the sums over hinges") {
  const Bent bent;
  Positions product = Positions::Ones(bent.x.rows(), 3), expected = product;  // not zero, because addRow() adds to it
  double energy = 0.0;
  for (const Hinge& hinge : bent.cloth.hinges()) {
    const double w = kStiffness * hinge.inverse_area;
    const Vec3 b = hingeVector(hinge, bent.x);
    energy += 0.5 * w * b.squaredNorm();
    for (int k = 0; k < 4; ++k) expected.row(hinge.vertices[k]) += w * hinge.stencil[k] * b.transpose();
  }
  REQUIRE(energy > 1e-3);
  CHECK(bent.add(bent.x, product) == Approx(energy).epsilon(1e-11));
  CHECK((product - expected).norm() < 1e-11 * expected.norm());
}

TEST_CASE("setting the bending matrix anew replaces its numbers") {
  Bent bent;
  Positions once = Positions::Zero(bent.x.rows(), 3), thrice = once;
  const double energy = bent.add(bent.x, once);
  bent.matrix.set(bent.cloth.hinges(), 3.0 * kStiffness);
  CHECK(bent.add(bent.x, thrice) == Approx(3.0 * energy).epsilon(1e-12));
  CHECK((thrice - 3.0 * once).norm() < 1e-12 * thrice.norm());
}

TEST_CASE("the diagonal of its row bounds is no less than the bending matrix") {
  const Bent bent;
  double least = 1.0;
  for (unsigned seed = 10; seed < 30; ++seed) {
    Positions d = randomPositions(static_cast<int>(bent.x.rows()), seed);
    // Rough displacements come nearest to the bound. Repeated multiplication by the matrix makes d rougher.
    for (int k = 0; k < 20; ++k) {
      Positions product = Positions::Zero(d.rows(), 3);
      const double energy = bent.add(d, product);
      double bound = 0.0;
      for (int i = 0; i < d.rows(); ++i) bound += 0.5 * bent.matrix.rowBound(i) * d.row(i).squaredNorm();
      CHECK(energy <= bound);
      least = std::min(least, 1.0 - energy / bound);
      d = product / product.norm();
    }
  }
  CHECK(least < 0.5);
}

TEST_CASE("what rounding may do to the energy is more than what a shift does to it, and little") {
  const Bent bent;
  Positions unused = Positions::Zero(bent.x.rows(), 3), shifted = bent.x;
  const double energy = bent.add(bent.x, unused), round_off = bent.matrix.roundOff(bent.x);
  for (const double shift :
       {0.25, 0.3, -0.7}) {  // stays within a metre of the origin, where positions have little round-off
    shifted = bent.x.array() + shift;
    CHECK(std::abs(bent.add(shifted, unused) - energy) < round_off);
  }
  CHECK(round_off < 1e-12 * energy);
}

TEST_CASE("cloth that does not bend has an empty matrix") {
  const BendingMatrix none(5, {});
  CHECK(none.empty());
  CHECK(none.rowBound(3) == 0.0);
  CHECK(none.roundOff(randomPositions(5, 1)) == 0.0);
  CHECK_FALSE(Bent().matrix.empty());
}

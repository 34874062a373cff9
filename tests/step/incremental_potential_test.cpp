#include "solver/step/incremental_potential.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/differences.h"
#include "tests/step/potential_scene.h"

using namespace ease;

namespace {

/// Gradient dE/dx at x and energy of a step from `start`, without gravity.
struct Forces {
  Positions gradient;
  double energy;

  Forces(const Cloth& cloth, const State& start, const Positions& x) : gradient(x.rows(), 3) {
    IncrementalPotential potential(cloth);
    StepOptions options;
    options.gravity.setZero();
    potential.begin(start, options);
    energy = potential.gradient(x, gradient);
  }
};

/// Rotates and shifts the positions.
Positions movedRigidly(const Positions& x) {
  const Mat3 R = Eigen::AngleAxisd(0.4, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  Positions moved = x * R.transpose();
  moved.rowwise() += Eigen::RowVector3d(0.3, 0.1, -0.2);
  return moved;
}

State atRest(const Positions& x) {
  return {x, Positions::Zero(x.rows(), 3)};
}

}  // namespace

TEST_CASE("the gradient of the potential is its derivative, term by term and with all") {
  for (const Term& term : terms())
    for (const double scale : {1.0, 0.6}) {
      INFO(term.name << " at " << scale);
      PotentialScene scene(term.material, term.touches);
      const Positions x = scale * scene.x;
      Positions gradient(x.rows(), 3), unused(x.rows(), 3);
      scene.potential.gradient(x, gradient);
      REQUIRE(gradient.norm() > 1e-4);
      for (unsigned seed = 10; seed < 14; ++seed) {
        const Positions d = randomPositions(static_cast<int>(x.rows()), seed);
        const auto energy = [&](double e) { return scene.potential.gradient(x + e * d, unused); };
        CHECK(sharpDifference(energy, 1e-5) == Approx(gradient.cwiseProduct(d).sum()).epsilon(1e-8));
      }
    }
}

TEST_CASE("central differences of the whole potential err by the square of their step") {
  PotentialScene scene;
  Positions gradient(scene.x.rows(), 3), unused(scene.x.rows(), 3);
  scene.potential.gradient(scene.x, gradient);
  const Positions d = randomPositions(static_cast<int>(scene.x.rows()), 10);
  const auto energy = [&](double e) { return scene.potential.gradient(scene.x + e * d, unused); };
  CHECK(orderOfDifference(energy, gradient.cwiseProduct(d).sum(), 1e-4) == Approx(2.0).margin(0.1));
}

TEST_CASE("a rigid motion changes no energy, and internal forces have no sum and no torque") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Material woven;
  woven.bending = 1e-3;
  Material sheared = woven, isotropic = woven;
  sheared.shear_form = ShearForm::bw98;
  isotropic.membrane = Membrane::isotropic;
  isotropic.lambda = 300.0;
  for (const Material& material : {woven, sheared, isotropic}) {
    const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
    const double force = 800.0 * 0.12, size = 0.12;  // N, m: what a stretch of 1 would take
    const Positions x = mesh.positions + 2e-3 * randomPositions(cloth.vertexCount(), 1), moved = movedRigidly(x);
    const Forces before(cloth, atRest(x), x), after(cloth, atRest(moved), moved);
    REQUIRE(before.gradient.norm() > 0.01 * force);
    CHECK(std::abs(after.energy - before.energy) < 1e-12 * force * size);
    CHECK(after.gradient.colwise().sum().norm() < 1e-12 * force);
    Vec3 torque = Vec3::Zero();
    for (int i = 0; i < moved.rows(); ++i) torque += Vec3(moved.row(i)).cross(Vec3(after.gradient.row(i)));
    CHECK(torque.norm() < 1e-12 * force * size);
  }
}

TEST_CASE("a rigid motion meets no force: no membrane, no bending, no damping") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), everyTerm());
  const double force = 800.0 * 0.12, size = 0.12;  // N, m: what a stretch of 1 would take
  const StepOptions options;
  // The sheet is bent before the motion, so that the test includes bending forces.
  Positions bent = mesh.positions;
  for (int i = 0; i < bent.rows(); ++i) bent(i, 2) = 3.0 * bent(i, 0) * bent(i, 0);
  const Positions moved = movedRigidly(bent), origin = movedRigidly(Positions::Zero(1, 3));
  const Mat3 R = (movedRigidly(Mat3::Identity()).rowwise() - origin.row(0)).transpose();

  // With these velocities the moved positions equal the inertial ones, so inertia adds no force.
  const Forces before(cloth, atRest(bent), bent), after(cloth, {bent, (moved - bent) / options.h}, moved);
  REQUIRE(before.gradient.norm() > 1e-3);
  CHECK((after.gradient - before.gradient * R.transpose()).norm() < 1e-12 * force);
  CHECK(after.gradient.colwise().sum().norm() < 1e-12 * force);
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < moved.rows(); ++i) torque += Vec3(moved.row(i)).cross(Vec3(after.gradient.row(i)));
  CHECK(torque.norm() < 1e-12 * force * size);
}

TEST_CASE("damping alone meets no rigid motion, and any other") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  for (const Term& term : terms()) {
    if (!term.name.starts_with("damping")) continue;
    INFO(term.name);
    const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), term.material);
    const Positions x = mesh.positions + 2e-3 * randomPositions(cloth.vertexCount(), 1), moved = movedRigidly(x);
    const Positions disturbed = moved + 2e-3 * randomPositions(cloth.vertexCount(), 2);
    const double h = StepOptions().h;
    const double force = Forces(cloth, {x, (disturbed - x) / h}, disturbed).gradient.norm();
    REQUIRE(force > 1e-2);
    CHECK(Forces(cloth, {x, (moved - x) / h}, moved).gradient.norm() < 1e-12 * force);
  }
}

TEST_CASE("an affine map of an irregular sheet strains it evenly and leaves its inside without force") {
  const TriangleMesh mesh = makeSheet(7, 6, 0.3, 0.2, 0.3);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  IncrementalPotential potential(cloth);
  StepOptions options;
  options.gravity.setZero();
  Mat3 map;
  map << 1.1, 0.2, 0.0, 0.1, 0.9, 0.0, 0.3, 0.0, 1.0;
  const Positions x = mesh.positions * map.transpose();
  potential.begin({x, Positions::Zero(x.rows(), 3)}, options);
  Positions gradient(x.rows(), 3);
  potential.gradient(x, gradient);
  std::vector<char> boundary(x.rows(), 0);
  for (const std::vector<int>& loop : cloth.topology().boundary_loops)
    for (int v : loop) boundary[v] = 1;
  double inside = 0.0, outside = 0.0;
  for (int i = 0; i < x.rows(); ++i) (boundary[i] ? outside : inside) += gradient.row(i).norm();
  CHECK(outside > 1.0);
  CHECK(inside < 1e-12);
  for (int t = 0; t < cloth.triangleCount(); ++t)
    CHECK((cloth.deformation(x, t) - cloth.deformation(x, 0)).norm() < 1e-12);
}

TEST_CASE("contact pressure is stiffness times depth on an evenly pressed sheet") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  IncrementalPotential potential(cloth);
  StepOptions options;
  potential.begin({mesh.positions, Positions::Zero(mesh.positions.rows(), 3)}, options);
  const size_t samples = mesh.positions.rows() + cloth.topology().edges.size() + cloth.triangleCount();
  Contacts contacts;
  contacts.planes.assign(samples, ContactPlane{Vec3::UnitZ(), 1e-3});
  potential.setContacts(contacts);
  std::vector<double> pressure;
  potential.contactPressure(mesh.positions, pressure);
  for (double p : pressure)
    CHECK(p == Approx(contactPressure(1e-3, options.contact_stiffness, contacts.planes[0].give)).epsilon(1e-9));
}

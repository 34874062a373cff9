#include "solver/step/incremental_potential.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/step/potential_scene.h"

using namespace ease;

TEST_CASE("the gradient of the potential is its derivative, with every term") {
  PotentialScene scene;
  Positions gradient(scene.x.rows(), 3);
  scene.potential.gradient(scene.x, gradient);
  Positions unused(scene.x.rows(), 3);
  REQUIRE(gradient.norm() > 1.0);
  for (unsigned seed = 10; seed < 14; ++seed) {
    const Positions d = randomPositions(static_cast<int>(scene.x.rows()), seed);
    const double slope = gradient.cwiseProduct(d).sum();
    const double difference =
        centralDifference([&](double e) { return scene.potential.gradient(scene.x + e * d, unused); }, 1e-8);
    CHECK(difference == Approx(slope).epsilon(1e-5));
  }
}

TEST_CASE("a rigid motion meets no force: no membrane, no bending, no damping") {
  const TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Material material = everyTerm();
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  IncrementalPotential potential(cloth);
  StepOptions options;
  options.gravity.setZero();
  // Bent first, so that bending has something to turn.
  Positions bent = mesh.positions;
  for (int i = 0; i < bent.rows(); ++i) bent(i, 2) = 3.0 * bent(i, 0) * bent(i, 0);
  const Mat3 R = Eigen::AngleAxisd(0.4, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const Vec3 shift(0.3, 0.1, -0.2);
  Positions moved = bent * R.transpose();
  moved.rowwise() += shift.transpose();

  // Velocities such that the moved positions are exactly the inertial ones: whatever force is left is internal.
  const State start{bent, (moved - bent) / options.h};
  potential.begin(start, options);
  Positions after(moved.rows(), 3), before(moved.rows(), 3);
  potential.gradient(moved, after);

  const State at_rest{bent, Positions::Zero(bent.rows(), 3)};
  potential.begin(at_rest, options);
  potential.gradient(bent, before);
  REQUIRE(before.norm() > 1e-3);
  CHECK((after - before * R.transpose()).norm() < 1e-9 * before.norm());
  CHECK(after.colwise().sum().norm() < 1e-12);
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < moved.rows(); ++i) torque += Vec3(moved.row(i)).cross(Vec3(after.row(i)));
  CHECK(torque.norm() < 1e-12);
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

#include "solver/step/incremental_potential.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

Material everyTerm() {
  Material material;
  material.bending = 1e-3;
  material.damping_stretch = 2.0;
  material.damping_shear = 1.0;
  material.damping_bending = 1e-5;
  return material;
}

// A sheet in motion, stretched here and compressed there, with some samples in contact.
struct Scene {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Cloth cloth;
  IncrementalPotential potential;
  StepOptions options;
  Contacts contacts;
  Positions x;

  explicit Scene(const Material& material = everyTerm())
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

}  // namespace

TEST_CASE("the gradient of the potential is its derivative, with every term") {
  Scene scene;
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

TEST_CASE("the Hessian is the derivative of the gradient where nothing is compressed") {
  Material material = everyTerm();
  material.damping_stretch = material.damping_shear = 0.0;  // whose targets lie on either side of the lengths
  Scene scene(material);
  scene.x = 1.1 * scene.x;  // stretched everywhere by more than it is disturbed
  const Curvature kind = GENERATE(Curvature::exact, Curvature::projected);
  BlockMatrix hessian(scene.cloth.vertexCount(), scene.cloth.topology().edges);
  scene.potential.hessian(scene.x, kind, hessian);
  Positions product(scene.x.rows(), 3), up = product, down = product;
  for (unsigned seed = 10; seed < 13; ++seed) {
    const Positions d = randomPositions(static_cast<int>(scene.x.rows()), seed);
    hessian.multiply(d, product);
    scene.potential.addBending(d, product);
    scene.potential.gradient(scene.x + 1e-8 * d, up);
    scene.potential.gradient(scene.x - 1e-8 * d, down);
    const Positions exact = (up - down) / 2e-8;
    // Projected, the shear's negative part is left out: small here beside the whole, and what remains is never less.
    CHECK((product - exact).norm() < (kind == Curvature::exact ? 1e-5 : 0.02) * exact.norm());
    CHECK(product.cwiseProduct(d).sum() >= 0.999999 * exact.cwiseProduct(d).sum());
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

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/step/potential_scene.h"

using namespace ease;

namespace {

/// The whole second derivative at x, bending too, 3n x 3n, column by column.
Eigen::MatrixXd wholeHessian(PotentialScene& scene, const Positions& x, Curvature kind) {
  const int n = scene.cloth.vertexCount();
  BlockMatrix hessian(n, scene.cloth.topology().edges);
  scene.potential.hessian(x, kind, hessian);
  Eigen::MatrixXd whole(3 * n, 3 * n);
  Positions product(n, 3);
  for (int k = 0; k < 3 * n; ++k) {
    Positions d = Positions::Zero(n, 3);
    d.data()[k] = 1.0;
    hessian.multiply(d, product);
    scene.potential.addBending(d, product);
    whole.col(k) = Eigen::Map<const Eigen::VectorXd>(product.data(), 3 * n);
  }
  return whole;
}

double leastEigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

}  // namespace

TEST_CASE("the Hessian is the derivative of the gradient where nothing is compressed") {
  Material material = everyTerm();
  material.damping_stretch = material.damping_shear = 0.0;  // whose targets lie on either side of the lengths
  PotentialScene scene(material);
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

TEST_CASE(
    "the Hessian is symmetric; where cloth is compressed it is indefinite, and projected as positive as the masses") {
  PotentialScene scene;
  const Positions x = 0.6 * scene.x;
  const Eigen::MatrixXd exact = wholeHessian(scene, x, Curvature::exact);
  const Eigen::MatrixXd projected = wholeHessian(scene, x, Curvature::projected);
  CHECK((exact - exact.transpose()).norm() < 1e-13 * exact.norm());
  CHECK((projected - projected.transpose()).norm() < 1e-13 * projected.norm());
  const std::vector<double>& masses = scene.cloth.masses();
  const double inertia = *std::min_element(masses.begin(), masses.end()) / (scene.options.h * scene.options.h);
  REQUIRE(inertia > 1.0);
  CHECK(leastEigenvalue(exact) < -10.0 * inertia);
  CHECK(leastEigenvalue(projected) > 0.999 * inertia);
}

TEST_CASE("contact adds its stiffness to the Hessian along the normal alone, and to the samples' vertices alone") {
  PotentialScene scene;
  scene.potential.setContacts({});
  const Eigen::MatrixXd without = wholeHessian(scene, scene.x, Curvature::exact);
  const int n = scene.cloth.vertexCount(), edge = 7;
  const auto [a, b] = scene.cloth.topology().edges[edge].vertex;
  Contacts contacts;
  contacts.planes.resize(n + scene.cloth.topology().edges.size() + scene.cloth.triangleCount());
  const Vec3 normal = Vec3(0.1, 0.2, 1.0).normalized();
  ContactPlane& plane = contacts.planes[n + edge];
  plane.normal = normal;
  plane.offset = normal.dot(0.5 * (scene.x.row(a) + scene.x.row(b))) + 5e-4;  // half a millimetre deep
  scene.potential.setContacts(contacts);
  const Eigen::MatrixXd added = wholeHessian(scene, scene.x, Curvature::exact) - without;

  double area = 0.0;
  for (const int t : scene.cloth.topology().edges[edge].triangle)
    if (t >= 0) area += scene.cloth.restAreas()[t] / 9.0;
  const double stiffness = contactStiffness(5e-4, scene.options.contact_stiffness, plane.give);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (const int i : {a, b})
    for (const int j : {a, b})
      expected.block<3, 3>(3 * i, 3 * j) = area * stiffness / 4.0 * normal * normal.transpose();
  CHECK((added - expected).norm() < 1e-9 * expected.norm());
}

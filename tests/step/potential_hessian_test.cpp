#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/differences.h"
#include "tests/step/potential_scene.h"

using namespace ease;

namespace {

/// Hessian at x including bending as one dense matrix, 3n x 3n, computed column by column.
Eigen::MatrixXd wholeHessian(PotentialScene& scene, const Positions& x, HessianKind kind) {
  const int n = scene.cloth.vertexCount();
  BlockMatrix hessian(n, scene.cloth.topology().edges);
  scene.potential.hessian(x, kind, hessian);
  Eigen::MatrixXd whole(3 * n, 3 * n);
  Positions product(n, 3);
  for (int k = 0; k < 3 * n; ++k) {
    Positions d = Positions::Zero(n, 3);
    d.data()[k] = 1.0;
    hessian.multiply(d, product);
    scene.potential.addBendingProduct(d, product);
    whole.col(k) = Eigen::Map<const Eigen::VectorXd>(product.data(), 3 * n);
  }
  return whole;
}

/// Product of the Hessian at x, including bending, with d.
Positions timesHessian(PotentialScene& scene, const Positions& x, HessianKind kind, const Positions& d) {
  BlockMatrix hessian(scene.cloth.vertexCount(), scene.cloth.topology().edges);
  scene.potential.hessian(x, kind, hessian);
  Positions product(x.rows(), 3);
  hessian.multiply(d, product);
  scene.potential.addBendingProduct(d, product);
  return product;
}

Positions differenceOfGradient(PotentialScene& scene, const Positions& x, const Positions& d) {
  Positions gradient(x.rows(), 3);
  const auto at = [&](double e) {
    scene.potential.gradient(x + e * d, gradient);
    return gradient;
  };
  return sharpDifference(at, 1e-5);
}

double leastEigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

}  // namespace

TEST_CASE("the exact Hessian is the derivative of the gradient, term by term and with all") {
  for (const Term& term : terms())
    for (const double scale : {1.0, 0.6}) {
      INFO(term.name << " at " << scale);
      PotentialScene scene(term.material, term.touches);
      const Positions x = scale * scene.x, d = randomPositions(static_cast<int>(x.rows()), 10);
      const Positions expected = differenceOfGradient(scene, x, d);
      REQUIRE(expected.norm() > 1e-2);
      CHECK((timesHessian(scene, x, HessianKind::exact, d) - expected).norm() < 1e-8 * expected.norm());
    }
}

TEST_CASE("where nothing is compressed, projecting the Hessian leaves out a little of the shear alone") {
  Material material = everyTerm();
  material.damping_stretch = material.damping_shear = 0.0;  // damping can act as compression
  const bool sheared = GENERATE(false, true);
  if (!sheared) material.shear = material.damping_bending = 0.0;
  PotentialScene scene(material);
  const Positions x = 1.5 * scene.x;  // stretch exceeds the disturbance everywhere
  for (unsigned seed = 10; seed < 13; ++seed) {
    const Positions d = randomPositions(static_cast<int>(x.rows()), seed);
    const Positions expected = differenceOfGradient(scene, x, d),
                    product = timesHessian(scene, x, HessianKind::projected, d);
    CHECK((product - expected).norm() < (sheared ? 0.02 : 1e-8) * expected.norm());
    CHECK(product.cwiseProduct(d).sum() >= (1.0 - 1e-8) * expected.cwiseProduct(d).sum());
  }
}

TEST_CASE(
    "the Hessian is symmetric, where cloth is compressed it is indefinite, and projected as positive as the masses") {
  PotentialScene scene;
  const Positions x = 0.6 * scene.x;
  const Eigen::MatrixXd exact = wholeHessian(scene, x, HessianKind::exact);
  const Eigen::MatrixXd projected = wholeHessian(scene, x, HessianKind::projected);
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
  const Eigen::MatrixXd without = wholeHessian(scene, scene.x, HessianKind::exact);
  const int n = scene.cloth.vertexCount(), edge = 7;
  const auto [a, b] = scene.cloth.topology().edges[edge].vertex;
  Contacts contacts;
  contacts.planes.resize(n + scene.cloth.topology().edges.size() + scene.cloth.triangleCount());
  const Vec3 normal = Vec3(0.1, 0.2, 1.0).normalized();
  ContactPlane& plane = contacts.planes[n + edge];
  plane.normal = normal;
  plane.offset = normal.dot(0.5 * (scene.x.row(a) + scene.x.row(b))) + 5e-4;  // half a millimetre deep
  scene.potential.setContacts(contacts);
  const Eigen::MatrixXd added = wholeHessian(scene, scene.x, HessianKind::exact) - without;

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

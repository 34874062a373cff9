// Cloth whose membrane is stiffer in some triangles than in others.
#include <catch2/catch.hpp>
#include <limits>

#include "solver/base/error.h"
#include "solver/step/time_step.h"
#include "tests/differences.h"
#include "tests/step/potential_scene.h"

using namespace ease;

namespace {

/// Stiffness scales that alternate between soft and stiff from triangle to triangle.
std::vector<double> softAndStiff(int triangles) {
  std::vector<double> scale;
  for (int t = 0; t < triangles; ++t) scale.push_back(t % 3 == 0 ? 0.2 : 1.0 + 0.1 * (t % 7));
  return scale;
}

}  // namespace

TEST_CASE("with stiffness that differs by triangle, gradient and Hessian are still the energy's derivatives") {
  for (const Term& term : terms()) {
    INFO(term.name);
    PotentialScene scene(term.material, term.touches);
    const State start{scene.x, Positions::Zero(scene.x.rows(), 3)};
    scene.cloth.setStiffnessScale(softAndStiff(scene.cloth.triangleCount()));
    scene.potential.begin(start, scene.options);
    scene.potential.setContacts(scene.contacts);
    const int n = scene.cloth.vertexCount();
    const Positions x = scene.x + 2e-3 * randomPositions(n, 4), d = randomPositions(n, 10);
    Positions gradient(n, 3), unused(n, 3), product(n, 3);
    scene.potential.gradient(x, gradient);
    REQUIRE(gradient.norm() > 1e-5);
    const auto energy = [&](double e) { return scene.potential.gradient(x + e * d, unused); };
    CHECK(sharpDifference(energy, 1e-5) == Approx(gradient.cwiseProduct(d).sum()).epsilon(1e-7));

    BlockMatrix hessian(n, scene.cloth.topology().edges);
    scene.potential.hessian(x, HessianKind::exact, hessian);
    hessian.multiply(d, product);
    scene.potential.addBendingProduct(d, product);
    const auto gradientAt = [&](double e) {
      scene.potential.gradient(x + e * d, unused);
      return unused;
    };
    CHECK((sharpDifference(gradientAt, 1e-5) - product).norm() < 1e-7 * product.norm());
  }
}

TEST_CASE("a stiffness scale multiplies the membrane alone, in its triangles alone") {
  Material material;
  material.density = 1e-12;
  PotentialScene scene(material, false);
  const State still{scene.mesh.positions, Positions::Zero(scene.x.rows(), 3)};
  Positions gradient(scene.x.rows(), 3);
  const auto energyWith = [&](const std::vector<double>& scale) {
    scene.cloth.setStiffnessScale(scale);
    scene.potential.begin(still, scene.options);
    return scene.potential.gradient(scene.x, gradient);
  };
  const int m = scene.cloth.triangleCount();
  const double plain = energyWith({});
  CHECK(energyWith(std::vector<double>(m, 1.0)) == plain);
  CHECK(energyWith(std::vector<double>(m, 3.0)) == Approx(3.0 * plain).epsilon(1e-9));
  double sum = 0.0;
  for (int t = 0; t < m; ++t) {
    std::vector<double> twice(m, 1.0);
    twice[t] = 2.0;
    sum += energyWith(twice) - plain;
  }
  CHECK(sum == Approx(plain).epsilon(1e-6));
}

TEST_CASE("soft cloth sewn to stiff cloth stretches as springs in a row do, by every method") {
  const Method method = GENERATE(Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic);
  const TriangleMesh sheet = makeSheet(8, 2, 0.4, 0.1);
  Material material;
  material.stretch_weft = material.shear = 0.0;
  Cloth cloth(sheet, Vec3::UnitX(), material);
  std::vector<double> scale;
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    double x = 0.0;
    for (int a = 0; a < 3; ++a) x += sheet.positions(sheet.triangles(t, a), 0) / 3.0;
    scale.push_back(x < 0.2 ? 4.0 : 1.0);
  }
  cloth.setStiffnessScale(scale);
  TimeStep step(cloth, {method, 1e-9, 1e-9, 400}, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  State state{sheet.positions, Positions::Zero(sheet.positions.rows(), 3)};
  state.positions.col(0) *= 1.25;
  Pins pins;
  for (int i = 0; i < sheet.positions.rows(); ++i)
    if (const double x = sheet.positions(i, 0); x < 1e-9 || x > 0.4 - 1e-9) {
      pins.vertices.push_back(i);
      pins.positions.push_back(state.positions.row(i));
    }
  StepOptions options;
  options.h = 1.0;
  options.gravity.setZero();
  for (int k = 0; k < 30; ++k)
    step.step(state, options, pins, [](const Positions&, Contacts& contacts) { contacts.planes.clear(); });
  // Both halves carry equal tension, so the soft one takes 4/5 of the total elongation of 0.1 m.
  for (int i = 0; i < sheet.positions.rows(); ++i)
    if (std::abs(sheet.positions(i, 0) - 0.2) < 1e-9) CHECK(state.positions(i, 0) == Approx(0.22).margin(1e-5));
}

TEST_CASE("a stiffness scale that cannot be is refused") {
  Cloth cloth(makeSheet(2, 2, 0.1, 0.1), Vec3::UnitX(), Material());
  CHECK_THROWS_AS(cloth.setStiffnessScale({1.0, 2.0}), InputError);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> scale(cloth.triangleCount(), 1.0);
    scale[5] = wrong;
    CHECK_THROWS_WITH(cloth.setStiffnessScale(scale), Catch::Contains("stiffness scale of triangle 5"));
  }
}

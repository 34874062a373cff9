#include "solver/step/projective.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

Material exactCloth() {
  Material material;
  material.stretch_warp = 300.0;
  material.stretch_weft = 500.0;
  material.shear = 120.0;
  return material;
}

struct Step {
  TriangleMesh mesh = makeSheet(7, 6, 0.2, 0.2, 0.2);
  Cloth cloth;
  std::vector<int> ordering;
  std::vector<char> fixed;
  IncrementalPotential potential;
  State state;
  Point point;
  explicit Step(const Material& material)
      : cloth(mesh, Vec3(0.2, -1.0, 0.0), material),
        ordering(systemOrdering(cloth.vertexCount(), cloth.triangles())),
        fixed(cloth.vertexCount(), 0),
        potential(cloth) {
    state = {1.08 * mesh.positions + 2e-3 * randomPositions(cloth.vertexCount(), 4),
             0.3 * randomPositions(cloth.vertexCount(), 5)};
    fixed[0] = fixed[7] = 1;
    potential.begin(state, {});
    point.x = state.positions;
    point.evaluate(potential, fixed);
  }
};

/// Nearest matrix whose columns have length 1.
Mat32 unitColumns(const Mat32& F) {
  return F.colwise().normalized();
}
/// Nearest matrix with orthogonal columns.
Mat32 orthogonalColumns(const Mat32& F) {
  const double A = F.squaredNorm(), D = F.col(0).dot(F.col(1));
  const double l = (A - std::sqrt(A * A - 4.0 * D * D)) / (2.0 * D);
  Mat32 P;
  P.col(0) = (F.col(0) - l * F.col(1)) / (1.0 - l * l);
  P.col(1) = (F.col(1) - l * F.col(0)) / (1.0 - l * l);
  return P;
}

}  // namespace

TEST_CASE("one iteration is a local projection and a global solve, written out") {
  const Material material = exactCloth();
  Step s(material);
  std::fill(s.fixed.begin(), s.fixed.end(), 0);
  s.point.evaluate(s.potential, s.fixed);
  const StepOptions options;

  // The global step solves a GradientSystem. The weights along warp and weft are put into the columns of D^-1 and of
  // the targets.
  const Eigen::Vector2d weights =
      Eigen::Vector2d(material.stretch_warp, material.stretch_weft).array() + 2.0 * material.shear;
  GradientSystem system(s.cloth.vertexCount(), s.cloth.triangles(), s.ordering);
  std::vector<Mat2> inverse;
  std::vector<Mat32> targets;
  std::vector<double> diagonal;
  for (int t = 0; t < s.cloth.triangleCount(); ++t) {
    inverse.push_back(s.cloth.restInverse()[t] * weights.cwiseSqrt().asDiagonal());
    const Mat32 F = s.cloth.deformation(s.point.x, t);
    Mat32 sum = 2.0 * material.shear * orthogonalColumns(F);
    sum += unitColumns(F) * Eigen::Vector2d(material.stretch_warp, material.stretch_weft).asDiagonal();
    targets.push_back(sum * weights.cwiseSqrt().cwiseInverse().asDiagonal());
  }
  for (double mass : s.cloth.masses()) diagonal.push_back(mass / (options.h * options.h));
  REQUIRE(system.factor(inverse, s.cloth.restAreas(), diagonal));
  Positions inertial = s.state.positions + options.h * s.state.velocities;
  inertial.rowwise() += options.h * options.h * options.gravity.transpose();
  Positions expected;
  system.solve(targets, inertial, expected);

  Projective projective(s.cloth, s.ordering);
  projective.minimise(s.potential, s.fixed, {1}, false, s.point);
  REQUIRE((expected - s.state.positions).norm() > 1e-3);
  CHECK((s.point.x - expected).norm() < 1e-5 * (expected - s.state.positions).norm());
}

TEST_CASE("every projective iteration lowers the potential, and acceleration needs fewer") {
  Step plain(exactCloth()), accelerated(exactCloth());
  Projective a(plain.cloth, plain.ordering), b(accelerated.cloth, accelerated.ordering);
  double last = plain.point.energy;
  for (int k = 0; k < 30; ++k) {
    a.minimise(plain.potential, plain.fixed, {1}, false, plain.point);
    CHECK(plain.point.energy <= last);
    last = plain.point.energy;
  }
  const MinimiserSummary summary = b.minimise(accelerated.potential, accelerated.fixed, {30}, true, accelerated.point);
  CHECK(summary.iterations <= 30);
  CHECK(residualAcceleration(accelerated.potential, accelerated.point) <
        0.2 * residualAcceleration(plain.potential, plain.point));
}

TEST_CASE("the matrix is factored once, and again when rest shape, time step, damping or pins change") {
  Step s(exactCloth());
  Projective projective(s.cloth, s.ordering);
  const auto factors = [&] { return projective.minimise(s.potential, s.fixed, {2}, true, s.point).factorisations; };
  CHECK(factors() == 1);
  CHECK(factors() == 0);
  s.fixed[3] = 1;
  CHECK(factors() == 1);
  CHECK(factors() == 0);
  s.potential.begin(s.state, {0.005});
  CHECK(factors() == 1);
  s.cloth.setRest(s.cloth.rest());
  s.potential.begin(s.state, {0.005});
  CHECK(factors() == 1);
  CHECK(factors() == 0);
}

TEST_CASE("the relative error asked for is reached, as a converged reference sees it") {
  Step s(exactCloth());
  const std::vector<char> fixed = s.fixed;
  Point reference = s.point;
  Projective to_the_end(s.cloth, s.ordering);
  REQUIRE(to_the_end.minimise(s.potential, fixed, {2000, 1e-9}, true, reference).converged);
  const auto norm = [&](const Positions& d) {
    double sum = 0.0;
    for (int i = 0; i < d.rows(); ++i) sum += s.cloth.masses()[i] * d.row(i).squaredNorm();
    return std::sqrt(sum);
  };
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    Point point = s.point;
    Projective projective(s.cloth, s.ordering);
    CHECK(projective.minimise(s.potential, fixed, {2000, tolerance}, true, point).converged);
    CHECK(norm(point.x - reference.x) < tolerance * norm(reference.x - s.state.positions));
  }
}

TEST_CASE("a search that gets nowhere soon enough is given up") {
  Material stiff = exactCloth();
  stiff.stretch_warp = stiff.stretch_weft = 1e6;
  Step s(stiff);
  Projective projective(s.cloth, s.ordering);
  const MinimiserSummary summary = projective.minimise(s.potential, s.fixed, {2000, 1e-6, 0.0, 20}, true, s.point);
  CHECK_FALSE(summary.converged);
  CHECK(summary.iterations < 200);
}

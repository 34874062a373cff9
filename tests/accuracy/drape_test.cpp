// A square of cloth held at two corners, at rest: the scene `drape-2pin`, on which independent implicit codes agree.
#include <catch2/catch.hpp>

#include "adaption/stretch_measure.h"
#include "tests/accuracy/equilibrium.h"

using namespace ease;

namespace {

// N x N vertices over 1 m x 1 m in the xz plane, id = i N + j at x = j/(N-1), z = i/(N-1); faces down.
TriangleMesh drapeMesh(int N) {
  TriangleMesh mesh;
  mesh.positions.resize(N * N, 3);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) mesh.positions.row(i * N + j) << j / (N - 1.0), 0.0, i / (N - 1.0);
  mesh.triangles.resize(2 * (N - 1) * (N - 1), 3);
  int t = 0;
  for (int i = 0; i + 1 < N; ++i)
    for (int j = 0; j + 1 < N; ++j) {
      const int a = i * N + j, b = a + 1, c = a + N, d = c + 1, h = i % 2 == j % 2 ? 1 : 0;
      mesh.triangles.row(t++) << a, b, c + h;
      mesh.triangles.row(t++) << d, c, b - h;
    }
  return mesh;
}

}  // namespace

TEST_CASE("a square held at two corners comes to the rest that other codes find") {
  const Method method = GENERATE(Method::newton, Method::automatic);
  const int N = 32;
  const TriangleMesh mesh = drapeMesh(N);
  Material material;
  material.density = 0.2;
  material.membrane = Membrane::isotropic;
  material.mu = 500.0;      // (k/2) |F - R|^2 with k = 1000 N/m
  material.bending = 3e-5;  // 1e-5 N m in the usual hinge form, which counts threefold
  const Cloth cloth(mesh, Vec3::UnitX(), material);
  State state = atRest(mesh.positions);
  const Pins pins{{0, N - 1}, {mesh.positions.row(0), mesh.positions.row(N - 1)}};
  TimeStep step = makeStep(cloth, {method, 1e-2, 1e-2});
  REQUIRE(settle(step, state, {{0.3}, pins, 1e-5}));
  std::vector<Stretch> stretch;
  measureStretch(cloth, state.positions, stretch);
  double mean = 0.0;
  for (const Stretch& s : stretch) mean += s.sigma_1 / stretch.size();  // equal rest areas
  const double sag = -state.positions(N / 2 * N + N / 2, 1);
  CHECK(mean == Approx(1.0016).margin(1e-4));
  CHECK(sag == Approx(0.5211).epsilon(1e-3));
  CHECK(stretchStatistics(firstStretches(stretch), 0.1).p99 == Approx(1.012).epsilon(1e-3));
}

// A strip hung from both ends takes the shape of the elastic catenary.
//
//   S   rest length from the left end, m     W  weight, N     V = W/2, H  vertical and horizontal force at the ends, N
//   K   stiffness, N: tension = K (stretch - 1)
//
//   x(S) = H S/K + H L/W [asinh(V/H) - asinh((V - W S/L)/H)]
//   z(S) = -S/K (V - W S/(2L)) - H L/W [sqrt(1 + (V/H)^2) - sqrt(1 + ((V - W S/L)/H)^2)]
//
// Irvine, Cable Structures, 1981, section 1.3.
#include <catch2/catch.hpp>

#include "tests/accuracy/equilibrium.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

struct Catenary {
  double L, W, K, H;
  double x(double S) const { return H * S / K + H * L / W * (std::asinh(0.5 * W / H) - std::asinh(slope(S))); }
  double z(double S) const {
    return -S / K * (0.5 * W - 0.5 * W * S / L) -
           H * L / W * (std::hypot(1.0, 0.5 * W / H) - std::hypot(1.0, slope(S)));
  }
  double slope(double S) const { return (0.5 * W - W * S / L) / H; }
};

// That whose ends are `span` apart, by bisection for H.
Catenary catenary(double L, double W, double K, double span) {
  double low = 1e-6 * W, high = 1e3 * W;
  for (int n = 0; n < 100; ++n) {
    const double H = std::sqrt(low * high);
    (Catenary{L, W, K, H}.x(L) < span ? low : high) = H;
  }
  return {L, W, K, low};
}

// Half the angle of the arc of a circle whose length is `ratio` times its chord.
double halfAngle(double ratio) {
  double low = 1e-3, high = M_PI;
  for (int n = 0; n < 60; ++n) {
    const double angle = 0.5 * (low + high);
    (angle / std::sin(angle) < ratio ? low : high) = angle;
  }
  return low;
}

}  // namespace

TEST_CASE("a strip hung from both ends is an elastic catenary") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const double length = 1.0, width = 0.04, span = 0.7;
  const TriangleMesh mesh = makeSheet(64, 2, length, width);
  Material material;
  material.stretch_warp = material.stretch_weft = 200.0;
  const Cloth cloth(mesh, Vec3::UnitX(), material);
  const Catenary exact =
      catenary(length, material.density * 9.81 * length * width, material.stretch_warp * width, span);
  REQUIRE(exact.x(length) == Approx(span).epsilon(1e-9));

  State state = atRest(mesh.positions);  // on an arc: across in y, down in z
  const double half = halfAngle(length / span);
  const double radius = 0.5 * length / half;
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const double angle = half * (2.0 * mesh.positions(i, 0) / length - 1.0);
    state.positions(i, 0) = 0.5 * span + radius * std::sin(angle);
    state.positions(i, 2) = radius * (std::cos(half) - std::cos(angle));
  }
  const Pins pins = pinsWhere(
      state.positions, [&](int i) { return mesh.positions(i, 0) < 1e-9 || mesh.positions(i, 0) > length - 1e-9; });
  TimeStep step = makeStep(cloth, {method, 1e-6, 1e-6});
  REQUIRE(settle(step, state, {{1.0, {0.0, 0.0, -9.81}}, pins, 1e-6}));
  const double sag = -exact.z(0.5 * length);
  REQUIRE(sag > 0.3);
  double error = 0.0;
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const double S = mesh.positions(i, 0);
    error =
        std::max({error, std::abs(state.positions(i, 0) - exact.x(S)), std::abs(state.positions(i, 2) - exact.z(S))});
  }
  INFO("relative error " << error / sag);
  CHECK(error < 1e-3 * sag);
}

#include "solver/energy/contact.h"

#include <catch2/catch.hpp>

#include "tests/differences.h"

using namespace ease;

TEST_CASE("contact pressure and stiffness are derivatives of the contact energy") {
  const double k = 3e6, l = 2e-3;
  for (const double depth : {1e-4, 2e-3, 7e-3}) {
    const auto energy = [&](double e) { return contactEnergy(depth + e, k, l); };
    const auto pressure = [&](double e) { return contactPressure(depth + e, k, l); };
    REQUIRE(contactPressure(depth, k, l) > 0.0);
    CHECK(sharpDifference(energy, 0.1 * depth) == Approx(contactPressure(depth, k, l)).epsilon(1e-10));
    CHECK(sharpDifference(pressure, 0.1 * depth) == Approx(contactStiffness(depth, k, l)).epsilon(1e-10));
    CHECK(orderOfDifference(energy, contactPressure(depth, k, l), 0.5 * depth) == Approx(2.0).margin(0.1));
    CHECK(orderOfDifference(pressure, contactStiffness(depth, k, l), 0.5 * depth) == Approx(2.0).margin(0.1));
  }
}

TEST_CASE("at the depth that the cloth may give, the pressure is three times that of a linear spring") {
  const double k = 3e6, l = 2e-3;
  CHECK(contactPressure(l, k, l) == Approx(3.0 * k * l));
  CHECK(contactPressure(1e-6, k, l) == Approx(k * 1e-6).epsilon(1e-5));
}

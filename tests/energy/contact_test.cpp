#include "solver/energy/contact.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

TEST_CASE("contact pressure and stiffness are derivatives of the contact energy") {
  const ContactSpring spring{3e6, 2e-3};
  for (const double depth : {1e-4, 2e-3, 7e-3}) {
    const auto energy = [&](double e) { return contactEnergy(depth + e, spring); };
    const auto pressure = [&](double e) { return contactPressure(depth + e, spring); };
    REQUIRE(contactPressure(depth, spring) > 0.0);
    CHECK(centralDifference(energy, 1e-7) == Approx(contactPressure(depth, spring)).epsilon(1e-6));
    CHECK(centralDifference(pressure, 1e-7) == Approx(contactStiffness(depth, spring)).epsilon(1e-6));
  }
}

TEST_CASE("at the depth that the cloth may give, the pressure is three times that of a linear spring") {
  const ContactSpring spring{3e6, 2e-3};
  CHECK(contactPressure(spring.l, spring) == Approx(3.0 * spring.k * spring.l));
  CHECK(contactPressure(1e-6, spring) == Approx(spring.k * 1e-6).epsilon(1e-5));
}

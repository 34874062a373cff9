#include "solver/energy/contact.h"

namespace ease {

double contactEnergy(double depth, const ContactSpring& spring) {
  const double r = depth / spring.l;
  return 0.5 * spring.k * depth * depth * (1.0 + r * r);
}

double contactPressure(double depth, const ContactSpring& spring) {
  const double r = depth / spring.l;
  return spring.k * depth * (1.0 + 2.0 * r * r);
}

double contactStiffness(double depth, const ContactSpring& spring) {
  const double r = depth / spring.l;
  return spring.k * (1.0 + 6.0 * r * r);
}

}  // namespace ease

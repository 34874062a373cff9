#include "solver/step/method.h"

#include <algorithm>
#include <stdexcept>

namespace ease {

const std::vector<std::string>& methodNames() {
  static const std::vector<std::string> names = {"bw1", "newton", "pd", "pd-lbfgs", "auto"};  // in the enum's order
  return names;
}

const std::string& nameOf(Method method) {
  return methodNames()[static_cast<size_t>(method)];
}

Method methodNamed(const std::string& name) {
  const auto found = std::find(methodNames().begin(), methodNames().end(), name);
  if (found == methodNames().end()) throw std::out_of_range(name);
  return static_cast<Method>(found - methodNames().begin());
}

StepSummary& StepSummary::operator+=(const StepSummary& other) {
  newton_iterations += other.newton_iterations;
  projective_iterations += other.projective_iterations;
  cg_iterations += other.cg_iterations;
  factorisations += other.factorisations;
  halvings += other.halvings;
  contact_rounds += other.contact_rounds;
  kept_planes += other.kept_planes;
  handed_over += other.handed_over;
  short_of_tolerance += other.short_of_tolerance;
  return *this;
}

}  // namespace ease

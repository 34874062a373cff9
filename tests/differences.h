// Derivatives by central differences: sharp ones, and how fast the error of plain ones falls.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "tests/accuracy/convergence.h"

namespace ease {

/// Central difference at 0 of a function of a number; its value is a number or a plain matrix.
template <class Function>
auto difference(const Function& f, double step) {
  using Value = std::decay_t<decltype(f(step))>;
  return Value((f(step) - f(-step)) / (2.0 * step));
}

/// Romberg's extrapolation of central differences over `step`, a half and a quarter of it: it cancels the errors of
/// second and fourth order in the step, and leaves one of sixth order.
template <class Function>
auto sharpDifference(const Function& f, double step) {
  const auto whole = difference(f, step), half = difference(f, 0.5 * step), quarter = difference(f, 0.25 * step);
  using Value = std::decay_t<decltype(whole)>;
  const Value coarse = (4.0 * half - whole) / 3.0, fine = (4.0 * quarter - half) / 3.0;
  return Value((16.0 * fine - coarse) / 15.0);
}

/// Power of the step with which the error of a central difference falls, from `step` down to an eighth of it.
template <class Function, class Value>
double orderOfDifference(const Function& f, const Value& exact, double step) {
  std::vector<double> steps, errors;
  for (const double part : {1.0, 0.5, 0.25, 0.125}) {
    const Value error = difference(f, part * step) - exact;
    steps.push_back(part * step);
    if constexpr (std::is_same_v<Value, double>)
      errors.push_back(std::abs(error));
    else
      errors.push_back(error.norm());
  }
  return fittedOrder(steps, errors);
}

}  // namespace ease

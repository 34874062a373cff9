#include "bench/step_error.h"

#include <cmath>

#include "adaption/stretch_measure.h"

namespace ease {

namespace {

const MethodOptions kOnTheWay{Method::automatic, 0.01, 0.0, 0};

StretchStatistics stretchAt(const Cloth& cloth, const Positions& x) {
  std::vector<Stretch> stretch;
  measureStretch(cloth, x, stretch);
  return stretchStatistics(firstStretches(stretch), 0.0);
}

}  // namespace

double massNorm(const Cloth& cloth, const Positions& d) {
  double sum = 0.0;
  for (int i = 0; i < d.rows(); ++i) sum += cloth.masses()[i] * d.row(i).squaredNorm();
  return std::sqrt(sum);
}

ReferenceSolver::ReferenceSolver(const Sheet& sheet, double residual)
    : sheet_(sheet), newton_(sheet.cloth, {Method::newton, 0.0, residual, 0}, sheet.ordering) {}

void ReferenceSolver::findMinimum(double h, ReferenceStep& step) {
  State state = step.start;
  advance(sheet_, newton_, step.time, h, state);
  step.minimum = state.positions;
}

std::vector<ReferenceStep> referenceSteps(const Sheet& sheet, double h, double from_time, int count) {
  TimeStep on_the_way(sheet.cloth, kOnTheWay, sheet.ordering);
  ReferenceSolver reference(sheet);
  State state = sheet.start;
  const int before = static_cast<int>(std::lround(from_time / h));
  for (int n = 0; n < before; ++n) advance(sheet, on_the_way, n * h, h, state);
  std::vector<ReferenceStep> steps;
  for (int n = before; n < before + count; ++n) {
    ReferenceStep step{n * h, state, {}};
    reference.findMinimum(h, step);
    state = {step.minimum, (step.minimum - step.start.positions) / h};
    steps.push_back(std::move(step));
  }
  return steps;
}

StepError StepJudge::judge(const ReferenceStep& step, double h, const Positions& x) {
  const Cloth& cloth = sheet_.cloth;
  StepOptions options;
  options.h = h;
  potential_.begin(step.start, options);
  Pins pins;
  sheet_.hold(step.time + h, pins);
  std::vector<char> fixed(cloth.vertexCount(), 0);
  Point here, guess, minimum;
  here.x = x;
  guess.x = step.start.positions + h * step.start.velocities;
  minimum.x = step.minimum;
  for (size_t k = 0; k < pins.vertices.size(); ++k) {
    fixed[pins.vertices[k]] = 1;
    guess.x.row(pins.vertices[k]) = pins.positions[k];
  }
  for (Point* point : {&here, &guess, &minimum}) point->evaluate(potential_, fixed);

  const Positions off = x - minimum.x;
  const StretchStatistics stretch = stretchAt(cloth, x), exact = stretchAt(cloth, minimum.x);
  return {relativeLength(potential_, minimum, off),
          massNorm(cloth, off) / massNorm(cloth, minimum.x - guess.x),
          (here.energy - minimum.energy) / (guess.energy - minimum.energy),
          1e3 * off.rowwise().norm().maxCoeff(),
          residualAcceleration(potential_, here),
          std::abs(stretch.max - exact.max),
          std::abs(stretch.p99 - exact.p99)};
}

}  // namespace ease

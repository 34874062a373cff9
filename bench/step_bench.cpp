// Time of the parts of a step against the number of vertices: gradient (local step), global solve, and one iteration of
// each method.  The scene is a square sheet that hangs by two corners without contact and is stretched by a tenth at
// first.
//
//   step_bench [--benchmark_filter=...]
//
// Each case checks its result and fails if it is wrong: a solve must solve its system, and an iteration must lower the
// potential.
#include <benchmark/benchmark.h>

#include "solver/linear/dot.h"
#include "solver/step/time_step.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

struct Sheet {
  TriangleMesh mesh;
  Cloth cloth;
  std::vector<int> ordering;
  std::vector<char> fixed;
  State state;
  StepOptions options;
  IncrementalPotential potential;
  Point point;

  static TriangleMesh square(int vertices) {
    const int side = static_cast<int>(std::lround(std::sqrt(vertices))) - 1;
    return makeSheet(side, side, 1.0, 1.0);
  }
  static Material material(bool bends) {
    Material m;
    m.density = 0.2;
    m.stretch_warp = m.stretch_weft = 800.0;
    m.shear = 200.0;
    m.bending = bends ? 1e-6 : 0.0;
    return m;
  }
  explicit Sheet(int vertices, bool bends = true)
      : mesh(square(vertices)),
        cloth(mesh, Vec3(0.0, -1.0, 0.0), material(bends)),
        ordering(systemOrdering(cloth.vertexCount(), cloth.triangles())),
        fixed(cloth.vertexCount(), 0),
        state{1.1 * mesh.positions + 1e-3 / std::sqrt(vertices) * randomPositions(cloth.vertexCount(), 1),
              Positions::Zero(cloth.vertexCount(), 3)},
        potential(cloth) {
    fixed.front() = fixed.back() = 1;
    begin();
  }
  void begin() {
    potential.begin(state, options);
    point.x = state.positions;
    point.evaluate(potential, fixed);
  }
};

void sizes(benchmark::internal::Benchmark* b) {
  for (int n : {1000, 4000, 10000, 100000}) b->Arg(n);
  b->Unit(benchmark::kMillisecond)->UseRealTime();
}

void gradient(benchmark::State& state) {
  Sheet sheet(static_cast<int>(state.range(0)));
  for (auto _ : state) sheet.point.evaluate(sheet.potential, sheet.fixed);
  state.counters["ns_per_triangle"] =
      benchmark::Counter(static_cast<double>(sheet.cloth.triangleCount()) * state.iterations() * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  // The gradient must agree with finite differences of the potential.
  const Positions d = randomPositions(sheet.cloth.vertexCount(), 5);
  Point up = sheet.point, down = sheet.point;
  up.x += 1e-7 * d, down.x -= 1e-7 * d;
  const std::vector<char> none(sheet.fixed.size(), 0);
  up.evaluate(sheet.potential, none), down.evaluate(sheet.potential, none);
  Point here = sheet.point;
  here.evaluate(sheet.potential, none);
  const double slope = dot(here.gradient, d);
  if (std::abs((up.energy - down.energy) / 2e-7 - slope) > 1e-4 * std::abs(slope))
    state.SkipWithError("wrong gradient");
}
BENCHMARK(gradient)->Apply(sizes);

GradientSystem projectiveSystem(Sheet& sheet) {
  GradientSystem system(sheet.cloth.vertexCount(), sheet.cloth.triangles(), sheet.ordering,
                        Cholesky::Kind::kSupernodal);
  std::vector<double> diagonal(sheet.cloth.vertexCount());
  for (int i = 0; i < sheet.cloth.vertexCount(); ++i)
    diagonal[i] = sheet.cloth.masses()[i] / (sheet.options.h * sheet.options.h);
  if (!system.factor(sheet.cloth.restInverse(), sheet.cloth.restAreas(), diagonal)) std::abort();
  return system;
}

void globalSolve(benchmark::State& state) {
  Sheet sheet(static_cast<int>(state.range(0)));
  GradientSystem system = projectiveSystem(sheet);
  const Positions right = randomPositions(sheet.cloth.vertexCount(), 3);
  Positions x(right.rows(), 3);
  for (auto _ : state) system.solveRounded(right, x);
  Positions twice = 2.0 * right, x2(right.rows(), 3);
  system.solveRounded(twice, x2);
  if (!((x2 - 2.0 * x).norm() < 1e-5 * x.norm() && x.norm() > 0.0)) state.SkipWithError("wrong solution");
}
BENCHMARK(globalSolve)->Apply(sizes);

/// Measures iterations of a method, always from the start of a step.  `iterate` does `per_run` iterations.
template <class Iterate>
void iterations(benchmark::State& state, int per_run, const Iterate& iterate) {
  Sheet sheet(static_cast<int>(state.range(0)));
  const Point start = sheet.point;
  iterate(sheet);  // makes the factors, which is not timed
  for (auto _ : state) {
    sheet.point = start;
    iterate(sheet);
  }
  state.counters["ms_per_iteration"] = benchmark::Counter(1e-3 * per_run * state.iterations(),
                                                          benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  if (!(sheet.point.energy < start.energy)) state.SkipWithError("the potential did not fall");
}

template <bool Accelerated>
void projectiveIterations(benchmark::State& state) {
  std::unique_ptr<Projective> projective;
  iterations(state, 10, [&](Sheet& sheet) {
    if (!projective) projective = std::make_unique<Projective>(sheet.cloth, sheet.ordering);
    projective->minimise(sheet.potential, sheet.fixed, {10}, Accelerated, sheet.point);
  });
}
BENCHMARK(projectiveIterations<false>)->Apply(sizes)->Name("pd_iterations");
BENCHMARK(projectiveIterations<true>)->Apply(sizes)->Name("pd_lbfgs_iterations");

void newtonIteration(benchmark::State& state) {
  std::unique_ptr<Newton> newton;
  iterations(state, 1, [&](Sheet& sheet) {
    if (!newton) newton = std::make_unique<Newton>(sheet.cloth, sheet.ordering);
    newton->minimise(sheet.potential, sheet.fixed, {1}, sheet.point);
  });
}
BENCHMARK(newtonIteration)->Apply(sizes)->Name("newton_iteration");

}  // namespace

BENCHMARK_MAIN();

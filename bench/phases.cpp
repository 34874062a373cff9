// The time of each phase of a step, compared with a lower bound that the machine sets.
//
//   phases [--quick] [options of Google Benchmark]
//
//   local      energy and gradient of a step (the local step of projective dynamics, the residual of Newton)
//   membrane   energy and gradient of a step without bending
//   hessian    assembly of Newton's matrix
//   product    Newton's matrix times a vector, bending included: a conjugate gradient iteration without preconditioner
//   factor1    Cholesky factorisation of the projective system, n x n
//   solve1     solve with this factor, 3 right-hand sides
//   factor3    Cholesky factorisation of Newton's system, 3n x 3n
//   solve3     solve with this factor, 1 right-hand side
//   level-set  level set of a pose around a garment of n vertices: a sleeve 5 mm away from a limb of 36,000 triangles
//   contacts   contact planes of that sleeve's samples, looked up in the level set
//
// bound_ms is the lower bound.  For local, product, contacts and solves: memory that must be read / measured bandwidth.
// The memory is that of triangles, matrices and factors; vectors, a twentieth of it, are assumed to stay in a cache.
// The bandwidth is measured with all threads by reading as much memory repeatedly, so that caches have the same effect.
// For factors: floating-point operations / measured peak of one thread, since CHOLMOD uses one thread.
//
// The cloth is the hanging sheet of sheets.h with k = 500 N/m and h = 1/60 s.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

#include "bench/machine_bounds.h"
#include "bench/program.h"
#include "bench/sheets.h"
#include "collision/contacts.h"
#include "collision/level_set.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kPerTriangle = 220.0;  // bytes: corners, D^-1, conditions; forces at the corners written and read
constexpr double kPerHinge = 168.0;     // bytes: corners, stencils, stiffness, damper; vectors written and read
constexpr double kPerBending = 12.0;    // bytes per entry of the bending matrix, which has 19 per vertex
constexpr double kPerBlock = 76.0;      // bytes of a 3 x 3 block and its column index
constexpr double kPerSample = 152.0;    // bytes: position read; position, look-up and plane written
constexpr double kPerVoxel = 20.0;      // bytes of a filled corner

struct Scene {
  std::unique_ptr<Sheet> sheet;
  IncrementalPotential potential;
  std::vector<char> fixed;
  Point point;
  BlockMatrix hessian;

  explicit Scene(int side)
      : sheet(makeHangingSheet(side, 500.0)),
        potential(sheet->cloth),
        fixed(sheet->cloth.vertexCount(), 0),
        hessian(sheet->cloth.vertexCount(), sheet->cloth.topology().edges) {
    StepOptions options;
    options.h = 1.0 / 60.0;
    potential.begin(sheet->start, options);
    point.x = sheet->start.positions;
    point.evaluate(potential, fixed);
  }
  int vertices() const { return sheet->cloth.vertexCount(); }
  double bendingBytes() const { return 19.0 * kPerBending * vertices(); }
};

/// Returns the scene with `side` vertices along an edge.  Makes it on the first request and keeps it until another one
/// is requested.
Scene& sceneOf(int side) {
  static std::unique_ptr<Scene> scene;
  if (!scene || scene->vertices() != side * side) scene = std::make_unique<Scene>(side);
  return *scene;
}

void bound(benchmark::State& state, double seconds) {
  state.counters["bound_ms"] = 1e3 * seconds;
}

void measureLocal(benchmark::State& state, int side) {
  Scene& scene = sceneOf(side);
  for (auto _ : state) scene.point.evaluate(scene.potential, scene.fixed);
  const Cloth& cloth = scene.sheet->cloth;
  const double bytes = kPerTriangle * cloth.triangleCount() + kPerHinge * static_cast<double>(cloth.hinges().size());
  bound(state, bytes / readBandwidth(static_cast<size_t>(bytes)));
  state.counters["triangles"] = scene.sheet->cloth.triangleCount();
}

void measureMembrane(benchmark::State& state, int side) {
  const Sheet& sheet = *sceneOf(side).sheet;
  Material material = sheet.cloth.material();
  material.bending = 0.0;
  const Cloth cloth({sheet.cloth.restPositions(), sheet.cloth.triangles()}, -Vec3::UnitY(), material);
  IncrementalPotential potential(cloth);
  potential.begin(sheet.start, sceneOf(side).potential.options());
  Point point;
  point.x = sheet.start.positions;
  for (auto _ : state) point.evaluate(potential, sceneOf(side).fixed);
  const double bytes = kPerTriangle * cloth.triangleCount();
  bound(state, bytes / readBandwidth(static_cast<size_t>(bytes)));
  state.counters["triangles"] = cloth.triangleCount();
}

void measureHessian(benchmark::State& state, int side) {
  Scene& scene = sceneOf(side);
  for (auto _ : state) scene.potential.hessian(scene.point.x, HessianKind::projected, scene.hessian);
  state.counters["triangles"] = scene.sheet->cloth.triangleCount();
}

void measureProduct(benchmark::State& state, int side) {
  Scene& scene = sceneOf(side);
  scene.potential.hessian(scene.point.x, HessianKind::projected, scene.hessian);
  const Positions d = randomPositions(scene.vertices(), 1);
  Positions product(scene.vertices(), 3);
  for (auto _ : state) {
    scene.hessian.multiply(d, product);
    scene.potential.addBendingProduct(d, product);
  }
  const double bytes = kPerBlock * scene.hessian.rowEnd(scene.vertices() - 1) + scene.bendingBytes();
  bound(state, bytes / readBandwidth(static_cast<size_t>(bytes)));
}

/// Makes a matrix with the pattern of the projective system.  Its values, a graph Laplacian plus 0.1 on the diagonal,
/// make it positive definite; others would take the same time.
SparseMatrix projectiveMatrix(const Cloth& cloth) {
  SparseMatrix lower = vertexPattern(cloth.vertexCount(), cloth.triangles());
  std::vector<double> degree(cloth.vertexCount(), 0.1);
  for (int j = 0; j < lower.cols(); ++j)
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
      if (entry.row() != j) {
        entry.valueRef() = -1.0;
        degree[entry.row()] += 1.0;
        degree[j] += 1.0;
      }
  for (int j = 0; j < lower.cols(); ++j) lower.coeffRef(j, j) = degree[j];
  return lower;
}

/// The projective system, with one row per vertex, or Newton's system, with three.
struct System {
  SparseMatrix matrix;
  Cholesky cholesky{Cholesky::Kind::kSupernodal};
  Panels panels;
  double flops;

  System(Scene& scene, int rows) {
    const std::vector<int>& ordering = scene.sheet->ordering;
    const SparseMatrix pattern = projectiveMatrix(scene.sheet->cloth);
    flops = factorFlops(pattern, ordering, rows);
    if (rows == 1) {
      matrix = pattern;
      cholesky.analyse(matrix, ordering);
    } else {
      scene.potential.hessian(scene.point.x, HessianKind::projected, scene.hessian);
      scene.hessian.toScalar(scene.fixed, matrix);
      cholesky.analyse(matrix, liftOrdering(ordering));
    }
  }
  bool factor() {
    if (!cholesky.factor(matrix)) return false;
    cholesky.copyTo(panels);
    return true;
  }
};

/// Returns the system with `rows` rows per vertex.  Makes it on the first request and keeps it until another one is
/// requested.
System& systemOf(int side, int rows) {
  static std::unique_ptr<System> system;
  static int made_for[2] = {0, 0};
  if (!system || made_for[0] != side || made_for[1] != rows) system = std::make_unique<System>(sceneOf(side), rows);
  made_for[0] = side;
  made_for[1] = rows;
  return *system;
}

void measureFactor(benchmark::State& state, int side, int rows) {
  System& system = systemOf(side, rows);
  for (auto _ : state)
    if (!system.factor()) return state.SkipWithError("not positive definite");
  bound(state, system.flops / peakFlops());
  state.counters["Mflop"] = 1e-6 * system.flops;
}

void measureSolve(benchmark::State& state, int side, int rows) {
  System& system = systemOf(side, rows);
  if (!system.factor()) return state.SkipWithError("not positive definite");
  const Positions right = randomPositions(side * side, 3);
  Positions x(side * side, 3);
  for (auto _ : state) system.panels.solve(right.data(), x.data(), rows == 1 ? 3 : 1);
  const size_t bytes = system.panels.memoryBytes();
  bound(state, 2.0 * static_cast<double>(bytes) / readBandwidth(bytes));
  state.counters["factor_MB"] = 1e-6 * static_cast<double>(bytes);
}

/// A sleeve of about so many vertices, 5 mm away from a limb.
struct Sleeve {
  static constexpr double kHalfLength = 0.3, kRadius = 0.12, kVoxel = 0.01, kDistance = 0.005;  // m
  TriangleMesh limb = bodies::capsule(kHalfLength, kRadius, 48), mesh;
  TriangleTree tree{limb.positions, limb.triangles};
  LevelSet level_set{{.voxel = kVoxel, .band = 0.03}};
  std::vector<Vec3> samples;

  explicit Sleeve(int vertices) {
    // It has 4 * rings vertices around its axis and 2 * rings rows of them on its two half spheres; rows on the tube
    // have the same distance.
    const double rows_per_ring = 2.0 + 2.0 * kHalfLength / (0.5 * std::numbers::pi * kRadius);
    const int rings = static_cast<int>(std::lround(std::sqrt(vertices / (4.0 * rows_per_ring))));
    mesh = bodies::capsule(kHalfLength, kRadius + kDistance, rings);
    const Topology topology = buildTopology(mesh, "sleeve");
    ContactSamples(static_cast<int>(mesh.positions.rows()), topology.edges, mesh.triangles)
        .positions(mesh.positions, samples);
  }
  void build() { level_set.build(tree, samples, 0.3 * kVoxel); }
  void describe(benchmark::State& state) const {
    state.counters["samples"] = static_cast<double>(samples.size());
    state.counters["voxels"] = static_cast<double>(level_set.filledVoxels());
    state.counters["vertices"] = static_cast<double>(mesh.positions.rows());
  }
};

void measureLevelSet(benchmark::State& state, int vertices) {
  Sleeve sleeve(vertices);
  for (auto _ : state) sleeve.build();
  sleeve.describe(state);
}

void measureContacts(benchmark::State& state, int vertices) {
  Sleeve sleeve(vertices);
  sleeve.build();
  const TriangleMesh& limb = sleeve.limb;
  const BodyMoment body{&sleeve.level_set, &sleeve.tree, &limb.triangles, &limb.positions, &limb.positions, 0.0};
  const std::vector<double> offsets(sleeve.samples.size(), Sleeve::kDistance);
  ContactFinder finder;
  Contacts contacts;
  for (auto _ : state) finder.find(body, sleeve.samples, offsets, Sleeve::kDistance, contacts);
  sleeve.describe(state);
  const double bytes = kPerSample * static_cast<double>(sleeve.samples.size()) +
                       kPerVoxel * static_cast<double>(sleeve.level_set.filledVoxels());
  bound(state, bytes / readBandwidth(static_cast<size_t>(bytes)));
}

template <class Measure>
void add(const std::string& phase, int vertices, bool quick, const Measure& measure) {
  benchmark::RegisterBenchmark(fmt::format("phases/phase:{}/n:{}", phase, vertices).c_str(),
                               [measure](benchmark::State& state) { measure(state); })
      ->Unit(benchmark::kMillisecond)
      ->MinTime(quick ? 0.01 : 0.05)
      ->Repetitions(quick ? 3 : 15)
      ->UseRealTime();
}

void registerAll(bool quick) {
  for (int side : {32, 64, 100, 316}) {
    if (quick && side > 100) continue;
    const int n = side * side;
    add("local", n, quick, [side](auto& state) { measureLocal(state, side); });
    add("membrane", n, quick, [side](auto& state) { measureMembrane(state, side); });
    add("hessian", n, quick, [side](auto& state) { measureHessian(state, side); });
    add("product", n, quick, [side](auto& state) { measureProduct(state, side); });
    add("factor1", n, quick, [side](auto& state) { measureFactor(state, side, 1); });
    add("solve1", n, quick, [side](auto& state) { measureSolve(state, side, 1); });
    add("factor3", n, quick, [side](auto& state) { measureFactor(state, side, 3); });
    add("solve3", n, quick, [side](auto& state) { measureSolve(state, side, 3); });
    add("level-set", n, quick, [n](auto& state) { measureLevelSet(state, n); });
    add("contacts", n, quick, [n](auto& state) { measureContacts(state, n); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  return runBenchmarks(argc, argv, "phases", registerAll);
}

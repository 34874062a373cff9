#include "garment/pattern/variational_cut.h"

#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>
#include <set>

#include "garment/builtin_garment.h"
#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

namespace {

FlatSettings noDarts() {
  FlatSettings settings;
  settings.max_darts = 0;
  return settings;
}

}  // namespace

TEST_CASE("a shirt without seams becomes a few pieces that keep the limits of woven cloth") {
  const RestGarment shirt = restGarment(builtinGarment("t-shirt", 800, 0.004));
  const FoundCuts found = findCuts(shirt, {}, noDarts());
  const FlatPattern pattern = flattenGarment(found.cut.garment, noDarts());
  CHECK(pattern.pieces.size() >= 2);
  CHECK(pattern.pieces.size() <= 8);
  for (const FlatPiece& piece : pattern.pieces) CHECK(piece.strain.flipped == 0);
  for (size_t i = 0; i + 1 < found.energies.size(); ++i) CHECK(found.energies[i + 1] < found.energies[i]);
}

TEST_CASE("a plane of symmetry that misses the garment is refused") {
  CutSettings settings;
  settings.is_symmetric = true;
  settings.plane = 3.0;
  CHECK_THROWS_WITH(findCuts(restGarment(cone(40, 12, 0.16, 0.6, false)), settings, noDarts()),
                    Catch::Contains("symmetric = 3: the plane misses the garment"));
}

TEST_CASE("a tube is cut open") {
  const FoundCuts found = findCuts(restGarment(cone(40, 12, 0.16, 0.6, false)), {}, noDarts());
  CHECK_NOTHROW(flattenGarment(found.cut.garment, noDarts()));
}

TEST_CASE("several parts, and a closed one, are each cut into disks") {
  const TriangleMesh half = cone(6, 2, 0.2, 0.2, true);
  const int n = static_cast<int>(half.positions.rows()), m = static_cast<int>(half.triangles.rows());
  TriangleMesh two{Positions(2 * n, 3), Triangles(2 * m, 3)};
  two.positions << half.positions, half.positions.rowwise() + Eigen::RowVector3d(1.0, 0.0, 0.0);
  two.triangles << half.triangles, half.triangles.array() + n;
  CHECK_NOTHROW(flattenGarment(findCuts(restGarment(two), {}, noDarts()).cut.garment, noDarts()));

  TriangleMesh octahedron{Positions(6, 3), Triangles(8, 3)};
  octahedron.positions << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  octahedron.positions *= 0.2;
  octahedron.triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  const RestGarment closed = restGarment(octahedron, {}, {0.2, -1.0, 0.3});
  CHECK_NOTHROW(flattenGarment(findCuts(closed, {}, noDarts()).cut.garment, noDarts()));
}

TEST_CASE("seams of the garment stay where they are kept, and go where they are not") {
  RestGarment garment = restGarment(bentSheet(12, 0.5, [](double x, double y) { return 1.6 * (x * x + y * y); }));
  Seam seam{"middle", {}, false};
  for (int j = 0; j <= 12; ++j) seam.vertices.push_back(j * 13 + 6);
  garment.seams = {seam};
  CutSettings settings;
  const FoundCuts kept = findCuts(garment, settings, noDarts());
  REQUIRE_FALSE(kept.cut.garment.seams.empty());
  CHECK(kept.cut.garment.seams.front().vertices == seam.vertices);
  settings.keep = false;
  for (const Seam& found : findCuts(garment, settings, noDarts()).cut.garment.seams) CHECK(found.name != "middle");
}

TEST_CASE("symmetric cuts lie alike on both sides") {
  CutSettings settings;
  settings.is_symmetric = true;
  settings.plane = 0.0;
  settings.remove = false;
  const RestGarment shirt = restGarment(builtinGarment("t-shirt", 800, 0.004));
  const FoundCuts found = findCuts(shirt, settings, noDarts());
  double left = 0.0, right = 0.0;
  for (const Seam& seam : found.cut.garment.seams)
    for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
      const Vec3 a = found.cut.garment.mesh.positions.row(seam.vertices[i]),
                 b = found.cut.garment.mesh.positions.row(seam.vertices[i + 1]);
      (a.x() + b.x() > 0.0 ? left : right) += (b - a).norm();
    }
  CHECK(left == Approx(right).epsilon(0.05));
}

TEST_CASE("cuts are the same with any number of threads, and no two seams share a name") {
  const RestGarment shirt = restGarment(builtinGarment("t-shirt", 500, 0.004));
  const auto run = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return findCuts(shirt, {}, noDarts());
  };
  const FoundCuts one = run(1), two = run(2);
  CHECK(one.cut.garment.mesh.positions == two.cut.garment.mesh.positions);
  CHECK(one.energies == two.energies);
  REQUIRE(one.cut.garment.seams.size() == two.cut.garment.seams.size());
  std::set<std::string> names;
  for (size_t s = 0; s < one.cut.garment.seams.size(); ++s) {
    CHECK(one.cut.garment.seams[s].vertices == two.cut.garment.seams[s].vertices);
    names.insert(one.cut.garment.seams[s].name);
  }
  CHECK(names.size() == one.cut.garment.seams.size());
}

TEST_CASE("a garment of skinny triangles is cut into disks") {
  TriangleMesh shirt = builtinGarment("t-shirt", 500, 0.004);
  for (int t = 0; t < shirt.triangles.rows(); t += 37) {  // a corner is drawn almost onto the next one
    const int v = shirt.triangles(t, 0), w = shirt.triangles(t, 1);
    shirt.positions.row(v) += 0.9 * (shirt.positions.row(w) - shirt.positions.row(v)).eval();
  }
  const FoundCuts found = findCuts(restGarment(shirt), {}, noDarts());
  const FlatPattern pattern = flattenGarment(found.cut.garment, noDarts());
  CHECK(pattern.pieces.size() >= 2);
  CHECK(pattern.x.allFinite());
  for (const FlatPiece& piece : pattern.pieces) CHECK(piece.strain.flipped == 0);
}

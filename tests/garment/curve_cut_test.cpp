#include "garment/curve_cut.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "solver/base/error.h"
#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

const TriangleMesh kSheet = makeSheet(10, 10, 1.0, 1.0, 0.2);

/// Finds the line on the sheet where f is zero; there must be exactly one.
BoundaryLoop line(const std::string& name, const std::function<double(const Vec3&)>& f) {
  std::vector<double> values;
  for (int v = 0; v < kSheet.positions.rows(); ++v) values.push_back(f(kSheet.positions.row(v)));
  const std::vector<EdgeCurve> lines = isolines(buildTopology(kSheet, "sheet"), values);
  REQUIRE(lines.size() == 1);
  return {name, lines[0]};
}

BoundaryLoop ring(const std::string& name, double radius) {
  return line(name, [=](const Vec3& x) { return (x - Vec3(0.5, 0.5, 0.0)).norm() - radius; });
}

CutMesh cutSheet(const std::vector<BoundaryLoop>& loops) {
  return cutAlong(kSheet, buildTopology(kSheet, "sheet"), loops);
}

bool isEdge(const Topology& topology, int a, int b) {
  for (const Edge& edge : topology.edges)
    if (edge.vertex == std::array<int, 2>{std::min(a, b), std::max(a, b)}) return true;
  return false;
}

/// Checks that the parts of each triangle cover it exactly, and that each curve runs along edges through its old
/// points.
void checkIsCut(const CutMesh& cut, const std::vector<BoundaryLoop>& loops) {
  CHECK(cut.mesh.positions.topRows(kSheet.positions.rows()) == kSheet.positions);
  REQUIRE(static_cast<long>(cut.source.size()) == cut.mesh.triangles.rows());
  std::vector<double> area(kSheet.triangles.rows(), 0.0);
  for (int t = 0; t < cut.mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) -> Vec3 { return cut.mesh.positions.row(cut.mesh.triangles(t, k)); };
    const double part = 0.5 * doubleAreaNormal(corner(0), corner(1), corner(2)).z();
    CHECK(part > 0.0);
    area[cut.source[t]] += part;
  }
  for (int t = 0; t < kSheet.triangles.rows(); ++t)
    CHECK(area[t] == Approx(triangleArea(kSheet.positions, kSheet.triangles, t)).epsilon(1e-12));
  const Topology topology = buildTopology(cut.mesh, "cut");
  CHECK(topology.boundary_loops.size() == 1);
  CHECK(eulerCharacteristic(cut.mesh) == 1);
  REQUIRE(cut.curves.size() == loops.size());
  for (size_t c = 0; c < loops.size(); ++c) {
    const std::vector<Vec3> points = placed(loops[c].curve, kSheet.positions);
    const std::vector<int>& curve = cut.curves[c];
    REQUIRE(curve.size() == points.size());
    for (size_t i = 0; i < curve.size(); ++i) {
      CHECK(Vec3(cut.mesh.positions.row(curve[i])) == points[i]);
      if (i + 1 < curve.size() || loops[c].curve.is_closed)
        CHECK(isEdge(topology, curve[i], curve[(i + 1) % curve.size()]));
    }
  }
}

}  // namespace

TEST_CASE("a mesh cut along a curve has it as edges, and parts that make up each triangle") {
  const std::vector<BoundaryLoop> loops = {ring("ring", 0.3)};
  const CutMesh cut = cutSheet(loops);
  checkIsCut(cut, loops);
  CHECK(cut.mesh.triangles.rows() > kSheet.triangles.rows() + 40);
}

TEST_CASE("a curve from boundary to boundary and rings that pass through the same triangles are cut too") {
  const std::vector<BoundaryLoop> loops = {ring("inner", 0.3), ring("outer", 0.301), ring("outermost", 0.33),
                                           line("side", [](const Vec3& x) { return x.x() + 0.1 * x.y() - 0.13; })};
  const CutMesh cut = cutSheet(loops);
  checkIsCut(cut, loops);
  int in_several = 0;
  std::vector<int> parts(kSheet.triangles.rows(), 0);
  for (const int t : cut.source) in_several += ++parts[t] == 5 ? 1 : 0;  // two curves make five parts
  CHECK(in_several > 10);
}

TEST_CASE("without curves the mesh stays as it is") {
  const CutMesh cut = cutSheet({});
  checkIsCut(cut, {});
  std::vector<int> each(kSheet.triangles.rows());
  std::iota(each.begin(), each.end(), 0);
  CHECK(cut.source == each);
  CHECK(cut.mesh.positions.rows() == kSheet.positions.rows());
}

TEST_CASE("curves that cross, in a triangle or at a point of an edge, are refused by their names") {
  const BoundaryLoop rise = line("rise", [](const Vec3&x) { return x.y() - 0.7 * x.x() - 0.1; }),
                     fall = line("fall", [](const Vec3&x) { return x.y() + 0.6 * x.x() - 0.8; });
  CHECK_THROWS_AS(cutSheet({rise, fall}), InputError);
  CHECK_THROWS_WITH(cutSheet({rise, fall}), Contains("'rise' and 'fall' cross or touch"));
  CHECK_THROWS_WITH(cutSheet({rise, ring("ring", 0.3)}), Contains("'rise' and 'ring' cross or touch"));
  BoundaryLoop same = rise;
  same.name = "same";
  CHECK_THROWS_WITH(cutSheet({rise, same}), Contains("'rise' and 'same' cross or touch"));
}

#include "solver/mesh/weld.h"

#include <catch2/catch.hpp>

#include "solver/mesh/topology.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

/// A sheet of which every triangle has vertices of its own.
TriangleMesh torn(const TriangleMesh& mesh) {
  TriangleMesh apart{Positions(mesh.triangles.size(), 3), Triangles(mesh.triangles.rows(), 3)};
  for (int s = 0; s < mesh.triangles.size(); ++s) {
    apart.positions.row(s) = mesh.positions.row(mesh.triangles.data()[s]);
    apart.triangles.data()[s] = s;
  }
  return apart;
}

TriangleMesh weldedMesh(const TriangleMesh& mesh, const Weld& weld) {
  return {welded(mesh.positions, weld), welded(mesh.triangles, weld)};
}

Weld weldOf(const TriangleMesh& mesh) {
  return findWeld(mesh.triangles, {&mesh.positions, 1}, true);
}

}  // namespace

TEST_CASE("triangles that share nothing become the surface that they are, also with rounded coordinates") {
  const TriangleMesh sheet = makeSheet(6, 5, 0.6, 0.5, 0.2), apart = torn(sheet);
  const TriangleMesh whole = weldedMesh(apart, weldOf(apart));
  CHECK(whole.positions.rows() == sheet.positions.rows());
  CHECK(buildTopology(whole, "a").boundary_loops.size() == 1);
  TriangleMesh rounded = apart;
  rounded.positions += 1e-7 * randomPositions(static_cast<int>(apart.positions.rows()), 3);
  CHECK(weldOf(rounded).count == sheet.positions.rows());
}

TEST_CASE("a mesh without open edges at one place stays as it is") {
  const TriangleMesh sheet = makeSheet(3, 3, 0.3, 0.3);
  CHECK(weldOf(sheet).changesNothing());
}

TEST_CASE("what lies apart in one pose stays apart in all") {
  TriangleMesh panels = makeSheet(2, 2, 0.2, 0.2), right = panels;
  right.positions.col(0).array() += 0.2;
  TriangleMesh both{Positions(18, 3), Triangles(16, 3)};
  both.positions << panels.positions, right.positions;
  both.triangles << panels.triangles, right.triangles.array() + 9;
  CHECK(weldOf(both).welded == 3);
  Positions opened = both.positions;
  opened.row(9).x() += 0.01;  // the lower end of the seam opens
  const std::vector<Positions> poses = {both.positions, opened};
  const Weld weld = findWeld(both.triangles, poses, true);
  CHECK(weld.welded == 2);
}

TEST_CASE("panels that face opposite ways are counted, not joined") {
  TriangleMesh both{Positions(18, 3), Triangles(16, 3)};
  TriangleMesh panel = makeSheet(2, 2, 0.2, 0.2), right = panel;
  right.positions.col(0).array() += 0.2;
  right.triangles.col(1).swap(right.triangles.col(2));
  both.positions << panel.positions, right.positions;
  both.triangles << panel.triangles, right.triangles.array() + 9;
  const Weld weld = weldOf(both);
  CHECK(weld.welded == 0);
  CHECK(weld.left_open == 4);
}

TEST_CASE("vertices that no triangle uses are dropped, and the others keep their order") {
  const TriangleMesh used = makeSheet(1, 1, 1.0, 1.0);
  TriangleMesh sheet{Positions(5, 3), used.triangles};
  sheet.positions << used.positions, Eigen::RowVector3d(9, 9, 9);
  const Weld weld = weldOf(sheet);
  CHECK(weld.unused == 1);
  CHECK(weld.vertex == std::vector<int>{0, 1, 2, 3, -1});
}

#include "solver/mesh/topology.h"

#include <catch2/catch.hpp>
#include <set>

#include "solver/base/error.h"
#include "tests/tube.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

TriangleMesh meshOf(std::initializer_list<Eigen::RowVector3d> positions,
                    std::initializer_list<Eigen::RowVector3i> triangles) {
  TriangleMesh mesh{Positions(positions.size(), 3), Triangles(triangles.size(), 3)};
  int i = 0, t = 0;
  for (const auto& p : positions) mesh.positions.row(i++) = p;
  for (const auto& v : triangles) mesh.triangles.row(t++) = v;
  return mesh;
}

const TriangleMesh kTetrahedron =
    meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});

}  // namespace

TEST_CASE("Euler's formula holds: a tetrahedron has 6 edges and no boundary, a tube has two loops") {
  const Topology closed = buildTopology(kTetrahedron, "tetrahedron");
  CHECK(closed.edges.size() == 6);
  CHECK(closed.boundary_loops.empty());

  const TriangleMesh mesh = tube(12, 5, 2.0);
  const Topology topology = buildTopology(mesh, "tube");
  CHECK(mesh.positions.rows() - static_cast<int>(topology.edges.size()) + mesh.triangles.rows() == 0);
  REQUIRE(topology.boundary_loops.size() == 2);
  CHECK(topology.boundary_loops[0].size() == 12);
  CHECK(topology.boundary_loops[1].size() == 12);
}

TEST_CASE("every edge knows its triangles, in their orientation, and the vertices opposite to it") {
  const TriangleMesh mesh = tube(7, 4, 1.0);
  const Topology topology = buildTopology(mesh, "tube");
  const auto holds = [&](int t, int from, int to, int opposite) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles(t, k) == opposite) {
        return mesh.triangles(t, (k + 1) % 3) == from && mesh.triangles(t, (k + 2) % 3) == to;
      }
    }
    return false;
  };
  int boundary = 0;
  for (const Edge& edge : topology.edges) {
    const auto [a, b] = edge.vertex;
    REQUIRE(a < b);
    if (edge.isBoundary()) {
      ++boundary;
      CHECK(edge.opposite[1] == -1);
      CHECK((holds(edge.triangle[0], a, b, edge.opposite[0]) || holds(edge.triangle[0], b, a, edge.opposite[0])));
    } else {
      CHECK(holds(edge.triangle[0], a, b, edge.opposite[0]));
      CHECK(holds(edge.triangle[1], b, a, edge.opposite[1]));
    }
  }
  CHECK(boundary == 14);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = topology.edges[topology.triangle_edges(t, k)];
      const std::set<int> found{edge.vertex[0], edge.vertex[1]};
      CHECK(found == std::set<int>{mesh.triangles(t, (k + 1) % 3), mesh.triangles(t, (k + 2) % 3)});
    }
  }
  CHECK(std::is_sorted(topology.edges.begin(), topology.edges.end(),
                       [](const Edge& e, const Edge& f) { return e.vertex < f.vertex; }));
}

TEST_CASE("a loop runs along the boundary and the longest comes first") {
  TriangleMesh mesh = tube(9, 3, 1.0);
  for (int i = 0; i < 9; ++i)
    mesh.positions.row(18 + i).array() *= Eigen::Array3d(3, 1, 3).transpose();  // the upper ring
  const Topology topology = buildTopology(mesh, "tube");
  REQUIRE(topology.boundary_loops.size() == 2);
  CHECK(topology.boundary_loops[0].front() == 18);
  std::set<std::pair<int, int>> boundary;
  for (const Edge& edge : topology.edges) {
    if (edge.isBoundary()) boundary.insert({edge.vertex[0], edge.vertex[1]});
  }
  for (const std::vector<int>& loop : topology.boundary_loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto [a, b] = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
      CHECK(boundary.count({a, b}) == 1);
    }
  }
}

TEST_CASE("the neighbours of a vertex are the other ends of its edges, ascending, each once") {
  const Topology topology = buildTopology(kTetrahedron, "tetrahedron");
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(topology, 5);  // vertex 4 has no triangle
  CHECK(neighbours == std::vector<std::vector<int>>{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}, {}});
}

TEST_CASE("across an edge lies its other triangle, across the boundary none") {
  const TriangleMesh mesh = tube(7, 4, 1.0);
  const Topology topology = buildTopology(mesh, "tube");
  int inner = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = topology.edges[topology.triangle_edges(t, k)];
      const int other = edge.triangleAcross(t);
      CHECK(cornerOf(mesh.triangles, t, mesh.triangles(t, k)) == k);
      CHECK((other < 0) == edge.isBoundary());
      if (other < 0) continue;
      ++inner;
      CHECK(other != t);
      for (const int v : edge.vertex) CHECK(mesh.triangles(other, cornerOf(mesh.triangles, other, v)) == v);
    }
  CHECK(inner == 2 * static_cast<int>(topology.edges.size() - 14));
}

TEST_CASE("mean edge length and total area are those of a right-angled triangle") {
  const TriangleMesh triangle = meshOf({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  CHECK(meanEdgeLength(buildTopology(triangle, "t"), triangle.positions) == Approx(4.0));
  CHECK(totalArea(triangle) == Approx(6.0));
}

TEST_CASE("an edge with three triangles is refused, with its vertices and triangles") {
  const TriangleMesh fin =
      meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK_THROWS_AS(buildTopology(fin, "fin.obj"), InputError);
  CHECK_THROWS_WITH(
      buildTopology(fin, "fin.obj"),
      Catch::StartsWith("fin.obj: the edge of vertices 0 and 1 has 3 triangles (0, 1, 2); expected one or two"));
}

TEST_CASE("a flipped neighbour is refused, with both triangles") {
  const TriangleMesh flipped = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK_THROWS_WITH(
      buildTopology(flipped, "flipped.obj"),
      Catch::StartsWith(
          "flipped.obj: triangles 0 and 1 are oriented against each other along the edge of vertices 0 and 1"));
}

TEST_CASE("a vertex that joins two fans is refused, whether they are open or closed") {
  const TriangleMesh bow_tie =
      meshOf({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}}, {{0, 2, 1}, {0, 4, 3}});
  CHECK_THROWS_WITH(buildTopology(bow_tie, "tie.obj"),
                    Catch::StartsWith("tie.obj: vertex 0 joins two fans of triangles that share no edge there"));

  TriangleMesh two_closed{kTetrahedron.positions, Triangles(8, 3)};
  two_closed.positions.conservativeResize(7, 3);
  two_closed.positions.bottomRows(3) = -kTetrahedron.positions.bottomRows(3);
  for (int t = 0; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = kTetrahedron.triangles(t, k);
      two_closed.triangles(t, k) = v;
      two_closed.triangles(4 + t, 2 - k) = v == 0 ? 0 : v + 3;
    }
  }
  CHECK_THROWS_WITH(buildTopology(two_closed, "b"), Contains("vertex 0 joins two fans"));
}

TEST_CASE("a triangle with a vertex twice is refused") {
  const TriangleMesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}});
  CHECK_THROWS_WITH(buildTopology(mesh, "a"), Catch::StartsWith("a: triangle 0 has vertex 1 twice"));
}

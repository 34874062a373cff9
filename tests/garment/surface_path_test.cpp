#include "garment/surface_path.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

const TriangleMesh kSheet = makeSheet(10, 10, 1.0, 1.0, 0.2);

int edgeOf(int node) {
  return node / kNodesOnEdge;
}

bool shareTriangle(const Topology& topology, int edge, int other) {
  for (const int t : topology.edges[edge].triangle)
    if (t >= 0 && (topology.triangle_edges.row(t).array() == other).any()) return true;
  return false;
}

}  // namespace

TEST_CASE("a shortest path on a flat sheet is straight to a percent or two") {
  const Topology topology = buildTopology(kSheet, "sheet");
  const SurfacePaths paths(kSheet, topology);
  const int start = paths.nearestNode({0.05, 0.1, 0.0}), goal = paths.nearestNode({0.95, 0.7, 0.0});
  const auto nodes = paths.shortest(start, goal);
  REQUIRE(nodes);
  CHECK(nodes->front() == start);
  CHECK(nodes->back() == goal);
  std::vector<Vec3> points;
  for (const int node : *nodes) points.push_back(paths.position(node));
  const double straight = (points.front() - points.back()).norm();
  CHECK(polygonLength(points, false) < 1.02 * straight);
}

TEST_CASE("there is no path to a part that is not connected") {
  TriangleMesh two;
  two.positions.resize(6, 3);
  two.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0;
  two.triangles.resize(2, 3);
  two.triangles << 0, 1, 2, 3, 4, 5;
  const Topology topology = buildTopology(two, "two");
  const SurfacePaths paths(two, topology);
  CHECK_FALSE(paths.shortest(paths.nearestNode({0, 0, 0}), paths.nearestNode({6, 0, 0})));
}

TEST_CASE("a vertex's nearest node lies on its shortest edge, an eighth of it away") {
  const Topology topology = buildTopology(kSheet, "sheet");
  const SurfacePaths paths(kSheet, topology);
  for (const int v : {0, 5, 60, 120}) {
    double shortest = 1.0;
    for (const Edge& edge : topology.edges)
      if (edge.vertex[0] == v || edge.vertex[1] == v)
        shortest =
            std::min(shortest, (kSheet.positions.row(edge.vertex[0]) - kSheet.positions.row(edge.vertex[1])).norm());
    const int node = paths.nearestNodeOf(v);
    const Edge& edge = topology.edges[edgeOf(node)];
    CHECK((edge.vertex[0] == v || edge.vertex[1] == v));
    CHECK((paths.position(node) - Vec3(kSheet.positions.row(v))).norm() == Approx(shortest / 8.0));
  }
}

TEST_CASE("the curve through a path's nodes leaves out detours within a triangle and is no longer than the path") {
  const Topology topology = buildTopology(kSheet, "sheet");
  const SurfacePaths paths(kSheet, topology);
  // The path goes to a point and returns another way, so that it goes back and forth within triangles at the turn.
  std::vector<int> nodes = *paths.shortest(paths.nearestNode({0.1, 0.1, 0.0}), paths.nearestNode({0.8, 0.75, 0.0}));
  const std::vector<int> back = *paths.shortest(nodes.back(), paths.nearestNode({0.1, 0.4, 0.0}));
  nodes.insert(nodes.end(), back.begin(), back.end());  // the node at the turn occurs twice in a row
  const bool is_closed = GENERATE(false, true);
  const EdgeCurve curve = paths.curve(nodes, is_closed);
  REQUIRE(curve.is_closed == is_closed);
  REQUIRE(curve.points.size() > 10);
  CHECK(curve.points.size() < nodes.size());

  std::vector<Vec3> path;
  for (const int node : nodes) path.push_back(paths.position(node));
  const std::vector<Vec3> points = placed(curve, kSheet.positions);
  CHECK(polygonLength(points, is_closed) < polygonLength(path, is_closed));
  if (!is_closed) {
    CHECK((points.front() - path.front()).norm() < 1e-15);
    CHECK((points.back() - path.back()).norm() < 1e-15);
    for (size_t i = 0; i + 1 < points.size(); ++i)
      CHECK(shareTriangle(topology, curve.points[i].edge, curve.points[i + 1].edge));
  }
  const size_t n = points.size(), ends = is_closed ? 0 : 1;
  for (size_t i = ends; i < n - ends; ++i) {
    const int before = curve.points[(i + n - 1) % n].edge, here = curve.points[i].edge,
              after = curve.points[(i + 1) % n].edge;
    CHECK(here != after);
    for (const int t : topology.edges[here].triangle) {
      const auto holds = [&](int edge) { return (topology.triangle_edges.row(t).array() == edge).any(); };
      if (t >= 0) CHECK_FALSE((holds(before) && holds(after)));
    }
  }
}

#include "solver/mesh/mesh_checks.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <limits>
#include <vector>

#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "tests/places.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

/// Two triangles that share the edge of vertices 0 and 2.
const TriangleMesh kSquare{(Positions(4, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0).finished(),
                           (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished()};

/// The mesh with vertex i renumbered to number[i].
TriangleMesh renumbered(const TriangleMesh& mesh, const std::vector<int>& number) {
  TriangleMesh result = mesh;
  for (int i = 0; i < mesh.positions.rows(); ++i) result.positions.row(number[i]) = mesh.positions.row(i);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) result.triangles(t, k) = number[mesh.triangles(t, k)];
  }
  return result;
}

TriangleMesh withTriangle(TriangleMesh mesh, int t, const Eigen::RowVector3i& vertices) {
  mesh.triangles.row(t) = vertices;
  return mesh;
}

const std::string kAdvice = "; every pose must be the same mesh, moved: fit one template to all scans";

}  // namespace

TEST_CASE("a sound mesh passes every check") {
  CHECK_NOTHROW(checkGeometry(kSquare, "square"));
  CHECK_NOTHROW(checkVerticesUsed(kSquare, "square"));
  CHECK_NOTHROW(checkSameTriangles(kSquare, "a", kSquare, "b"));
}

TEST_CASE("a coordinate that is not finite, or too large to compute with, is named with its vertex") {
  TriangleMesh mesh = kSquare;
  mesh.positions(2, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(checkGeometry(mesh, "shirt.obj"), InputError);
  CHECK_THROWS_WITH(checkGeometry(mesh, "shirt.obj"),
                    "shirt.obj: vertex 2 is (1, nan, 0); expected finite coordinates of at most 1e+09");
  mesh.positions(2, 1) = 1e200;  // whose square is infinite
  CHECK_THROWS_WITH(checkGeometry(mesh, "shirt.obj"), Contains("vertex 2 is (1, 1e+200, 0)"));
  mesh.positions(1, 0) = -std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(checkGeometry(mesh, "shirt.obj"), Contains("vertex 1 is (-inf, 0, 0)"));
}

TEST_CASE("a degenerate triangle is named with its vertices and area") {
  CHECK_THROWS_WITH(checkGeometry(withTriangle(kSquare, 1, {0, 3, 3}), "shirt.obj"),
                    Catch::StartsWith("shirt.obj: triangle 1 has a vertex twice: (0, 3, 3)"));
  TriangleMesh flat = kSquare;
  flat.positions.row(3) << 0.5, 0.5, 0;
  CHECK_THROWS_WITH(
      checkGeometry(flat, "shirt.obj"),
      Catch::StartsWith("shirt.obj: triangle 1 of vertices (0, 2, 3) is degenerate: area 0 m^2, expected above 2e-12"));
  TriangleMesh point = kSquare;
  point.positions.setConstant(0.7);
  CHECK_THROWS_WITH(checkGeometry(point, "shirt.obj"), Contains("triangle 0 of vertices (0, 1, 2) is degenerate"));
}

TEST_CASE("the least area scales with the mesh") {
  TriangleMesh thin = kSquare;
  thin.positions.row(3) << 0.5, 0.5 + 1e-9, 0;
  CHECK_NOTHROW(checkGeometry(thin, "thin"));
  thin.positions *= 1e-6;
  CHECK_NOTHROW(checkGeometry(thin, "thin"));
  thin.positions.row(3) << 0.5e-6, 0.5e-6 + 1e-18, 0;
  CHECK_THROWS_WITH(checkGeometry(thin, "thin"), Contains("degenerate"));
}

TEST_CASE("a vertex without a triangle is named") {
  TriangleMesh mesh = kSquare;
  mesh.triangles.conservativeResize(1, 3);
  CHECK_THROWS_WITH(checkVerticesUsed(mesh, "shirt.obj"), "shirt.obj: vertex 3 belongs to no triangle");
}

TEST_CASE("poses with other counts are refused with both counts") {
  TriangleMesh more = kSquare;
  more.positions.conservativeResize(5, 3);
  more.positions.row(4).setZero();
  CHECK_THROWS_WITH(checkSameTriangles(kSquare, "t.ply", more, "a.ply"),
                    Contains("a.ply: has 5 vertices, but t.ply has 4"));
  TriangleMesh fewer = kSquare;
  fewer.triangles.conservativeResize(1, 3);
  CHECK_THROWS_WITH(checkSameTriangles(kSquare, "t.ply", fewer, "a.ply"),
                    "a.ply: has 1 triangles, but t.ply has 2" + kAdvice);
  CHECK_THROWS_WITH(matchByTriangles(kSquare, "t.ply", fewer, "a.ply"),
                    "a.ply: has 1 triangles, but t.ply has 2" + kAdvice);
}

TEST_CASE("the first triangle that differs is named, a match by triangles is offered only where it would help") {
  const TriangleMesh turned = withTriangle(kSquare, 1, {2, 3, 0});
  CHECK_NOTHROW(checkSameTriangles(kSquare, "t.ply", turned, "a.ply"));

  const TriangleMesh other = withTriangle(kSquare, 1, {1, 2, 3});
  CHECK_THROWS_AS(checkSameTriangles(kSquare, "t.ply", other, "a.ply"), InputError);
  CHECK_THROWS_WITH(checkSameTriangles(kSquare, "t.ply", other, "a.ply"),
                    "a.ply: triangle 1 has vertices (1, 2, 3), but in t.ply it has (0, 2, 3)" + kAdvice);
  const TriangleMesh flipped = withTriangle(kSquare, 0, {0, 2, 1});
  CHECK_THROWS_WITH(checkSameTriangles(kSquare, "t.ply", flipped, "a.ply"),
                    Contains("triangle 0 has vertices (0, 2, 1)"));

  CHECK_THROWS_WITH(checkSameTriangles(kSquare, "t.ply", renumbered(kSquare, {0, 1, 3, 2}), "a.ply"),
                    "a.ply: triangle 0 has vertices (0, 1, 3), but in t.ply it has (0, 1, 2); the triangles correspond "
                    "one to one in their order: set match = \"triangles\"");
}

TEST_CASE("a renumbered mesh is matched back to its own numbering") {
  const TriangleMesh matched = matchByTriangles(kSquare, "t.ply", renumbered(kSquare, {2, 0, 3, 1}), "a.ply");
  CHECK(matched.positions == kSquare.positions);
  CHECK(matched.triangles == kSquare.triangles);
}

TEST_CASE("a mesh torn or glued is not matched, and the triangle is named") {
  TriangleMesh torn{(Positions(6, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0).finished(),
                    (Triangles(2, 3) << 0, 1, 2, 3, 4, 5).finished()};
  CHECK_THROWS_AS(matchByTriangles(kSquare, "t.ply", torn, "a.ply"), InputError);
  CHECK_THROWS_WITH(matchByTriangles(kSquare, "t.ply", torn, "a.ply"),
                    "a.ply: does not match t.ply by the order of the triangles: triangle 1 has vertices (3, 4, 5), "
                    "but in t.ply it has (0, 2, 3), so that one vertex would need two numbers" +
                        kAdvice);
  CHECK_THROWS_WITH(matchByTriangles(torn, "t.ply", kSquare, "a.ply"),
                    Contains("triangle 1 has vertices (0, 2, 3), but"));
}

TEST_CASE("a vertex without a triangle cannot be matched") {
  TriangleMesh more = kSquare;
  more.positions.conservativeResize(5, 3);
  more.positions.row(4).setZero();
  CHECK_THROWS_WITH(matchByTriangles(more, "t.ply", more, "a.ply"),
                    "t.ply: vertex 4 belongs to no triangle, so that a.ply cannot be matched to it by its triangles");
}

TEST_CASE("a scan published with other numbers is refused, and matched by its triangles") {
  const std::filesystem::path avatars = std::filesystem::path(kSharedData) / "avatars";
  if (!std::filesystem::exists(avatars)) {
    WARN("skipped: no scans at " << avatars.string());
    return;
  }
  const TriangleMesh pose = readMesh(avatars / "slim_t_pose.ply");
  const TriangleMesh relabelled = readMesh(avatars / "slim_t_pose_relabelled.ply");
  CHECK_THROWS_WITH(checkSameTriangles(pose, "t", relabelled, "r"), Contains("set match = \"triangles\""));
  const TriangleMesh matched = matchByTriangles(pose, "t", relabelled, "r");
  CHECK(matched.positions == pose.positions);
  CHECK_NOTHROW(checkSameTriangles(pose, "t", matched, "r"));
  CHECK_NOTHROW(checkGeometry(pose, "t"));
}

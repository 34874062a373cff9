#include "garment/seam_straightening.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/garment/tools.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr int kCells = 12;
const TriangleMesh kSheet = makeSheet(kCells, kCells, 1.0, 1.0, 0.25);

/// Number of the vertex in column i and row j.
int vertex(int i, int j) {
  return j * (kCells + 1) + i;
}

const SeamLine kUpright = {{{0.52, 0.0, 0.0}, {0.52, 1.0, 0.0}}, false},
               kLevel = {{{0.0, 0.47, 0.0}, {1.0, 0.47, 0.0}}, false};

Seam column(int i) {
  Seam seam{"column", {}, false};
  for (int j = 0; j <= kCells; ++j) seam.vertices.push_back(vertex(i, j));
  return seam;
}

Seam row(int j) {
  Seam seam{"row", {}, false};
  for (int i = 0; i <= kCells; ++i) seam.vertices.push_back(vertex(i, j));
  return seam;
}

TriangleMesh straightened(const std::vector<Seam>& seams, const std::vector<SeamLine>& lines) {
  TriangleMesh mesh = kSheet;
  straightenSeams(seams, lines, buildTopology(kSheet, "sheet"), mesh);
  return mesh;
}

/// Checks that the mesh still covers the square and none of its triangles is turned over.
void checkIsSquare(const TriangleMesh& mesh) {
  CHECK(mesh.positions.col(2).isZero(1e-15));
  CHECK(areaOf(mesh) == Approx(1.0).epsilon(1e-12));
  for (const auto& t : mesh.triangles.rowwise())
    CHECK(doubleAreaNormal(mesh.positions.row(t[0]), mesh.positions.row(t[1]), mesh.positions.row(t[2])).z() > 0.0);
}

double longestStep(const std::vector<int>& chain, const Positions& positions) {
  double longest = 0.0;
  for (size_t i = 0; i + 1 < chain.size(); ++i)
    longest = std::max(longest, (positions.row(chain[i]) - positions.row(chain[i + 1])).norm());
  return longest;
}

}  // namespace

TEST_CASE("the nearest point of a line, open and closed") {
  const SeamLine open{{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, false}, closed{open.points, true};
  CHECK(nearestOn(open, {1, 0.5, 2}) == Vec3(1, 0, 0));
  CHECK(nearestOn(open, {-2, 1, 0}) == Vec3(0, 0, 0));
  CHECK(nearestOn(open, {5, 3, -1}) == Vec3(3, 3, 0));
  CHECK(nearestOn(open, {0, 4, 0}) == Vec3(3, 4, 0));
  CHECK((nearestOn(closed, {0, 4, 0}) - Vec3(1.92, 2.56, 0)).norm() < 1e-15);
  CHECK(nearestOn({{{1, 1, 0}, {1, 1, 0}}, false}, {5, 0, 0}) == Vec3(1, 1, 0));  // a line of length 0
}

TEST_CASE("a straightened seam lies on its line from end to end, more evenly than before") {
  const Seam seam = column(6);
  const TriangleMesh mesh = straightened({seam}, {kUpright});
  checkIsSquare(mesh);
  for (const int v : seam.vertices) CHECK(mesh.positions(v, 0) == Approx(0.52).epsilon(1e-14));
  CHECK(mesh.positions(seam.vertices.front(), 1) == 0.0);
  CHECK(mesh.positions(seam.vertices.back(), 1) == 1.0);
  CHECK(longestStep(seam.vertices, mesh.positions) < longestStep(seam.vertices, kSheet.positions));
  CHECK(longestStep(seam.vertices, mesh.positions) < 1.2 / kCells);
}

TEST_CASE("what is more than four rings from the seam stays, what is nearer goes along, the boundary along itself") {
  const TriangleMesh mesh = straightened({column(6)}, {kUpright});
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) {
      const int v = vertex(i, j);
      const bool moves = mesh.positions.row(v) != kSheet.positions.row(v);
      if (std::abs(i - 6) > 4) CHECK_FALSE(moves);
      if (std::abs(i - 6) <= 2 && j > 0 && j < kCells) CHECK(moves);
      if (j == 0 || j == kCells) CHECK(mesh.positions(v, 1) == Approx(kSheet.positions(v, 1)).margin(1e-15));
    }
  CHECK(mesh.positions(vertex(7, 0), 0) != kSheet.positions(vertex(7, 0), 0));
}

TEST_CASE("where seams meet they stay, each on its line but there") {
  const TriangleMesh mesh = straightened({column(6), row(6)}, {kUpright, kLevel});
  checkIsSquare(mesh);
  CHECK(mesh.positions.row(vertex(6, 6)) == kSheet.positions.row(vertex(6, 6)));
  for (int k = 0; k <= kCells; ++k) {
    if (k == 6) continue;
    CHECK(mesh.positions(vertex(6, k), 0) == Approx(0.52).epsilon(1e-14));
    CHECK(mesh.positions(vertex(k, 6), 1) == Approx(0.47).epsilon(1e-14));
  }
}

TEST_CASE("a closed seam goes onto a closed line") {
  Seam seam{"patch", {}, true};
  for (const auto& [i, j] : {std::pair{5, 5}, {6, 5}, {7, 5}, {7, 6}, {7, 7}, {6, 7}, {5, 7}, {5, 6}})
    seam.vertices.push_back(vertex(i, j));
  SeamLine circle{{}, true};
  for (int k = 0; k < 200; ++k) {
    const double angle = 2.0 * M_PI * k / 200;
    circle.points.emplace_back(0.5 + 0.1 * std::cos(angle), 0.5 + 0.1 * std::sin(angle), 0.0);
  }
  const TriangleMesh mesh = straightened({seam}, {circle});
  checkIsSquare(mesh);
  for (const int v : seam.vertices)
    CHECK((mesh.positions.row(v) - Eigen::RowVector3d(0.5, 0.5, 0.0)).norm() == Approx(0.1).epsilon(1e-3));
}

TEST_CASE("a vertex that is to stay does") {
  TriangleMesh mesh = kSheet;
  std::vector<char> stays(mesh.positions.rows(), 0);
  for (const int v : {vertex(6, 3), vertex(7, 6)}) stays[v] = 1;
  straightenSeams({column(6)}, {kUpright}, buildTopology(kSheet, "sheet"), mesh, stays);
  for (const int v : {vertex(6, 3), vertex(7, 6)}) CHECK(mesh.positions.row(v) == kSheet.positions.row(v));
  CHECK(mesh.positions.row(vertex(6, 6)) != kSheet.positions.row(vertex(6, 6)));
}

TEST_CASE("a chain loses the vertices where it makes a detour around one triangle") {
  const std::vector<std::vector<int>> neighbours = {{1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 4}, {3}};
  std::vector<int> chain = {0, 1, 2, 3, 4};
  removeDetours(neighbours, chain);
  CHECK(chain == std::vector<int>{0, 2, 3, 4});
}

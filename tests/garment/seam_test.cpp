#include "garment/seam.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "garment/region.h"
#include "garment/remesh.h"
#include "solver/base/error.h"
#include "tests/garment/tools.h"

using namespace ease;
using Catch::Contains;

namespace {

LoopedMesh tube() {
  const TriangleMesh body = capsuleBody();
  const Topology topology = buildTopology(body, "body");
  const std::vector<LoopRequest> loops = {planeLoop("top", {0, 0.2, 0}, {0, 1, 0}),
                                          planeLoop("hem", {0, -0.2, 0}, {0, 1, 0})};
  const LoopedMesh region = enclosedRegion(body, topology, findLoops(body, topology, loops, 0.01), {0, 0.1, kRadius});
  return withLoopNames(remeshedTo(region.mesh, 800, "tube"), region);
}

bool areNeighbours(const TriangleMesh& mesh, int a, int b) {
  for (const auto& t : mesh.triangles.rowwise())
    if ((t.array() == a).any() && (t.array() == b).any()) return true;
  return false;
}

void checkChain(const LoopedMesh& garment, const Seam& seam) {
  const size_t n = seam.vertices.size();
  for (size_t i = 0; i + (seam.is_closed ? 0 : 1) < n; ++i)
    CHECK(areNeighbours(garment.mesh, seam.vertices[i], seam.vertices[(i + 1) % n]));
  CHECK(std::set<int>(seam.vertices.begin(), seam.vertices.end()).size() == n);
}

const SeamRequest kSide{"side", "hem", "top", {{kRadius, 0.0, 0.0}}, {}};

}  // namespace

TEST_CASE("a seam from loop to loop is straight, along edges, and ends on both") {
  LoopedMesh garment = tube();
  const std::vector<Seam> seams = findSeams({kSide}, garment);
  REQUIRE(seams.size() == 1);
  checkChain(garment, seams[0]);
  const auto isIn = [](const std::vector<int>& loop, int v) {
    return std::find(loop.begin(), loop.end(), v) != loop.end();
  };
  CHECK(isIn(garment.loops[1].vertices, seams[0].vertices.front()));
  CHECK(isIn(garment.loops[0].vertices, seams[0].vertices.back()));
  for (size_t i = 1; i + 1 < seams[0].vertices.size(); ++i) {
    const Vec3 x = garment.mesh.positions.row(seams[0].vertices[i]);
    CHECK(std::abs(x.z()) < 0.012);
    CHECK(x.x() > 0.1);
  }
  CHECK(polygonLength(positionsOf(seams[0].vertices, garment.mesh.positions), false) < 0.41);
}

TEST_CASE("a plane cuts a closed seam, points enclose one") {
  LoopedMesh garment = tube();
  const SeamRequest plane{"waist", "", "", {}, PlaneNear{{0, 0.05, 0}, {0, 1, 0}, {0, 0.05, 0}}};
  const SeamRequest points{"hip", "", "", pointLoop("", -0.08, 4).points, {}};
  const std::vector<Seam> seams = findSeams({plane, points}, garment);
  for (const Seam& seam : seams) {
    CHECK(seam.is_closed);
    checkChain(garment, seam);
  }
  for (const int v : seams[0].vertices) CHECK(garment.mesh.positions(v, 1) == Approx(0.05).margin(2e-3));
  for (const int v : seams[1].vertices) CHECK(garment.mesh.positions(v, 1) == Approx(-0.08).margin(0.006));
}

TEST_CASE("straightened seams leave well-shaped triangles") {
  LoopedMesh garment = tube();
  findSeams({kSide}, garment);
  for (int t = 0; t < garment.mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = garment.mesh.positions.row(garment.mesh.triangles(t, k));
      const Vec3 u = garment.mesh.positions.row(garment.mesh.triangles(t, (k + 1) % 3)).transpose() - a;
      const Vec3 v = garment.mesh.positions.row(garment.mesh.triangles(t, (k + 2) % 3)).transpose() - a;
      CHECK(u.normalized().dot(v.normalized()) < std::cos(20.0 * M_PI / 180.0));
    }
}

TEST_CASE("an impossible seam is refused by name") {
  LoopedMesh garment = tube();
  SeamRequest request = kSide;
  request.to = "neck";
  CHECK_THROWS_AS(findSeams({request}, garment), InputError);
  CHECK_THROWS_WITH(findSeams({request}, garment), "seam 'side': loop 'neck': expected one of 'top', 'hem'");
  SeamRequest later = kSide;
  later.name = "back";
  later.to = "sied";
  CHECK_THROWS_WITH(findSeams({kSide, later}, garment),
                    "seam 'back': loop 'sied': expected one of 'top', 'hem', 'side'");
  request = kSide;
  request.points[0].x() += 0.52;
  CHECK_THROWS_WITH(findSeams({request}, garment),
                    "seam 'side': point 0 = [0.64, 0, 0] is 0.52 m from the garment: expected within 0.1 m");
  const SeamRequest beside{"waist", "", "", {}, PlaneNear{{0, 2, 0}, {0, 1, 0}, {0, 2, 0}}};
  CHECK_THROWS_WITH(findSeams({beside}, garment), "seam 'waist': its plane does not cut the garment");
  const SeamRequest two{"waist", "", "", {{0, 0, 0.12}, {0, 0, -0.12}}, {}};
  CHECK_THROWS_WITH(findSeams({two}, garment), Contains("2 points: a closed seam needs at least 3"));
}

TEST_CASE("a seam may end on a seam above it, and another begin there") {
  LoopedMesh garment = tube();
  const SeamRequest waist{"waist", "", "", {}, PlaneNear{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  const SeamRequest below{"below", "hem", "waist", {{kRadius, -0.1, 0.0}, {kRadius, 0.0, 0.0}}, {}};
  const SeamRequest above{"above", "waist", "top", {{kRadius, 0.0, 0.0}, {kRadius, 0.1, 0.0}}, {}};
  const std::vector<Seam> seams = findSeams({waist, below, above}, garment);
  for (const Seam& seam : seams) checkChain(garment, seam);
  const std::vector<int>& around = seams[0].vertices;
  CHECK(std::count(around.begin(), around.end(), seams[1].vertices.back()) == 1);
  CHECK(seams[1].vertices.back() == seams[2].vertices.front());
}

namespace {

/// A tube of equal triangles about y whose rings have a vertex at x = 0, facing +z.
LoopedMesh evenTube() {
  constexpr int kAround = 24, kRings = 9;
  LoopedMesh garment{{Positions(kAround * kRings, 3), Triangles(2 * kAround * (kRings - 1), 3)},
                     {{"hem", {}}, {"top", {}}}};
  int t = 0;
  for (int r = 0; r < kRings; ++r)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * M_PI * i / kAround;
      garment.mesh.positions.row(kAround * r + i) << 0.2 * std::sin(angle), 0.05 * r, 0.2 * std::cos(angle);
      if (r == 0) garment.loops[0].vertices.push_back(i);
      if (r + 1 == kRings) garment.loops[1].vertices.push_back(kAround * r + i);
      if (r == 0) continue;
      const int j = (i + 1) % kAround, below = kAround * (r - 1), here = kAround * r;
      garment.mesh.triangles.row(t++) << below + i, below + j, here + j;
      garment.mesh.triangles.row(t++) << below + i, here + j, here + i;
    }
  return garment;
}

}  // namespace

TEST_CASE("a seam that is to run along edges of the mesh leaves their vertices on it") {
  LoopedMesh garment = evenTube();
  const std::vector<Seam> seams =
      findSeams({{"front", "hem", "top", {{0.0, 0.13, 0.2}, {0.0, 0.27, 0.2}}, {}}}, garment);
  REQUIRE(seams[0].vertices.size() == 9);
  for (const int v : seams[0].vertices) CHECK(std::abs(garment.mesh.positions(v, 0)) < 1e-4);
}

TEST_CASE("a seam without an end on a loop ends within the garment, at its last point") {
  LoopedMesh garment = evenTube();
  const std::vector<Seam> seams = findSeams({{"dart", "hem", "", {{0.0, 0.2, 0.2}}, {}}}, garment);
  checkChain(garment, seams[0]);
  const Vec3 tip = garment.mesh.positions.row(seams[0].vertices.back());
  CHECK((tip - Vec3(0.0, 0.2, 0.2)).norm() < 0.01);
  CHECK(seams[0].vertices.size() == 5);
}

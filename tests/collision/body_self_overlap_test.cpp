#include "collision/body_self_overlap.h"

#include <catch2/catch.hpp>

#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

BodySelfOverlap overlapOf(const TriangleMesh& mesh) {
  BodySelfOverlap overlap;
  overlap.find(TriangleTree(mesh.positions, mesh.triangles),
               std::vector<unsigned char>(static_cast<size_t>(mesh.triangles.rows()), 1));
  return overlap;
}

Vec3 cornerOf(const TriangleMesh& mesh, int t, int k) {
  return mesh.positions.row(mesh.triangles(t, k));
}

}  // namespace

TEST_CASE("a surface that does not meet itself has neither crossing nor buried triangles") {
  for (const TriangleMesh& mesh : {box(Vec3::Zero(), Vec3::Ones()), sphere(0.3, 20), capsule(0.5, 0.1, 10),
                                   joined(sphere(0.3, 10), moved(sphere(0.3, 10), Vec3(0.61, 0.0, 0.0)))}) {
    const BodySelfOverlap overlap = overlapOf(mesh);
    CHECK(overlap.crossing() == 0);
    CHECK(overlap.buried() == 0);
  }
}

TEST_CASE("where two spheres overlap, what lies within the other is buried") {
  const double offset = 0.12, radius = 0.2;
  const TriangleMesh right = moved(sphere(radius, 16), Vec3(offset, 0.0, 0.0));
  const TriangleMesh left = moved(sphere(radius, 16), Vec3(-offset, 0.0, 0.0));
  const TriangleMesh mesh = joined(right, left);
  const BodySelfOverlap overlap = overlapOf(mesh);
  CHECK(overlap.crossing() > 0);
  CHECK(overlap.buried() > 0);
  const TriangleTree right_tree(right.positions, right.triangles), left_tree(left.positions, left.triangles);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const TriangleTree& other = t < right.triangles.rows() ? left_tree : right_tree;
    int within = 0;
    for (int k = 0; k < 3; ++k) within += other.windingNumber(cornerOf(mesh, t, k));
    const Exposure exposure = overlap.exposures()[t];
    if (exposure == Exposure::boundary) CHECK(within == 0);
    if (exposure == Exposure::buried) CHECK(within == 3);
    if (within == 1 || within == 2) CHECK(exposure == Exposure::crossing);
  }
}

TEST_CASE("spheres whose vertices and edges lie on each other exactly are told apart all the same") {
  const TriangleMesh ball = sphere(0.25, 8);
  const BodySelfOverlap overlap = overlapOf(joined(ball, moved(ball, Vec3(0.0, 0.0, 0.25))));
  CHECK(overlap.crossing() > 0);
  const auto exposures = overlap.exposures();
  for (int t = 0; t < ball.triangles.rows(); ++t) {
    const double furthest = std::max({cornerOf(ball, t, 0)[2], cornerOf(ball, t, 1)[2], cornerOf(ball, t, 2)[2]});
    if (furthest < 0.08) CHECK(exposures[t] == Exposure::boundary);
    const double nearest = std::min({cornerOf(ball, t, 0)[2], cornerOf(ball, t, 1)[2], cornerOf(ball, t, 2)[2]});
    if (nearest > 0.17) CHECK(exposures[t] == Exposure::buried);
  }
}

TEST_CASE("triangles that cross from a common vertex on are seen") {
  // Around vertex 0: two crosswise triangles that meet along the x axis, and a third that faces against both.
  const TriangleMesh mesh = meshOf({{0.0, 0.0, 0.0},
                                    {1.0, -1.0, 0.0},
                                    {1.0, 1.0, 0.0},
                                    {0.5, 0.0, 0.5},
                                    {0.5, 0.0, -0.5},
                                    {-1.0, -1.0, 1.0},
                                    {-2.0, 1.0, -1.0}},
                                   {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}});
  const BodySelfOverlap overlap = overlapOf(mesh);
  CHECK(overlap.exposures()[0] == Exposure::crossing);
  CHECK(overlap.exposures()[1] == Exposure::crossing);
  CHECK(overlap.crossing() == 2);
}

TEST_CASE("only what is asked for and its neighbours in the tree are looked at") {
  const TriangleMesh mesh = sphere(0.3, 20);
  std::vector<unsigned char> asked(static_cast<size_t>(mesh.triangles.rows()), 0);
  asked[7] = 1;
  BodySelfOverlap overlap;
  overlap.find(TriangleTree(mesh.positions, mesh.triangles), asked);
  CHECK(overlap.exposures()[7] == Exposure::boundary);
  CHECK(std::count(overlap.exposures().begin(), overlap.exposures().end(), Exposure::boundary) == 8);
}

#include "solver/model/cloth.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/sheet.h"

using namespace ease;

namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("the masses add up to the density times the area, or to the total asked for") {
  const TriangleMesh mesh = makeSheet(5, 4, 0.5, 0.4, 0.2);
  Material material;
  material.density = 0.15;
  CHECK(sum(Cloth(mesh, Vec3(0.0, -1.0, 0.0), material).masses()) == Approx(0.15 * 0.2));
  material.total_mass = 1.5;
  CHECK(sum(Cloth(mesh, Vec3(0.0, -1.0, 0.0), material).masses()) == Approx(1.5));
}

TEST_CASE("at rest every triangle's deformation gradient is the material's frame, whatever its vertices' order") {
  TriangleMesh mesh = makeSheet(5, 4, 0.5, 0.4, 0.2);
  const Eigen::RowVector3i corners = mesh.triangles.row(3);
  mesh.triangles.row(3) << corners[1], corners[2], corners[0];
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.2), Material());
  Mat32 frame;
  frame << 0.0, 1.0, -1.0, 0.0, 0.0, 0.0;  // warp down, weft = normal x warp
  for (int t = 0; t < cloth.triangleCount(); ++t) CHECK((cloth.deformation(mesh.positions, t) - frame).norm() < 1e-12);
}

TEST_CASE("a larger rest shape is heavier, and makes the same shape in space less stretched") {
  const TriangleMesh mesh = makeSheet(5, 4, 0.5, 0.4);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  const double mass = sum(cloth.masses());
  const RestShape first = cloth.rest();
  RestShape larger{1.25 * mesh.positions, first.edges};
  for (Mat2& e : larger.edges) e *= 1.25;
  cloth.setRest(larger);
  CHECK(cloth.rest().edges == larger.edges);
  CHECK(cloth.first().edges == first.edges);
  CHECK(cloth.first().positions == mesh.positions);
  CHECK(sum(cloth.masses()) == Approx(1.25 * 1.25 * mass));
  CHECK(cloth.deformation(mesh.positions, 7).col(0).norm() == Approx(0.8));
}

TEST_CASE("a new first rest shape is the present one too, and counts as a change") {
  const TriangleMesh mesh = makeSheet(3, 2, 0.3, 0.2);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  const int revision = cloth.restRevision();
  RestShape first{1.5 * mesh.positions, cloth.rest().edges};
  for (Mat2& e : first.edges) e *= 1.5;
  cloth.setFirst(first);
  CHECK(cloth.first().edges == first.edges);
  CHECK(cloth.rest().positions == first.positions);
  CHECK(cloth.restRevision() > revision);
}

TEST_CASE("hinges exist where two triangles meet, and only if the cloth bends") {
  const TriangleMesh mesh = makeSheet(3, 2, 0.3, 0.2);
  Material material;
  CHECK(Cloth(mesh, Vec3(0.0, -1.0, 0.0), material).hinges().empty());
  material.bending = 1e-6;
  const Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), material);
  int inner = 0;
  for (const Edge& edge : cloth.topology().edges) inner += edge.isBoundary() ? 0 : 1;
  CHECK(static_cast<int>(cloth.hinges().size()) == inner);
  for (const Hinge& hinge : cloth.hinges())
    CHECK(std::abs(std::accumulate(hinge.stencil.begin(), hinge.stencil.end(), 0.0)) < 1e-12);
}

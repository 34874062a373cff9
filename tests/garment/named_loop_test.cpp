#include "garment/named_loop.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "tests/places.h"
#include "tests/tube.h"

using namespace ease;
using Catch::Matchers::Contains;

TEST_CASE("a loop is found by where it lies or by its index") {
  const TriangleMesh mesh = tube(8, 3, 1.0);
  const Topology topology = buildTopology(mesh, "tube");
  CHECK(mesh.positions(findLoop(topology, mesh.positions, "top")[0], 1) == 1.0);
  CHECK(mesh.positions(findLoop(topology, mesh.positions, "bottom")[0], 1) == 0.0);
  CHECK(&findLoop(topology, mesh.positions, "1") == &topology.boundary_loops[1]);
}

TEST_CASE("the neck lies on the middle, wherever the sleeves end, and is ambiguous where two may be it") {
  TriangleMesh mesh = tube(8, 3, 1.0);        // hem below, neck above
  const auto add = [&](double x, double y) {  // a patch whose boundary stands for the end of a sleeve
    const int n = static_cast<int>(mesh.positions.rows());
    TriangleMesh more{Positions(n + 3, 3), Triangles(mesh.triangles.rows() + 1, 3)};
    more.positions << mesh.positions, Eigen::RowVector3d(x, y, 0), Eigen::RowVector3d(x + 0.1, y, 0),
        Eigen::RowVector3d(x, y, 0.1);
    more.triangles << mesh.triangles, Eigen::RowVector3i(n, n + 1, n + 2);
    mesh = more;
  };
  add(1.5, 1.4);
  add(-1.6, 0.9);
  add(1.5, -0.4);  // as of an arm that hangs below the hem
  const Topology topology = buildTopology(mesh, "shirt");
  CHECK(mesh.positions(findLoop(topology, mesh.positions, "neck")[0], 1) == 1.0);
  CHECK(mesh.positions(findLoop(topology, mesh.positions, "hem")[0], 1) == 0.0);
  CHECK(mesh.positions(findLoop(topology, mesh.positions, "top")[0], 1) == 1.4);
  add(0.0, 1.2);
  CHECK_THROWS_WITH(findLoop(buildTopology(mesh, "shirt"), mesh.positions, "neck"),
                    Contains("boundary loop \"neck\" is ambiguous") && Contains("name it by its number"));
}

TEST_CASE("a loop that is not there is refused with those that are") {
  const TriangleMesh mesh = tube(8, 3, 1.0);
  const Topology topology = buildTopology(mesh, "tube");
  const auto find = [&](const char* where) { findLoop(topology, mesh.positions, where); };
  CHECK_THROWS_AS(find("waist"), InputError);
  CHECK_THROWS_WITH(find("waist"), Contains("no boundary loop \"waist\": expected \"top\"") &&
                                       Contains("0 (8 vertices about (") && Contains("1 (8 vertices about ("));
  CHECK_THROWS_WITH(find("2"), Contains("no boundary loop \"2\""));
  CHECK_THROWS_WITH(find("-1"), Contains("no boundary loop \"-1\""));
  CHECK_THROWS_WITH(find("left"), Contains("\"left\" is ambiguous: loops"));
  CHECK_THROWS_WITH(findLoop(Topology(), mesh.positions, "top"), Contains("the mesh has no boundary loop"));
}

TEST_CASE("hem, sleeves and neck of real shirts are found") {
  const std::filesystem::path garments = std::filesystem::path(kSharedData) / "garments";
  if (!std::filesystem::exists(garments)) {
    WARN("skipped: no shirts at " << garments.string());
    return;
  }
  for (const char* name : {"shirt_1100.obj", "shirt_3032.obj", "shirt_4270.obj", "shirt_10000.obj"}) {
    INFO(name);
    const TriangleMesh shirt = readMesh(garments / name);
    const Topology topology = buildTopology(shirt, name);
    REQUIRE(topology.boundary_loops.size() == 4);
    const auto coordinate = [&](const char* where, int axis) {
      double sum = 0.0;
      const std::vector<int>& loop = findLoop(topology, shirt.positions, where);
      for (int vertex : loop) sum += shirt.positions(vertex, axis);
      return sum / static_cast<double>(loop.size());
    };
    CHECK(&findLoop(topology, shirt.positions, "bottom") == &topology.boundary_loops[0]);
    CHECK(coordinate("bottom", 1) == Approx(0.86).margin(0.01));
    CHECK(coordinate("left", 0) == Approx(0.28).margin(0.01));
    CHECK(coordinate("right", 0) == Approx(-0.28).margin(0.01));
    CHECK(coordinate("top", 1) == Approx(1.46).margin(0.03));
    CHECK(coordinate("top", 0) == Approx(0.0).margin(0.02));
  }
}

#include "solver/mesh/topology.h"
#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

std::string binary() {
  std::string bytes(80, ' ');
  append(bytes, 2U);
  for (int t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0F);
    for (int k = 0; k < 9; ++k) append(bytes, static_cast<float>(kSquare(kTwoTriangles(t, k / 3), k % 3)));
    append(bytes, static_cast<short>(0));
  }
  return bytes;
}

}  // namespace

TEST_CASE("the same square comes out of an STL in text and in bytes, corners in one place made one vertex") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("binary.stl", binary())));
  checkIsSquare(readMesh(folder.write(
      "text.stl",
      "solid vertex 1\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 .25\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 1 1 .25\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid vertex 1\n")));
}

TEST_CASE("a binary STL may begin with the word that text begins with") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("a.stl", "solid" + binary().substr(5))));
}

TEST_CASE("an STL is read with capitals, a blank line first, a mark of its encoding, spare bytes, or no count") {
  const Folder folder;
  const std::string text =
      "SOLID square\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 1 1 .25\nENDLOOP\nENDFACET\n"
      "Facet Normal 0 0 1\nOuter Loop\nVertex 0 0 0\nVertex 1 1 .25\nVertex 0 1 0\nEndLoop\nEndFacet\n"
      "ENDSOLID square\n";
  checkIsSquare(readMesh(folder.write("a.stl", text)));
  checkIsSquare(readMesh(folder.write("a.stl", "\n \n" + text + "written by hand\n")));
  checkIsSquare(readMesh(folder.write("a.stl", "\xEF\xBB\xBF" + text)));
  checkIsSquare(readMesh(folder.write("a.stl", binary() + "made by a program")));
  std::string countless = binary();
  std::fill(countless.begin() + 80, countless.begin() + 84, '\0');
  checkIsSquare(readMesh(folder.write("a.stl", countless)));
}

TEST_CASE("an STL whose count is smaller than what follows is refused, not cut short") {
  const Folder folder;
  std::string bytes = binary();
  bytes[80] = 1;
  CHECK_THAT(messageOf(folder.write("a.stl", bytes)), Contains("its header promises 1 triangles, but 2 follow"));
}

TEST_CASE("an STL's surface that touches itself in a vertex or along an edge stays what it is") {
  // Two tetrahedra: they share the vertex (0, 0, 0), or the edge from there to (1, 0, 0).
  const auto facets = [](const TriangleMesh& mesh) {
    std::string text;
    for (const auto& t : mesh.triangles.rowwise()) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int v : t)
        text += "vertex " + std::to_string(mesh.positions(v, 0)) + " " + std::to_string(mesh.positions(v, 1)) + " " +
                std::to_string(mesh.positions(v, 2)) + "\n";
      text += "endloop\nendfacet\n";
    }
    return text;
  };
  TriangleMesh tetrahedron{Positions(4, 3), Triangles(4, 3)};
  tetrahedron.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  tetrahedron.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  const Folder folder;
  for (const bool along_edge : {false, true}) {
    TriangleMesh other = tetrahedron;  // turned by half a turn, about the vertex or about the edge
    other.positions.col(1) *= -1.0;
    if (along_edge) other.positions.col(2) *= -1.0;
    if (!along_edge) other.positions.col(0) *= -1.0;
    const TriangleMesh mesh =
        readMesh(folder.write("a.stl", "solid\n" + facets(tetrahedron) + facets(other) + "endsolid\n"));
    CHECK(mesh.positions.rows() == 8);
    CHECK(buildTopology(mesh, "tetrahedra").boundary_loops.empty());
  }
}

TEST_CASE("an STL of random bytes is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("noise.stl", noise())),
             Contains("not an STL file, or cut short: it has 5000 bytes"));
}

TEST_CASE("an STL cut short anywhere is refused") {
  const Folder folder;
  const std::string whole = binary();
  for (std::size_t keep = 1; keep < whole.size(); keep += 5) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.stl", whole.substr(0, keep))), InputError);
  }
  CHECK_THAT(
      messageOf(folder.write("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")),
      Contains("ends within triangle 0, without \"endsolid\""));
}

TEST_CASE("an STL's coordinate that is no number is refused, as is a triangle of two vertices") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.stl",
                                    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                    "vertex 1 nan 0\nendloop\nendfacet\nendsolid\n")),
             Contains("vertex 2 is (1, nan, 0)"));
  CHECK_THAT(messageOf(folder.write("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n")),
             Contains("triangle 0: expected a coordinate, found \"zero\""));
  CHECK_THAT(messageOf(folder.write("a.stl",
                                    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                    "endloop\nendfacet\nendsolid\n")),
             Contains("triangle 0 does not have three vertices"));
}

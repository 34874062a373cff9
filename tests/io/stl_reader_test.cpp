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

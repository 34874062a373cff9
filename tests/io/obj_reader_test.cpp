#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

TEST_CASE("an OBJ's polygon is cut from its first corner, its comments and line ends are left out") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\r\nv +1 1 0.25 # a comment\nv 0 1 0\nf 1 2 3 4\n")));
}

TEST_CASE("an OBJ keeps the number and order of its vertices whatever normals and textures its faces name") {
  const Folder folder;
  const std::string rest = "vn 0 0 1\nvn 0 1 0\nvt 0 0\nvt 1 1\ng front\nusemtl cotton\n";
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0.25\nv 0 1 0\n";
  checkIsSquare(readMesh(folder.write("a.obj", vertices + rest + "f 1/1/1 2/2/2 3/1/1\nf 1/2/2 3/2/2 4/1/1\n")));
  checkIsSquare(readMesh(folder.write("b.obj", vertices + rest + "f -4//1 -3//2 -2//1\nf 1/2 3/2 4/1\n")));

  const TriangleMesh unused = readMesh(folder.write("c.obj", "v 9 9 9\n" + vertices + "v 8 8 8\nf 2 3 4\n"));
  CHECK(unused.positions.rows() == 6);
  CHECK(unused.triangles == (Triangles(1, 3) << 1, 2, 3).finished());
}

TEST_CASE("an OBJ's index counts back from the vertices so far") {
  const Folder folder;
  const TriangleMesh mesh =
      readMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.25\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n"));
  checkIsSquare(mesh);
}

TEST_CASE("an OBJ is read with lines that go on, carriage returns alone, capitals, byte order marks and UTF-16") {
  const Folder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 .25\nv 0 1 0\nf 1 2 3 4\n";
  checkIsSquare(readMesh(folder.write("a.obj", "v 0 0 0\nv 1 \\\n0 0\nv 1 1 .25\nv 0 1 0\nf 1 2 \\\r\n3 \\\n4\n")));
  std::string returns = square, capitals = square, wide = "\xFF\xFE";
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  checkIsSquare(readMesh(folder.write("b.obj", returns)));
  std::replace(capitals.begin(), capitals.end(), 'v', 'V');
  std::replace(capitals.begin(), capitals.end(), 'f', 'F');
  checkIsSquare(readMesh(folder.write("c.obj", capitals)));
  checkIsSquare(readMesh(folder.write("d.obj", "\xEF\xBB\xBF" + square)));
  for (const char c : square) wide += {c, '\0'};
  checkIsSquare(readMesh(folder.write("e.obj", wide)));
  CHECK_THAT(messageOf(folder.write("f.obj", "v 0,5 0 0\n")), Contains("line 1") && Contains("decimal points"));
}

TEST_CASE("an OBJ without triangles is refused, and one of random bytes is such a one") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("noise.obj", noise())), Contains("holds no triangles"));
  CHECK_THAT(messageOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n")), Contains("holds no triangles"));
}

TEST_CASE("an OBJ's index out of range is named with its triangle, a face that is none with its line") {
  const Folder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 3\nf 1 2 4\n")),
             Contains("face 1 has vertex 3, but there are 3 (counted from 0)"));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 -4\n")), Contains("face 0 has vertex -1"));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 0\n")),
             Contains("line 4: expected a vertex index, found \"0\""));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2\n")), Contains("line 4: a face with 2 vertices"));
}

TEST_CASE("an OBJ's coordinate that is no number is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n")),
             Contains("vertex 1 is (1, nan, 0); expected finite coordinates"));
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 0\nv 1 0\n")),
             Contains("line 2: expected three coordinates, found \"\""));
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 zero\n")),
             Contains("line 1: expected three coordinates, found \"zero\""));
}

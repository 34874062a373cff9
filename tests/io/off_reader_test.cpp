#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

TEST_CASE("an OFF is read with comments, colours and normals left out") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n4 0 1 2 3\n")));
  checkIsSquare(
      readMesh(folder.write("b.off",
                            "# a square\r\nCOFF # with colours\r\n\r\n4 2 5\r\n0 0 0 255 0 0 255\r\n1 0 0 1 1 1 1\r\n"
                            "1 1 .25 0 0 0 0\r\n0 1 0 9 9 9 9\r\n3 0 1 2 255 0 0\r\n3 0 2 3\r\nthe end")));
}

TEST_CASE("an OFF that is none, is cut short or promises too much is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.off", "v 0 0 0\n")), Contains("the first word is not \"OFF\""));
  CHECK_THAT(messageOf(folder.write("a.off", "OFF BINARY\n")), Contains("is a binary OFF file"));
  CHECK_THAT(messageOf(folder.write("a.off", "OFF\n4 1 0\n0 0 0\n1 0\n")), Contains("line 4: expected a coordinate"));
  CHECK_THAT(messageOf(folder.write("a.off", "OFF\n9999999 1 0\n0 0 0\n")), Contains("promises 9999999 vertices"));
  CHECK_THAT(messageOf(folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")),
             Contains("face 0 has vertex 7, but there are 3"));
  CHECK_THAT(messageOf(folder.write("a.off", noise())), Contains("not an OFF file"));
}

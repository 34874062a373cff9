#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

/// Four points and one cell of these corners; `cells`: of which kind.
std::string vtp(const std::string& points, const std::string& connectivity, const std::string& offsets,
                const std::string& cells = "Polys") {
  return "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>"
         "<Piece NumberOfPoints=\"4\" NumberOf" +
         cells +
         "=\"1\"><Points>"
         "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
         points + "</DataArray></Points><" + cells +
         ">"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity +
         "</DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
         offsets + "</DataArray></" + cells + "></Piece></PolyData></VTKFile>";
}

const std::string kPoints = "0 0 0 1 0 0 1 1 .25 0 1 0";

}  // namespace

TEST_CASE("a VTP's polygon is cut from its first corner") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("a.vtp", vtp(kPoints, "0 1 2 3", "4"))));
}

TEST_CASE("a VTP of random bytes is refused with what VTK says of it") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("noise.vtp", noise())), Contains("not a VTP file, or damaged: Error parsing"));
}

TEST_CASE("a VTP cut short anywhere is refused") {
  const Folder folder;
  const std::string whole = vtp(kPoints, "0 1 2 3", "4");
  for (std::size_t keep = 1; keep < whole.size(); keep += 10) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.vtp", whole.substr(0, keep))), InputError);
  }
  CHECK_THAT(messageOf(folder.write("cut.vtp", whole.substr(0, 300))), Contains("unclosed token"));
}

TEST_CASE("a VTP's index out of range is named with its triangle, a coordinate that is no number is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp("0 0 0 1 0 0 1 1 0 0 1 0", "0 1 2 99999", "4"))),
             Contains("face 0 has vertex 99999, but there are 4"));
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp("0 0 0 1 one 0 1 1 0 0 1 0", "0 1 2", "3"))), Contains("a.vtp"));
}

TEST_CASE("a VTP's strips become triangles that face one way, a polygon of two corners is refused") {
  const Folder folder;
  CHECK(readMesh(folder.write("a.vtp", vtp(kPoints, "0 1 3 2", "4", "Strips"))).triangles ==
        (Triangles(2, 3) << 0, 1, 3, 3, 1, 2).finished());
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp(kPoints, "0 1", "2"))), Contains("polygon 0 has 2 vertices"));
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp(kPoints, "0 1", "2", "Lines"))), Contains("holds no triangles"));
}

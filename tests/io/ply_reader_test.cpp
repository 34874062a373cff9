#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

const std::string kHeader =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string text(const std::string& body) {
  return "ply\nformat ascii 1.0\ncomment by hand\n" + kHeader + body;
}

std::string binary(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + kHeader;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(kSquare(i, k)), big);
  }
  append(bytes, static_cast<unsigned char>(4));
  for (int i = 0; i < 4; ++i) append(bytes, i, big);
  return bytes;
}

}  // namespace

TEST_CASE("the same square comes out of a PLY in text and in bytes of either order") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("text.ply", text("0 0 0\n1 0 0\n1 1 .25\n0 1 0\n4 0 1 2 3\n"))));
  checkIsSquare(readMesh(folder.write("little.ply", binary(false))));
  checkIsSquare(readMesh(folder.write("big.ply", binary(true))));
}

TEST_CASE(
    "a PLY's numbers have the types, its properties the order and its elements the company that its header says") {
  const Folder folder;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nobj_info scanned\n"
      "element camera 1\nproperty list uint8 int16 sizes\nproperty double focus\n"
      "element vertex 4\nproperty uchar red\nproperty double z\nproperty double y\nproperty float32 x\n"
      "element face 2\nproperty short label\nproperty list ushort uint8 vertex_index\nend_header\n";
  append(bytes, static_cast<unsigned char>(2));
  for (const short size : {640, 480}) append(bytes, size, true);
  append(bytes, 0.035, true);
  for (int i = 0; i < 4; ++i) {
    append(bytes, static_cast<unsigned char>(200));
    append(bytes, kSquare(i, 2), true);
    append(bytes, kSquare(i, 1), true);
    append(bytes, static_cast<float>(kSquare(i, 0)), true);
  }
  for (int t = 0; t < 2; ++t) {
    append(bytes, static_cast<short>(-7), true);
    append(bytes, static_cast<unsigned short>(3), true);
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<unsigned char>(kTwoTriangles(t, k)));
  }
  checkIsSquare(readMesh(folder.write("a.ply", bytes)));
}

TEST_CASE("what a PLY's mesh does not need may be anything, its strips become triangles, text may follow") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write(
      "a.ply",
      "PLY\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float nx\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
      "end_header\n0 -1.#IND 0 0\n1 nan 0 0\n1 1.#QNAN 1 .25\n0 inf 1 0\n4 0 1 2 3 2 nan -1.#IND\nthe end\n")));
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
      "8 0 1 2 -1 0 2 3 -1\n";
  CHECK(readMesh(folder.write("b.ply", strips)).triangles == kTwoTriangles);
}

TEST_CASE("a PLY of another kind or of random bytes is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("noise.ply", noise())), Contains("the first line is not \"ply\""));
  CHECK_THAT(messageOf(folder.write("square.ply", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), Contains("not a PLY file"));
  // Whatever follows a good header must end in an error or a mesh, never in a crash.
  CHECK_THAT(messageOf(folder.write("half.ply", binary(false).substr(0, 170) + noise())), Contains("half.ply"));
}

TEST_CASE("a PLY cut short anywhere is refused") {
  const Folder folder;
  const std::string whole = binary(false);
  for (std::size_t keep = 1; keep < whole.size(); keep += 3) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.ply", whole.substr(0, keep))), InputError);
  }
  CHECK_THAT(messageOf(folder.write("cut.ply", whole.substr(0, whole.size() - 1))),
             Contains("face 0 of 1: \"vertex_indices\" is not a number, or the file is cut short"));
}

TEST_CASE("a PLY's index out of range is named with its triangle, a coordinate that is no number with its vertex") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.ply", text("0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 9\n"))),
             Contains("face 0 has vertex 9, but there are 4"));
  CHECK_THAT(messageOf(folder.write("a.ply", text("0 0 0 1 one 0"))), Contains("vertex 1 of 4: \"y\" is not a number"));
  CHECK_THAT(messageOf(folder.write("a.ply", text("0 0 0 1 inf 0 1 1 0 0 1 0 3 0 1 2"))),
             Contains("vertex 1 is (1, inf, 0)"));
}

TEST_CASE("a PLY header that promises too much or makes no sense is refused at once") {
  const Folder folder;
  const auto with = [&](const std::string& header) { return messageOf(folder.write("a.ply", "ply\n" + header)); };
  CHECK_THAT(with("format ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty float y\nproperty float "
                  "z\nend_header\n0"),
             Contains("promises 99999999999 elements \"vertex\", but only 1 bytes follow"));
  CHECK_THAT(with("format ascii 1.0\nelement vertex -5\n"), Contains("line 3 of the header is not understood"));
  CHECK_THAT(with("format morse 1.0\n"), Contains("line 2 of the header is not understood: \"format morse 1.0\""));
  CHECK_THAT(with("format ascii 1.0\nelement vertex 1\nproperty quad x\n"), Contains("line 4 of the header"));
  CHECK_THAT(with("format ascii 1.0\nelement vertex 1\n"), Contains("does not end with \"end_header\""));
  CHECK_THAT(with("element vertex 0\nend_header\n"), Contains("no \"format\""));
  CHECK_THAT(with("format ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 1"),
             Contains("the vertices have no \"z\""));
  CHECK_THAT(with("format ascii 1.0\nelement face 1\nproperty list char int vertex_index\nend_header\n2 0 1"),
             Contains("face 0 has 2 vertices"));
  CHECK_THAT(with("format ascii 1.0\nelement face 1\nproperty list char int vertex_index\nend_header\n3 0 1 1.5"),
             Contains("face 0 has the vertex index 1.5"));
}

#include "solver/mesh/mesh_io.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstring>
#include <fstream>

#include "solver/mesh/error.h"

using namespace ease;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for one test case, removed with it.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("ease_mesh_io_" + std::to_string(getpid()))) {
    fs::create_directory(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  fs::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  fs::path path_;
};

std::string messageOf(const fs::path& file) {
  try {
    readMesh(file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.starts_with(file.string() + ": "));
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "no error";
}

const Triangles kTwoTriangles = (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished();
const Positions kSquare = (Positions(4, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0).finished();

template <class Number>
void append(std::string& bytes, Number value, bool swapped = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (swapped) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof value);
}

const std::string kPlyHeader =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string binaryPly(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + kPlyHeader;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(kSquare(i, k)), big);
  }
  append(bytes, static_cast<unsigned char>(4));
  for (int i = 0; i < 4; ++i) append(bytes, i, big);
  return bytes;
}

std::string binaryStl() {
  std::string bytes(80, ' ');
  append(bytes, 2U);
  for (int t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0F);
    for (int k = 0; k < 9; ++k) append(bytes, static_cast<float>(kSquare(kTwoTriangles(t, k / 3), k % 3)));
    append(bytes, static_cast<short>(0));
  }
  return bytes;
}

std::string vtp(const std::string& points, const std::string& connectivity, const std::string& offsets) {
  return "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>"
         "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\"><Points>"
         "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
         points +
         "</DataArray></Points><Polys>"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity +
         "</DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
         offsets + "</DataArray></Polys></Piece></PolyData></VTKFile>";
}

void checkIsSquare(const TriangleMesh& mesh) {
  CHECK(mesh.positions == kSquare);
  CHECK(mesh.triangles == kTwoTriangles);
}

}  // namespace

TEST_CASE("the same square comes out of every format, its polygon cut from the first corner") {
  const Folder folder;
  checkIsSquare(readMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\r\nv +1 1 0.25 # a comment\nv 0 1 0\nf 1 2 3 4\n")));
  checkIsSquare(readMesh(folder.write(
      "a.ply", "ply\nformat ascii 1.0\ncomment by hand\n" + kPlyHeader + "0 0 0\n1 0 0\n1 1 .25\n0 1 0\n4 0 1 2 3\n")));
  checkIsSquare(readMesh(folder.write("little.PLY", binaryPly(false))));
  checkIsSquare(readMesh(folder.write("big.ply", binaryPly(true))));
  checkIsSquare(readMesh(folder.write("a.vtp", vtp("0 0 0 1 0 0 1 1 .25 0 1 0", "0 1 2 3", "4"))));
  checkIsSquare(readMesh(folder.write("binary.stl", binaryStl())));
  checkIsSquare(readMesh(folder.write(
      "text.stl",
      "solid vertex 1\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 .25\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 1 1 .25\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid vertex 1\n")));
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

TEST_CASE("a mesh written as OBJ is read back to the last bit") {
  const Folder folder;
  TriangleMesh mesh{kSquare / 3.0, kTwoTriangles};
  mesh.positions(2, 1) = 1.0 + 1e-15;
  writeObj(folder / "out.obj", mesh);
  const TriangleMesh back = readMesh(folder / "out.obj");
  CHECK(back.positions == mesh.positions);
  CHECK(back.triangles == mesh.triangles);
  CHECK_FALSE(fs::exists(folder / "out.obj.part"));

  const fs::path nowhere = folder / "no_such_folder" / "out.obj";
  CHECK_THROWS_AS(writeObj(nowhere, mesh), ComputationError);
  CHECK_THROWS_WITH(writeObj(nowhere, mesh), nowhere.string() + ": cannot be written");
}

TEST_CASE("a file that cannot be read is named with the reason") {
  const Folder folder;
  CHECK_THAT(messageOf(folder / "missing.ply"), Contains("no such file"));
  CHECK_THAT(messageOf(folder.write("shirt.xyz", "x")), Contains("ends in .ply, .obj, .stl or .vtp"));
  fs::create_directory(folder / "folder.obj");
  CHECK_THAT(messageOf(folder / "folder.obj"), Contains("not a regular file"));
  for (const char* name : {"empty.ply", "empty.obj", "empty.stl", "empty.vtp"}) {
    CHECK_THAT(messageOf(folder.write(name, "")), Contains("the file is empty"));
  }
}

TEST_CASE("a file of another kind or of random bytes is refused") {
  const Folder folder;
  std::string noise;
  unsigned state = 1;
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>((state = 1664525U * state + 1013904223U) >> 24);
  CHECK_THAT(messageOf(folder.write("noise.ply", noise)), Contains("the first line is not \"ply\""));
  CHECK_THAT(messageOf(folder.write("noise.obj", noise)), Contains("holds no triangles"));
  CHECK_THAT(messageOf(folder.write("noise.stl", noise)), Contains("not an STL file, or cut short: it has 5000 bytes"));
  CHECK_THAT(messageOf(folder.write("noise.vtp", noise)), Contains("not a VTP file, or damaged: Error parsing"));
  CHECK_THAT(messageOf(folder.write("square.ply", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), Contains("not a PLY file"));
  CHECK_THAT(messageOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n")), Contains("holds no triangles"));
  // Whatever follows a good header must end in an error or a mesh, never in a crash.
  CHECK_THAT(messageOf(folder.write("half.ply", binaryPly(false).substr(0, 170) + noise)), Contains("half.ply"));
}

TEST_CASE("a file cut short anywhere is refused") {
  const Folder folder;
  const std::string ply = binaryPly(false), stl = binaryStl(),
                    square = vtp("0 0 0 1 0 0 1 1 .25 0 1 0", "0 1 2 3", "4");
  for (std::size_t keep = 1; keep < ply.size(); keep += 3) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.ply", ply.substr(0, keep))), InputError);
  }
  for (std::size_t keep = 1; keep < stl.size(); keep += 5) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.stl", stl.substr(0, keep))), InputError);
  }
  for (std::size_t keep = 1; keep < square.size(); keep += 10) {
    CHECK_THROWS_AS(readMesh(folder.write("cut.vtp", square.substr(0, keep))), InputError);
  }
  CHECK_THAT(messageOf(folder.write("cut.ply", ply.substr(0, ply.size() - 1))),
             Contains("face 0 of 1: \"vertex_indices\" is not a number, or the file is cut short"));
  CHECK_THAT(
      messageOf(folder.write("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")),
      Contains("ends within triangle 0, without \"endsolid\""));
  CHECK_THAT(messageOf(folder.write("cut.vtp", square.substr(0, 300))), Contains("unclosed token"));
}

TEST_CASE("an index out of range is named with its triangle") {
  const Folder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 3\nf 1 2 4\n")),
             Contains("triangle 1 has vertex 3, but there are 3 (counted from 0)"));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 -4\n")), Contains("triangle 0 has vertex -1"));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2 0\n")),
             Contains("line 4: expected a vertex index, found \"0\""));
  CHECK_THAT(messageOf(folder.write("a.obj", vertices + "f 1 2\n")), Contains("line 4: a face with 2 vertices"));
  CHECK_THAT(
      messageOf(folder.write("a.ply", "ply\nformat ascii 1.0\n" + kPlyHeader + "0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 9\n")),
      Contains("triangle 0 has vertex 9, but there are 4"));
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp("0 0 0 1 0 0 1 1 0 0 1 0", "0 1 2 99999", "4"))),
             Contains("triangle 1 has vertex 99999, but there are 4"));
}

TEST_CASE("a coordinate that is no number is refused") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n")),
             Contains("vertex 1 is (1, nan, 0); expected finite coordinates"));
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 0\nv 1 0\n")),
             Contains("line 2: expected three coordinates, found \"\""));
  CHECK_THAT(messageOf(folder.write("a.obj", "v 0 0 zero\n")),
             Contains("line 1: expected three coordinates, found \"zero\""));
  CHECK_THAT(messageOf(folder.write("a.ply", "ply\nformat ascii 1.0\n" + kPlyHeader + "0 0 0 1 one 0")),
             Contains("vertex 1 of 4: \"y\" is not a number"));
  CHECK_THAT(
      messageOf(folder.write("a.ply", "ply\nformat ascii 1.0\n" + kPlyHeader + "0 0 0 1 inf 0 1 1 0 0 1 0 3 0 1 2")),
      Contains("vertex 1 is (1, inf, 0)"));
  CHECK_THAT(messageOf(folder.write("a.stl",
                                    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                    "vertex 1 nan 0\nendloop\nendfacet\nendsolid\n")),
             Contains("vertex 2 is (1, nan, 0)"));
  CHECK_THAT(messageOf(folder.write("a.vtp", vtp("0 0 0 1 one 0 1 1 0 0 1 0", "0 1 2", "3"))), Contains("a.vtp"));
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

TEST_CASE("a scan of 27,578 vertices and its shirts are read whole, in a few milliseconds") {
  const fs::path data = EASE_SHARED_DATA;
  if (!fs::exists(data)) {
    WARN("skipped: no scans at " << data.string());
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const TriangleMesh body = readMesh(data / "avatars/slim_t_pose.ply");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  CHECK(body.positions.rows() == 27578);
  CHECK(body.triangles.rows() == 55152);
  CHECK(seconds.count() < 0.5);

  const TriangleMesh shirt = readMesh(data / "garments/shirt_10000.obj");
  CHECK(shirt.positions.rows() == 10000);
  CHECK(shirt.triangles.rows() == 19792);
  CHECK(shirt.triangles.row(19791) == Eigen::RowVector3i(6058, 6057, 5477));
}

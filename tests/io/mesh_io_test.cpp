// What holds for files of every format; for each of them: obj_reader_test, ply_reader_test, stl_reader_test,
// vtp_reader_test.
#include "solver/io/mesh_io.h"

#include <chrono>

#include "tests/io/mesh_files.h"
#include "tests/places.h"

using namespace ease;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

TEST_CASE("a file's extension tells its format, in capitals too") {
  const Folder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 .25\nv 0 1 0\nf 1 2 3 4\n";
  checkIsSquare(readMesh(folder.write("a.OBJ", square)));
  CHECK_THAT(messageOf(folder.write("a.Ply", square)), Contains("not a PLY file"));
  CHECK_THAT(messageOf(folder.write("a.stl", square)), Contains("not an STL file"));
  CHECK_THAT(messageOf(folder.write("a.VTP", square)), Contains("not a VTP file"));
  CHECK(isMeshFile("a.Off"));
  CHECK_FALSE(isMeshFile("a.toml"));
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
  CHECK_THROWS_WITH(writeObj(nowhere, mesh), "cannot write " + nowhere.string() + ": No such file or directory");
}

TEST_CASE("a file that cannot be read is named with the reason") {
  const Folder folder;
  CHECK_THAT(messageOf(folder / "missing.ply"), Contains("no such file"));
  CHECK_THAT(messageOf(folder.write("shirt.xyz", "x")), Contains("ends in .ply, .obj, .stl, .off or .vtp"));
  fs::create_directory(folder / "folder.obj");
  CHECK_THAT(messageOf(folder / "folder.obj"), Contains("not a regular file"));
  for (const char* name : {"empty.ply", "empty.obj", "empty.stl", "empty.vtp"}) {
    CHECK_THAT(messageOf(folder.write(name, "")), Contains("the file is empty"));
  }
}

TEST_CASE("a scan of 27,578 vertices and its shirts are read whole, in a few milliseconds") {
  const fs::path data = kSharedData;
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

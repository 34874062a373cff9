#include "apps/garment_files.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "solver/base/whole_file.h"
#include "solver/io/mesh_io.h"
#include "tests/apps/temporary_directory.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("a garment that is written while interrupted has its files whole, and no picture") {
  const TemporaryDirectory directory;
  const Scene scene = readScene(directory.write(
      "tube.toml",
      "body = {builtin = 'mannequin', poses = ['t']}\n[garment]\nresolution = 300\n[garment.region]\n"
      "seed = [0, 1, 0.1]\n[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
      "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0]}\n"));
  const SceneInput input = readSceneInput(scene);
  writeGarment(scene, input, directory.path, true);
  for (const char* name : {"garment.obj", "garment.vtp", "garment.json", "body.obj"})
    CHECK(std::filesystem::file_size(directory.path / name) > 0);
  CHECK_FALSE(std::filesystem::exists(directory.path / "garment.png"));
  CHECK(readMesh(directory.path / "garment.obj").positions == input.garment.positions);
}

TEST_CASE("pieces are written under the name asked for, with one vertex more at every vertex of a seam across") {
  const TemporaryDirectory directory;
  const TriangleMesh sheet = makeSheet(2, 2, 1.0, 1.0);
  Seam middle{"middle", {}, false};
  for (int v = 0; v < sheet.positions.rows(); ++v)
    if (std::abs(sheet.positions(v, 0) - 0.5) < 1e-9) middle.vertices.push_back(v);
  REQUIRE(middle.vertices.size() == 3);
  CHECK(writePieces(sheet, {middle}, directory.path, "rest_pieces") ==
        "pieces    2, with 3 vertices more than the garment\n");
  CHECK(readMesh(directory.path / "rest_pieces.obj").positions.rows() == sheet.positions.rows() + 3);
  CHECK(std::filesystem::exists(directory.path / "rest_pieces.vtp"));
  std::vector<int> in_file;  // where the garment's file has another order
  for (int v = 0; v < sheet.positions.rows(); ++v) in_file.push_back(100 + v);
  writePieces(sheet, {middle}, directory.path, "of_file", in_file);
  const auto glue = [&](const char* name) {
    return nlohmann::json::parse(contentOf(directory.path / name))["garment_vertex"].get<std::vector<int>>();
  };
  std::vector<int> there = glue("of_file.json");
  for (int& v : there) v -= 100;
  CHECK(there == glue("rest_pieces.json"));
}

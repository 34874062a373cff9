#include "apps/cut_input.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("what belongs to vertices is interpolated, what belongs to triangles is taken over") {
  SceneInput input;
  input.garment.positions.resize(3, 3);
  input.garment.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  input.garment.triangles.resize(1, 3);
  input.garment.triangles << 0, 1, 2;
  input.start = input.garment.positions.array() + 1.0;
  input.offsets = {0.001, 0.003, 0.005};
  input.paint = {1.5};
  input.pins = {{0, 1}, {2}};

  CutUp cut;
  for (int v = 0; v < 3; ++v) cut.vertices.push_back({{v, v, v}, {1.0, 0.0, 0.0}});
  cut.vertices.push_back({{0, 1, 0}, {0.25, 0.75, 0.0}});
  cut.garment.mesh.positions = Positions::Zero(4, 3);
  cut.garment.mesh.triangles.resize(2, 3);
  cut.garment.mesh.triangles << 0, 3, 2, 3, 1, 2;
  cut.garment.rest_edges.assign(2, Mat2::Identity());
  cut.garment.seams = {{"cut 1", {3, 2}, false}};
  cut.source = {0, 0};

  RestShape rest;
  cutInput(cut, input, rest);
  CHECK(input.garment.positions.row(3) == Eigen::RowVector3d(0.75, 0.0, 0.0));
  CHECK(input.start.row(3) == Eigen::RowVector3d(1.75, 1.0, 1.0));
  CHECK(input.garment.triangles == cut.garment.mesh.triangles);
  CHECK(input.offsets[3] == Approx(0.0025));
  CHECK(input.paint == std::vector<double>{1.5, 1.5});
  CHECK(input.pins == std::vector<std::vector<int>>{{0, 1, 3}, {2}});
  CHECK(input.seams.front().name == "cut 1");
  CHECK(rest.edges.size() == 2);
}

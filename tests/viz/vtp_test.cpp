#include "viz/vtp.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "solver/base/error.h"
#include "tests/viz/fixtures.h"

using Catch::Matchers::Contains;

namespace {

ease::Frame sampleFrame(const ease::TriangleMesh& mesh) {
  const auto vertices = mesh.positions.rows(), triangles = mesh.triangles.rows();
  return {mesh.positions,
          {test::noise("gap_m", 1, vertices), test::noise("velocity_m_s", 3, vertices)},
          {test::noise("sigma_1", 1, triangles), test::noise("sigma_2", 1, triangles)}};
}

void checkSame(vtkDataSetAttributes* read, const std::vector<ease::NamedArray>& written) {
  REQUIRE(read->GetNumberOfArrays() == static_cast<int>(written.size()));
  for (const ease::NamedArray& array : written) {
    INFO(array.name);
    const auto* values = vtkFloatArray::SafeDownCast(read->GetArray(array.name.c_str()));
    REQUIRE(values != nullptr);
    REQUIRE(values->GetNumberOfComponents() == array.components);
    REQUIRE(values->GetNumberOfValues() == static_cast<vtkIdType>(array.values.size()));
    CHECK(std::equal(array.values.begin(), array.values.end(), const_cast<vtkFloatArray*>(values)->GetPointer(0)));
  }
}

}  // namespace

TEST_CASE("what is written to a .vtp is read back the same") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(30);
  const ease::Frame frame = sampleFrame(mesh);
  ease::writeVtp(directory.path() / "frame.vtp", mesh.triangles, frame);

  const auto read = test::readVtp(directory.path() / "frame.vtp");
  REQUIRE(read->GetNumberOfPoints() == mesh.positions.rows());
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    for (int k = 0; k < 3; ++k) {
      REQUIRE(read->GetPoint(i)[k] == static_cast<double>(static_cast<float>(mesh.positions(i, k))));
    }
  }
  REQUIRE(read->GetNumberOfPolys() == mesh.triangles.rows());
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    vtkIdType count;
    const vtkIdType* vertices;
    read->GetPolys()->GetCellAtId(t, count, vertices);
    REQUIRE(count == 3);
    for (int k = 0; k < 3; ++k) REQUIRE(vertices[k] == mesh.triangles(t, k));
  }
  checkSame(read->GetPointData(), frame.vertex_arrays);
  checkSame(read->GetCellData(), frame.triangle_arrays);
}

TEST_CASE("a .vtp has no appended data, which newer expat keeps ParaView 5.11 from reading") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(4);
  ease::writeVtp(directory.path() / "frame.vtp", mesh.triangles, sampleFrame(mesh));
  std::ostringstream text;
  text << std::ifstream(directory.path() / "frame.vtp").rdbuf();
  CHECK_THAT(text.str(), Contains("compressor=\"vtkLZ4DataCompressor\"") && Contains("format=\"binary\""));
  CHECK_THAT(text.str(), !Contains("AppendedData"));
}

TEST_CASE("an array that does not fit the mesh is refused with its name and lengths") {
  const test::Directory directory;
  const auto file = directory.path() / "frame.vtp";
  const ease::TriangleMesh mesh = test::gridMesh(3);
  ease::Frame frame = sampleFrame(mesh);
  frame.vertex_arrays[1].values.pop_back();
  CHECK_THROWS_WITH(ease::writeVtp(file, mesh.triangles, frame),
                    Contains("frame.vtp") && Contains("velocity_m_s has 26 values, expected 9 x 3"));
  ease::Triangles outside = mesh.triangles;
  outside(2, 1) = 9;
  CHECK_THROWS_WITH(ease::writeVtp(file, outside, sampleFrame(mesh)), Contains("vertex outside 0..8"));
  CHECK(!std::filesystem::exists(file));
}

TEST_CASE("a .vtp that cannot be written is one error of ours, and VTK stays silent") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(3);
  std::string message;
  const auto write = [&] {
    try {
      ease::writeVtp(directory.path() / "gone" / "frame.vtp", mesh.triangles, sampleFrame(mesh));
    } catch (const ease::ComputationError& error) {
      message = error.what();
    }
  };
  CHECK(test::printedBytes(write) == 0);
  CHECK_THAT(message, Contains("gone/frame.vtp: No such file or directory"));
}

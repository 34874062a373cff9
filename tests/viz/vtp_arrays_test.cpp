#include "viz/vtp_arrays.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "solver/base/error.h"
#include "tests/sheet.h"
#include "tests/viz/fixtures.h"

using namespace ease;

TEST_CASE("what was written to a .vtp file is read again") {
  const TriangleMesh sheet = makeSheet(2, 2, 1.0, 1.0);
  Frame frame{sheet.positions, {}, {{"edges_m", 2, {}}}};
  for (int k = 0; k < 2 * sheet.triangles.rows(); ++k)
    frame.triangle_arrays[0].values.push_back(0.25F * static_cast<float>(k));
  const auto file = std::filesystem::temp_directory_path() / ("arrays_" + std::to_string(::getpid()) + ".vtp");
  writeVtp(file, sheet.triangles, frame);
  const VtpMesh read = readVtpArrays(file, {"edges_m"});
  CHECK(read.mesh.triangles == sheet.triangles);
  CHECK((read.mesh.positions - sheet.positions).norm() < 1e-6);
  CHECK(read.triangle_arrays[0].components == 2);
  CHECK(read.triangle_arrays[0].values == frame.triangle_arrays[0].values);
  CHECK_THROWS_WITH(readVtpArrays(file, {"other"}), Catch::EndsWith("has no array 'other'"));
  std::ofstream(file) << "no XML";
  CHECK(test::printedBytes([&] { CHECK_THROWS_AS(readVtpArrays(file, {}), InputError); }) == 0);
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(readVtpArrays(file, {}), Catch::EndsWith("no such file"));
}

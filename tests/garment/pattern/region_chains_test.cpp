#include "garment/pattern/region_chains.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

namespace {

std::vector<int> labelled(const TriangleMesh& mesh, const std::function<int(const Vec3&)>& label) {
  std::vector<int> labels;
  for (const auto& t : mesh.triangles.rowwise())
    labels.push_back(label((mesh.positions.row(t[0]) + mesh.positions.row(t[1]) + mesh.positions.row(t[2])) / 3.0));
  return labels;
}

}  // namespace

TEST_CASE("three regions meet in a junction where three chains end") {
  const TriangleMesh sheet = bentSheet(8, 1.0, [](double, double) { return 0.0; });
  const std::vector<int> labels = labelled(sheet, [](const Vec3& x) { return x.x() < 0.0 ? 0 : x.y() < 0.0 ? 1 : 2; });
  const std::vector<Seam> chains = chainsAlong(sheet, edgesBetween(sheet, labels, {}), {});
  REQUIRE(chains.size() == 3);
  double length = 0.0;
  for (const Seam& chain : chains) {
    CHECK_FALSE(chain.is_closed);
    length += lengthOfSeam(chain, sheet.positions);
  }
  CHECK(length == Approx(1.5));
  CHECK(chains.front().name == "cut 1");
}

TEST_CASE("a region inside another is bounded by a closed chain") {
  const TriangleMesh sheet = bentSheet(8, 1.0, [](double, double) { return 0.0; });
  const std::vector<int> labels =
      labelled(sheet, [](const Vec3& x) { return std::max(std::abs(x.x()), std::abs(x.y())) < 0.25 ? 1 : 0; });
  const std::vector<Seam> chains = chainsAlong(sheet, edgesBetween(sheet, labels, {}), {});
  REQUIRE(chains.size() == 1);
  CHECK(chains.front().is_closed);
  CHECK(lengthOfSeam(chains.front(), sheet.positions) == Approx(2.0));
}

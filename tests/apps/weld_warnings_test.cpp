#include "apps/weld_warnings.h"

#include <catch2/catch.hpp>

using namespace ease;
using Catch::Contains;

namespace {

std::vector<std::string> warningsOf(const Weld& weld, const std::string& file) {
  std::vector<std::string> warnings;
  warnOfWeld(weld, file, "garment", [&](const std::string& warning) { warnings.push_back(warning); });
  return warnings;
}

}  // namespace

TEST_CASE("what a weld did is told, with the key that prevents it") {
  Weld weld;
  CHECK(warningsOf(weld, "shirt.obj").empty());
  weld.welded = 2;
  weld.unused = 1;
  weld.left_open = 3;
  const std::vector<std::string> told = warningsOf(weld, "shirt.obj");
  REQUIRE(told.size() == 3);
  CHECK_THAT(told[0], Contains("shirt.obj: 3 open edges"));
  CHECK_THAT(told[1], Contains("2 vertices") && Contains("[garment] weld = false"));
  CHECK_THAT(told[2], Contains("1 vertex"));
}

TEST_CASE("of a file whose triangles share no vertices only edges that stay open are told") {
  Weld weld;
  weld.welded = 30;
  CHECK(warningsOf(weld, "shirt.stl").empty());
  weld.left_open = 1;
  CHECK(warningsOf(weld, "shirt.stl").size() == 1);
}

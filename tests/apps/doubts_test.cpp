#include "apps/doubts.h"

#include <catch2/catch.hpp>

using namespace ease;
using Catch::Contains;

namespace {

PassRecord ofParts(std::vector<PartPresence> parts) {
  PassRecord pass;
  pass.on_body = std::move(parts);
  return pass;
}

const DoubtContext kContext{{7, 8, 9}, 1.0};

}  // namespace

TEST_CASE("a garment on the body is in no doubt, one that left it or was never on it is, with when and how far") {
  CHECK(doubtsOf(ofParts({{0, 3, 1.0, 0.0, 0.01, {}, 0.0}}), kContext).empty());
  const auto left = doubtsOf(ofParts({{0, 3, 1.0, 0.0, 6.3, 0.46, 6.0}}), kContext);
  REQUIRE(left.size() == 1);
  CHECK_THAT(left[0], Contains("the garment left the body at 0.46 s and is 6.3 m away from it at the end"));
  const auto never = doubtsOf(ofParts({{0, 3, 1.0, 0.4, 0.41, 0.0, 0.0}}), kContext);
  REQUIRE(never.size() == 1);
  CHECK_THAT(never[0], Contains("was never on the body: 0.4 m away at its nearest"));
}

TEST_CASE("a part that falls off is named in the file's numbering, a button is lost without doubt about the rest") {
  const PassRecord pass =
      ofParts({{0, 300, 0.7, 0.0, 0.0, {}, 0.0}, {1, 100, 0.28, 0.0, 2.0, 0.3, 0.0}, {2, 8, 0.02, 0.0, 3.0, 0.1, 0.0}});
  const auto doubts = doubtsOf(pass, kContext), lost = lostParts(pass, kContext);
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("part 2 of the garment (100 vertices, vertex 8 among them, 28 % of its area) left"));
  REQUIRE(lost.size() == 1);
  CHECK_THAT(lost[0], Contains("part 3 of the garment (8 vertices, vertex 9 among them"));
}

TEST_CASE("a garment that slid down the body, or that is thrown, is in doubt") {
  CHECK_THAT(doubtsOf(ofParts({{0, 3, 1.0, 0.0, 0.0, {}, 0.6}}), kContext).at(0), Contains("slid along the body"));
  PassRecord thrown = ofParts({{0, 3, 1.0, 0.0, 0.0, {}, 0.0}});
  thrown.fastest = {40.0, 0.2, 1};
  CHECK_THAT(doubtsOf(thrown, kContext).at(0), Contains("vertex 8 of the garment was thrown: 40 m/s at 0.2 s"));
}

TEST_CASE("a run of which most time steps missed the tolerance says so") {
  PassRecord pass;
  pass.steps = 10;
  pass.substeps.time = 2;
  pass.solver.short_of_tolerance = 10;
  CHECK(missedTolerance(pass, 0.05).empty());
  pass.solver.short_of_tolerance = 11;
  CHECK_THAT(missedTolerance(pass, 0.05), Contains("11 of 20 time steps") && Contains("0.05"));
}

TEST_CASE("without a body, a part of the garment that no pin holds is told, unless nothing pulls at it") {
  Scene scene;
  SceneInput input;
  input.garment = {Positions::Random(6, 3), Triangles(2, 3)};
  input.garment.triangles << 0, 1, 2, 3, 4, 5;
  input.pins = {{0, 1}};
  CHECK_THAT(unheldParts(scene, input).at(0), Contains("vertex 3 among its vertices: it falls without end"));
  input.pins = {{0, 5}};
  CHECK(unheldParts(scene, input).empty());
  scene.solver.gravity.setZero();
  input.pins.clear();
  CHECK(unheldParts(scene, input).empty());
}

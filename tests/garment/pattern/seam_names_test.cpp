#include "garment/pattern/seam_names.h"

#include <catch2/catch.hpp>

#include <set>

#include "tests/garment/pattern/shapes.h"
#include "tests/tube.h"

using namespace ease;

namespace {

/// A tube around the wearer, who faces +z, cut at both sides and halfway up.
RestGarment cutTube() {
  RestGarment garment = restGarment(tube(24, 7, 1.0));
  for (const int side : {0, 12}) {
    Seam lower{"cut", {}, false}, upper{"cut", {}, false};
    for (int r = 0; r <= 3; ++r) lower.vertices.push_back(24 * r + side);
    for (int r = 3; r < 7; ++r) upper.vertices.push_back(24 * r + side);
    garment.seams.push_back(lower);
    garment.seams.push_back(upper);
  }
  return garment;
}

}  // namespace

TEST_CASE("found seams are named after the pieces that they join, no two alike") {
  RestGarment garment = cutTube();
  nameFoundSeams(0, {}, garment);
  std::set<std::string> names;
  for (const Seam& seam : garment.seams) names.insert(seam.name);
  CHECK(names == std::set<std::string>{"back / front, left 1", "back / front, left 2", "back / front, right 1",
                                       "back / front, right 2"});
  const auto heightOf = [&](const std::string& name) {
    for (const Seam& seam : garment.seams)
      if (seam.name == name) return garment.mesh.positions(seam.vertices[1], 1);
    return -1.0;
  };
  CHECK(heightOf("back / front, left 1") > heightOf("back / front, left 2"));
}

TEST_CASE("a found seam takes no name of one that was given, which keeps its own") {
  RestGarment garment = cutTube();
  garment.seams[0].name = "back / front, left";
  garment.seams[1].name = "given";
  nameFoundSeams(2, {{"front", {0.0, 0.5, 1.0}}}, garment);
  std::set<std::string> names;
  for (const Seam& seam : garment.seams) names.insert(seam.name);
  CHECK(names.size() == 4);
  CHECK(names.contains("given"));
  CHECK(names.contains("back / front, left"));
}

#include "garment/pattern/draw_piece.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

TEST_CASE("notches on both sides of a seam lie at the same share of its length in the garment") {
  Seam middle{"middle", {}, false};
  for (int j = 0; j <= 20; ++j) middle.vertices.push_back(21 * j + 10);
  const RestGarment sheet = restGarment(bentSheet(20, 0.6, [](double, double) { return 0.0; }), {middle});
  FlatSettings settings;
  const FlatPattern pattern = flattenGarment(sheet, settings);
  const std::vector<DrawnPiece> pieces = drawPieces(pattern, Allowances());
  // Two halves that are mirror images are drawn once.
  REQUIRE(pieces.size() == 1);
  CHECK(pieces.front().quantity == 2);
  REQUIRE(pieces.front().notches.size() == 3);  // of a seam of 60 cm
  const std::vector<Notch>& notches = pieces.front().notches;
  CHECK(std::abs(notches[0].at.y() - notches[1].at.y()) == Approx(0.25 * 600.0).margin(0.5));
  CHECK(std::abs(notches[1].at.y() - notches[2].at.y()) == Approx(0.27 * 600.0).margin(0.5));
}

TEST_CASE("a piece bears its name, how often to cut it, and a grain line along the warp within it") {
  FlatSettings settings;
  settings.names = {{"apron", Vec3::Zero()}};
  const FlatPattern pattern =
      flattenGarment(restGarment(bentSheet(6, 0.4, [](double, double) { return 0.0; })), settings);
  const DrawnPiece piece = drawPieces(pattern, Allowances()).front();
  const auto says = [&](const std::string& words) {
    return std::any_of(piece.texts.begin(), piece.texts.end(), [&](const DrawnText& t) { return t.words == words; });
  };
  CHECK(says("apron"));
  CHECK(says("piece 1 of 1"));
  CHECK(says("cut 1, this side up"));
  const auto grain = std::find_if(piece.lines.begin(), piece.lines.end(),
                                  [](const DrawnLine& line) { return line.ink == Ink::grain; });
  REQUIRE(grain != piece.lines.end());
  const Bounds bounds = boundsOf(piece.sew);
  CHECK(grain->points[0].x() == Approx(grain->points[1].x()));
  for (const PaperPoint& end : grain->points) {
    CHECK((end - bounds.lower).minCoeff() > 0.0);
    CHECK((bounds.upper - end).minCoeff() > 0.0);
  }
}

TEST_CASE("a dart bears its name beyond its tip, within the piece") {
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern pattern =
      flattenGarment(restGarment(bentSheet(8, 0.4, [](double x, double y) { return 0.8 * (x * x + y * y); }),
                                 {{"bust dart", {4, 13, 22, 31, 40}, false}}),
                     settings);
  const DrawnPiece piece = drawPieces(pattern, Allowances()).front();
  const auto name = std::find_if(piece.texts.begin(), piece.texts.end(),
                                 [](const DrawnText& text) { return text.words == "bust dart"; });
  REQUIRE(name != piece.texts.end());
  CHECK(name->in_picture);
  CHECK(piece.texts.front().words == piece.name);  // also where there are darts
  REQUIRE(piece.drills.size() == 1);
  CHECK((name->at - piece.drills.front()).norm() > 15.0);  // on the other side of the tip
  CHECK((name->at - piece.drills.front()).norm() < 32.0);
  const Bounds bounds = boundsOf(piece.sew);
  CHECK((name->at - bounds.lower).minCoeff() > 0.0);
  CHECK((bounds.upper - name->at).minCoeff() > 0.0);
}

TEST_CASE("a seam without allowance has marks where its notches would be") {
  const RestGarment sheet = restGarment(bentSheet(20, 0.6, [](double, double) { return 0.0; }), {columnSeam(20, 10)});
  Allowances none;
  none.all = 0.0;
  const DrawnPiece piece = drawPieces(flattenGarment(sheet, FlatSettings()), none).front();
  REQUIRE(piece.notches.size() == 3);
  for (const Notch& notch : piece.notches) CHECK(notch.depth >= 2.0);
}

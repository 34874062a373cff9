#include "apps/studio/pattern_sheet.h"

#include <catch2/catch.hpp>

#include <set>

#include "apps/flat_settings.h"
#include "apps/pattern_json.h"
#include "apps/pattern_pictures.h"
#include "solver/base/error.h"
#include "tests/studio/hands.h"

namespace ease {
namespace {

/// The garment's pattern as `ease pattern` writes it, of the garment as it was made.
void writePatternOf(const MadeGarment& made, const TemporaryDirectory& directory) {
  const SceneInput& input = made.input;
  const Cloth cloth(input.garment, made.scene.garment.grain, made.scene.material);
  MadePattern pattern;
  pattern.flat = flattenGarment({input.garment, cloth.restEdges(), input.seams, input.loops}, flatSettings(made.scene));
  pattern.file_vertex = pattern.flat.cut.pieces.glue;
  drawPattern(made.scene, pattern);
  directory.write("pattern.json", patternJson(made.scene, pattern));
  writeFlatMesh(pattern, directory.path / "pattern.vtp");
}

struct Sheet {
  Sheet() : hands(sewnTop()) {
    INFO(hands.studio.words());
    REQUIRE(hands.studio.made()->hasGarment());
    writePatternOf(*hands.studio.made(), hands.directory);
    sheet = readPatternSheet(hands.directory.path, hands.studio.made());
  }
  Hands hands;
  PatternSheet sheet;
};

TEST_CASE("pieces and seams on paper are found again on the garment") {
  const Sheet made;
  const PatternSheet& sheet = made.sheet;
  const SceneInput& input = made.hands.studio.made()->input;
  CHECK(sheet.pieces.size() == 2);
  std::set<int> triangles;
  for (const SheetPiece& piece : sheet.pieces) {
    CHECK(piece.grain.size() == 2);
    for (const int number : piece.numbers)
      triangles.insert(sheet.triangles[number].begin(), sheet.triangles[number].end());
  }
  CHECK(static_cast<Eigen::Index>(triangles.size()) == input.garment.triangles.rows());
  const std::vector<int>& seam = input.authored->seams.front().vertices;
  const std::set<int> on_seam(seam.begin(), seam.end());
  int sides = 0;
  for (const SheetPiece& piece : sheet.pieces)
    for (const SheetEdge& edge : piece.edges) {
      REQUIRE(edge.on_garment.size() == edge.points.size());
      if (edge.name != "left side") continue;
      ++sides;
      CHECK(edge.is_sewn);
      for (const GarmentPoint& point : edge.on_garment) CHECK(on_seam.count(point.shares.front().first) == 1);
    }
  CHECK(sides >= 2);  // an edge ends where another line does
}

TEST_CASE("a click on paper picks the line near it, else the piece around it, else nothing") {
  const Sheet made;
  const SheetPiece& piece = made.sheet.pieces.front();
  CHECK(made.sheet.at({-500, -500}, 5).what == SheetPick::What::none);
  const SheetPick whole = made.sheet.at(piece.name_at, 5);
  CHECK(whole.what == SheetPick::What::piece);
  CHECK(whole.piece == 0);
  for (const SheetEdge& edge : piece.edges) {
    const SheetPick line = made.sheet.at(edge.points[edge.points.size() / 2], 5);
    CHECK(line.line == edge.name);
    CHECK(line.is_sewn == edge.is_sewn);
    CHECK_FALSE(made.sheet.wordsOf(line).empty());
  }
  CHECK(made.sheet.wordsOf({SheetPick::What::line, 0, "left side", true}).find(" cm to sew") != std::string::npos);
}

TEST_CASE("what is picked on paper lights up on the garment, until its mesh changes") {
  Sheet made;
  Studio& studio = made.hands.studio;
  Marks piece, line, later;
  addPatternMarks(made.sheet, {SheetPick::What::piece, 0, "", false}, studio.stage, piece);
  const long lit = std::count(piece.cloth_colors.begin(), piece.cloth_colors.end(), kHoverColor);
  size_t wanted = 0;
  for (const int number : made.sheet.pieces.front().numbers) wanted += made.sheet.triangles[number].size();
  CHECK(lit == static_cast<long>(wanted));
  addPatternMarks(made.sheet, {SheetPick::What::line, 0, "left side", true}, studio.stage, line);
  REQUIRE(line.lines.size() >= 2);
  for (const Vec3& x : line.lines.front().points) CHECK(x.x() > 0.0);
  REQUIRE(studio.gesture(withExtension(studio.text(), -1, "hem", 0.1, 1.0), "extension"));
  studio.finishWork();
  addPatternMarks(made.sheet, {SheetPick::What::piece, 0, "", false}, studio.stage, later);
  CHECK(later.cloth_colors.empty());
}

TEST_CASE("a pattern that is missing, damaged or of another garment is refused") {
  const Sheet made;
  const TemporaryDirectory& directory = made.hands.directory;
  CHECK_THROWS_AS(readPatternSheet(directory.path / "nowhere", made.hands.studio.made()), InputError);
  auto smaller = std::make_shared<MadeGarment>(*made.hands.studio.made());
  smaller->input.garment.positions.conservativeResize(10, 3);
  CHECK_THROWS_AS(readPatternSheet(directory.path, smaller), InputError);
  directory.write("pattern.json", "{\"outlines\": [{}]}");
  CHECK_THROWS_AS(readPatternSheet(directory.path, made.hands.studio.made()), InputError);
}

}  // namespace
}  // namespace ease

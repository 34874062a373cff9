#include "garment/pattern/piece_names.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"
#include "tests/garment/pattern/shapes.h"
#include "tests/tube.h"

using namespace ease;

namespace {

/// A tube with seams at both sides of the wearer, who faces +z.
struct Tube {
  TriangleMesh mesh = tube(24, 6, 1.0);
  CutGarment cut;
  Tube() {
    Seam left{"left side", {}, false}, right{"right side", {}, false};
    for (int r = 0; r < 6; ++r) {
      left.vertices.push_back(24 * r);
      right.vertices.push_back(24 * r + 12);
    }
    cut = cutGarment(mesh, {{left, LineKind::seam}, {right, LineKind::seam}}, {});
  }
};

}  // namespace

TEST_CASE("pieces between side seams are front and back") {
  const Tube made;
  std::vector<std::string> names = pieceNames(made.cut, made.mesh, {});
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"back", "front"});
}

TEST_CASE("a name is given to the piece nearest to a point, once") {
  const Tube made;
  const std::vector<std::string> names = pieceNames(made.cut, made.mesh, {{"apron", {0.0, 0.5, 1.0}}});
  CHECK(std::count(names.begin(), names.end(), "apron") == 1);
  CHECK(std::count(names.begin(), names.end(), "back") == 1);
  CHECK_THROWS_AS(pieceNames(made.cut, made.mesh, {{"a", {0.0, 0.5, 1.0}}, {"b", {0.1, 0.5, 1.0}}}), InputError);
  CHECK_THROWS_WITH(pieceNames(made.cut, made.mesh, {{"a", {0.0, 5.0, 0.0}}}), Catch::Contains("m from the garment"));
}

TEST_CASE("a name that was given stays as it is, and the program's own gives way") {
  const Tube made;
  const std::vector<std::string> names = pieceNames(made.cut, made.mesh, {{"back", {0.0, 0.5, 1.0}}});
  CHECK(std::count(names.begin(), names.end(), "back") == 1);
  CHECK(std::count(names.begin(), names.end(), "back 1") == 1);
  const std::vector<char> backs = backPieces(made.cut, made.mesh);
  for (size_t p = 0; p < names.size(); ++p) CHECK((backs[p] != 0) == (names[p] == "back 1"));
}

TEST_CASE("a piece across the middle is neither left nor right") {
  const TriangleMesh sheet = bentSheet(20, 0.6, [](double, double) { return 0.0; });  // y upwards, facing +z
  Seam across{"across", {}, false}, down{"down", {}, false};
  for (int i = 0; i <= 20; ++i) across.vertices.push_back(21 * 10 + i);
  for (int j = 0; j <= 10; ++j) down.vertices.push_back(21 * j + 10);
  const CutGarment cut = cutGarment(sheet, {{across, LineKind::seam}, {down, LineKind::seam}}, {});
  std::vector<std::string> names = pieceNames(cut, sheet, {});
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"front", "left front", "right front"});
}

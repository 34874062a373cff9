#include "garment/pattern/dart_ways.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/garment/pattern/shapes.h"

using namespace ease;

namespace {

/// A flat square of 8 x 8 cells of 5 cm; vertex 40 is its middle.
PieceMesh square() {
  const RestGarment sheet = restGarment(bentSheet(8, 0.4, [](double, double) { return 0.0; }));
  return {sheet.mesh, sheet.rest_edges, {}, sheet.mesh.positions, {}};
}

}  // namespace

TEST_CASE("ways from the outline are as long as the edges to the nearest side") {
  const PieceMesh part = square();
  const PartEdges edges(part);
  const Ways ways = edges.waysFrom(edges.isOutline(), edges.isOutline());
  CHECK(ways.length[40] == Approx(0.2));
  CHECK(ways.length[0] == 0.0);
  const std::vector<int> way = ways.to(40);
  CHECK(way.size() == 5);
  CHECK(way.back() == 40);
  CHECK(edges.isOutline()[way.front()]);
}

TEST_CASE("the straight way stays nearer to the line between its ends than the shortest one along edges") {
  PieceMesh part = square();
  const PartEdges edges(part);
  std::vector<char> none(part.mesh.positions.rows(), 0), start = none;
  const int from = 3, to = 3 + 9 * 6 + 3;  // 6 cells up, 3 to the right
  start[from] = 1;
  const auto furthest = [&](const std::vector<int>& way) {
    const Eigen::Vector2d a = part.x.row(from).head<2>(), along = Eigen::Vector2d(1.0, 2.0).normalized();
    double worst = 0.0;
    for (const int v : way) {
      const Eigen::Vector2d c = part.x.row(v).head<2>().transpose() - a;
      worst = std::max(worst, std::abs(along.x() * c.y() - along.y() * c.x()));
    }
    return worst;
  };
  const std::vector<int> way = edges.straightWay(from, to, part.x, none);
  REQUIRE(way.front() == from);
  REQUIRE(way.back() == to);
  CHECK(furthest(way) < 0.03);
  CHECK(furthest(way) <= furthest(edges.waysFrom(start, none).to(to)));
  std::vector<char> wall = none;
  for (int i = 0; i < 9; ++i) wall[36 + i] = 1;
  CHECK(edges.straightWay(from, to, part.x, wall).empty());
}

TEST_CASE("no way leads through blocked vertices") {
  const PieceMesh part = square();
  const PartEdges edges(part);
  std::vector<char> blocked = edges.isOutline();
  for (const int v : {30, 31, 32, 39, 41, 48, 49, 50}) blocked[v] = 1;
  CHECK(std::isinf(edges.waysFrom(edges.isOutline(), blocked).length[40]));
}

TEST_CASE("tips are spread: the first furthest from the outline, none nearer to it than a dart is long") {
  const PieceMesh part = square();
  const PartEdges edges(part);
  const Ways ways = edges.waysFrom(edges.isOutline(), edges.isOutline());
  const std::vector<int> tips = spreadTips(ways, part.x, 5);
  REQUIRE(tips.size() == 5);
  CHECK(tips.front() == 40);
  for (size_t i = 0; i < tips.size(); ++i) {
    CHECK(ways.length[tips[i]] >= kMinDartLength);
    for (size_t j = 0; j < i; ++j) CHECK((part.x.row(tips[i]) - part.x.row(tips[j])).norm() > 0.15);
  }
}

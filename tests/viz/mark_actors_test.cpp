#include "viz/mark_actors.h"

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("lines of one width are one actor, and all dots another") {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const auto actors = markActors({{points, false, {1, 2, 3}, 3.0},
                                  {points, true, {4, 5, 6}, 3.0},
                                  {{{0, 0, 0}}, false, {0, 0, 0}, 3.0},  // a point is no line
                                  {points, false, {7, 8, 9}, 5.0}},
                                 {{{0, 0, 1}, {1, 1, 1}}, {{0, 1, 1}, {2, 2, 2}}});
  REQUIRE(actors.size() == 3);
  const auto cells = [&](size_t i) {
    return vtkPolyDataMapper::SafeDownCast(actors[i]->GetMapper())->GetInput()->GetNumberOfCells();
  };
  CHECK(cells(0) == 2);
  CHECK(cells(1) == 1);
  CHECK(cells(2) == 2);
  CHECK(actors[0]->GetProperty()->GetLineWidth() == 3.0F);
  CHECK(actors[1]->GetProperty()->GetLineWidth() == 5.0F);
  CHECK(markActors({}, {}).empty());
}

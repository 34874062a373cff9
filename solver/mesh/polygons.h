// Polygons as mesh files hold them, and how they are cut into triangles.
//
// A polygon of n corners becomes n - 2 triangles that face the way it faces, also where it is concave or has corners in
// a line. How it is cut is told by the places of its corners in the list of all corners, so that all poses of one body
// can be cut as the first one was.
#pragma once

#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct Polygons {
  Positions points;          // in the file's unit (readPolygons())
  std::vector<int> corners;  // vertices of the first polygon, then of the second, ...
  std::vector<int> ends;     // place in `corners` behind the last corner of each polygon
};

/// Cuts every polygon: row by row three places in `corners`. Ears are clipped (Meisters 1975), the one with the best
/// shape first. Throws InputError, naming `name` and the polygon, where one crosses itself, has no area, or has more
/// than 5,000 corners.
Triangles cutPolygons(const Polygons& polygons, const std::string& name);

/// The triangles of polygons that are cut so.
Triangles trianglesOf(const Polygons& polygons, const Triangles& cut);

}  // namespace ease

#include "apps/page/garment_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "garment/named_loop.h"
#include "garment/pattern/piece_names.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"

namespace ease {

namespace {

constexpr double kMiddle = 0.03;  // m: nearer to x = 0 a place is in the middle

Vec3 centroid(const TriangleMesh& mesh, int t) {
  const auto corners = mesh.triangles.row(t);
  return (mesh.positions.row(corners[0]) + mesh.positions.row(corners[1]) + mesh.positions.row(corners[2]))
             .transpose() /
         3.0;
}

bool facesFront(const TriangleMesh& mesh, int t) {
  const auto v = mesh.triangles.row(t);
  return doubleAreaNormal(mesh.positions.row(v[0]), mesh.positions.row(v[1]), mesh.positions.row(v[2])).z() >= 0.0;
}

/// Distance from x to the nearest of these vertices, m.
double distanceTo(const std::vector<int>& vertices, const Positions& positions, const Vec3& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int v : vertices) nearest = std::min(nearest, (positions.row(v).transpose() - x).norm());
  return nearest;
}

GarmentAreas piecesOf(const Scene& scene, const SceneInput& input, const std::vector<NamedLoop>& loops) {
  std::vector<CutLine> lines;
  for (const Seam& seam : input.seams) lines.push_back({seam, LineKind::seam});
  const CutGarment cut = cutGarment(input.garment, lines, loops);
  return {cut.pieces.piece, pieceNames(cut, input.garment, scene.pattern.names), loops};
}

GarmentAreas sidesOf(const TriangleMesh& mesh, const std::vector<NamedLoop>& loops) {
  GarmentAreas areas{{}, {}, loops};
  std::map<std::string, int> numbers;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 x = centroid(mesh, t);
    const std::string side = facesFront(mesh, t) ? "front" : "back";
    std::string name = side;
    double nearest = std::numeric_limits<double>::infinity();
    for (const NamedLoop& loop : loops) {
      const double distance = distanceTo(loop.vertices, mesh.positions, x);
      if (distance >= nearest) continue;
      nearest = distance;
      const bool on_middle = loop.name == "neck" || loop.name == "hem";
      name = on_middle ? side : "at " + loop.name;
    }
    areas.of_triangle.push_back(numbers.emplace(name, static_cast<int>(numbers.size())).first->second);
    if (numbers.size() > areas.names.size()) areas.names.push_back(name);
  }
  return areas;
}

}  // namespace

std::vector<NamedLoop> loopsOf(const SceneInput& input) {
  if (!input.loops.empty()) return input.loops;
  return nameLoops(buildTopology(input.garment, "garment"), input.garment.positions);
}

GarmentAreas garmentAreas(const Scene& scene, const SceneInput& input) {
  const std::vector<NamedLoop> loops = loopsOf(input);
  if (input.seams.empty()) return sidesOf(input.garment, loops);
  try {
    return piecesOf(scene, input, loops);
  } catch (const InputError&) {  // the seams leave a piece with a hole: a pattern would cut it open
    return sidesOf(input.garment, loops);
  }
}

std::string placeInWords(const GarmentAreas& areas, const SceneInput& input, int triangle) {
  const Vec3 x = centroid(input.garment, triangle);
  std::string place = areas.names[areas.of_triangle[triangle]];
  if (place.find("front") == std::string::npos && place.find("back") == std::string::npos)
    place += facesFront(input.garment, triangle) ? ", in front" : ", at the back";
  if (std::abs(x.x()) > kMiddle && place.find("left") == std::string::npos && place.find("right") == std::string::npos)
    place += x.x() > 0.0 ? ", on the left" : ", on the right";
  double nearest = std::numeric_limits<double>::infinity();
  std::string line;
  const auto look = [&](const std::string& what, const std::vector<int>& vertices) {
    const double distance = distanceTo(vertices, input.garment.positions, x);
    if (distance >= nearest) return;
    nearest = distance;
    line = what;
  };
  for (const NamedLoop& loop : areas.loops) look("the edge '" + loop.name + "'", loop.vertices);
  for (const Seam& seam : input.seams) look("the seam '" + seam.name + "'", seam.vertices);
  return line.empty() ? place : fmt::format("{}, {:.0f} cm from {}", place, 100.0 * nearest, line);
}

}  // namespace ease

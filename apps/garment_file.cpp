#include "apps/garment_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "adaption/presence.h"
#include "apps/weld_warnings.h"
#include "apps/words.h"
#include "solver/io/mesh_io.h"
#include "solver/mesh/weld.h"

namespace ease {

std::string readGarmentFile(const Scene& scene, const Warn& warn, SceneInput& input) {
  const std::filesystem::path path = (scene.file.parent_path() / scene.garment.mesh).lexically_normal();
  const std::string name = path.string();
  if (!std::filesystem::exists(path))
    throw InputError(
        fmt::format("{}: [garment] mesh = '{}': no such file: {}", scene.file.string(), scene.garment.mesh, name));
  Polygons polygons = readPolygons(path);
  toMetres(scene.garment.frame, polygons.points);
  const Triangles triangles = trianglesOf(polygons, cutPolygons(polygons, name));
  const Weld weld = findWeld(triangles, {&polygons.points, 1}, scene.garment.weld || sharesNoVertices(path));
  input.garment = {welded(polygons.points, weld), welded(triangles, weld)};
  warnOfWeld(weld, name, "garment", warn);
  if (sharesNoVertices(path) || weld.changesNothing()) return name;
  input.as_read = GarmentAsRead{{std::move(polygons.points), triangles}, weld.vertex};
  return name;
}

GarmentParts partsOf(const TriangleMesh& garment) {
  std::vector<double> areas(garment.triangles.rows());
  for (size_t t = 0; t < areas.size(); ++t)
    areas[t] = triangleArea(garment.positions, garment.triangles, static_cast<int>(t));
  GarmentParts parts{connectedParts(garment.triangles, areas, static_cast<int>(garment.positions.rows())), {}};
  parts.vertices.assign(*std::max_element(parts.of_vertex.begin(), parts.of_vertex.end()) + 1, 0);
  for (const int part : parts.of_vertex) ++parts.vertices[part];
  return parts;
}

void tellParts(const TriangleMesh& garment, const std::string& name, const Warn& warn) {
  const GarmentParts parts = partsOf(garment);
  if (parts.vertices.size() < 2) return;
  const size_t shown = std::min<size_t>(parts.vertices.size(), 6);
  warn(fmt::format(
      "{}: {} parts that nothing joins, of {}{} vertices: each moves by itself; join them, or leave out what "
      "is not sewn on",
      name, parts.vertices.size(),
      fmt::join(parts.vertices.begin(), parts.vertices.begin() + static_cast<long>(shown), ", "),
      shown < parts.vertices.size() ? ", ..." : ""));
}

}  // namespace ease

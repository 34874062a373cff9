#include "apps/rest_shape_files.h"

#include <numeric>

#include "adaption/stitch.h"
#include "adaption/stretch_measure.h"
#include "apps/frames.h"
#include "apps/garment_files.h"
#include "solver/io/mesh_io.h"
#include "viz/vtp.h"

namespace ease {

namespace {

std::vector<double> firstAreas(const Cloth& cloth) {
  std::vector<double> areas;
  for (const Mat2& edges : cloth.first().edges) areas.push_back(0.5 * edges.determinant());
  return areas;
}

double sum(const std::vector<double>& areas) {
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

RestGrowth growthOf(const Cloth& cloth) {
  std::vector<double> growth(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat2 map = cloth.restEdges()[t] * cloth.first().edges[t].inverse();
    growth[t] = principalStretch(map.transpose() * map).sigma_1;
  }
  const StretchStatistics statistics = stretchStatistics(growth, 0.0);
  return {statistics.max, statistics.p99, sum(cloth.restAreas()) / sum(firstAreas(cloth))};
}

}  // namespace

RestShapeFigures writeRestShape(const Cloth& cloth, const SceneInput& given, const Numbering& numbering,
                                const std::filesystem::path& directory) {
  const Frame rest = restored(restFrame(cloth, firstAreas(cloth)), numbering);
  const Frame as_read = asRead(rest, given.as_read);
  writeObj(directory / "rest_shape.obj", {as_read.positions, trianglesAsRead(given)});
  writeVtp(directory / "rest_shape.vtp", trianglesAsRead(given), as_read);
  if (!given.seams.empty()) {
    std::vector<int> vertices(given.garment.positions.rows());
    std::iota(vertices.begin(), vertices.end(), 0);
    writePieces({rest.positions, given.garment.triangles}, given.seams, directory, "rest_pieces",
                verticesAsRead(given, vertices));
  }
  return {growthOf(cloth), foldedEdges(cloth, cloth.first().positions)};
}

}  // namespace ease
